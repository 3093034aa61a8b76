"""What server, workers and browser say to each other.

Control messages are JSON objects: what a client wants is named by ``do``, what it is told by ``tell``.
Frames are binary: ``MAGIC``, the length of a JSON header (32 bits, little-endian), the header padded to four
bytes, then the planes that it lists, each padded likewise.
"""

import json
import struct
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

PROTOCOL = 2
"""Version of the messages; client and server of different versions do not talk."""

MAGIC = b"BRCH"

LARGEST_MESSAGE = 1 << 20
"""Bytes of a control message that the server takes."""

FRAMES_IN_FLIGHT = 2
"""Frames that may be on their way to a browser that has not confirmed them."""


@dataclass(frozen=True)
class Plane:
    """One field of a frame: whole numbers that become values as ``offset + scale * number``."""

    name: str
    numbers: NDArray
    scale: float = 1.0
    offset: float = 0.0

    def header(self) -> dict[str, Any]:
        """What the browser must know to read the plane."""
        return {
            "name": self.name,
            "dtype": self.numbers.dtype.name,
            "scale": self.scale,
            "offset": self.offset,
        }


def message(**content: Any) -> bytes:
    """A control message."""
    return json.dumps(content, separators=(",", ":"), ensure_ascii=False, allow_nan=False).encode()


def frame(header: dict[str, Any], planes: Sequence[Plane]) -> bytes:
    """A frame."""
    text = message(**header, planes=[plane.header() for plane in planes])
    parts: list[Any] = [MAGIC, struct.pack("<I", len(text)), text, _padding(len(text))]
    for plane in planes:
        numbers = np.ascontiguousarray(plane.numbers)
        parts += [numbers.data, _padding(numbers.nbytes)]
    return b"".join(parts)


def read_frame(data: bytes) -> tuple[dict[str, Any], dict[str, NDArray[np.float64]]]:
    """The header of a frame, and its fields' values as flat arrays."""
    (length,) = struct.unpack_from("<I", data, len(MAGIC))
    at = len(MAGIC) + 4
    header: dict[str, Any] = json.loads(data[at : at + length])
    at += length + len(_padding(length))
    fields = {}
    count = header["rows"] * header["columns"]
    for plane in header["planes"]:
        numbers = np.frombuffer(data, plane["dtype"], count, at)
        at += numbers.nbytes + len(_padding(numbers.nbytes))
        fields[plane["name"]] = plane["offset"] + plane["scale"] * numbers.astype(np.float64)
    return header, fields


def is_frame(data: bytes) -> bool:
    """Whether data are a frame; if not they are a control message."""
    return data.startswith(MAGIC)


def _padding(length: int) -> bytes:
    return b"\0" * (-length % 4)
