"""Messages and frames between browser, server and workers.

Control messages are JSON objects: a request names its ``command`` (see ``commands``), a message from the
server its ``type``. A request with an ``id`` is answered by a message with the same ``id``.
Frames are binary: ``MAGIC``, the length of a JSON header (32 bits, little-endian), the header padded to four
bytes, then the numbers of the fields that it lists as ``encoded``, each padded likewise.
"""

import json
import math
import struct
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.errors import BarchanError

PROTOCOL = 6
"""Version of the messages; client and server of different versions do not talk."""

MESSAGES = {
    "hello": "Versions of messages and of Barchan, names of the runs, and whether they run in lockstep.",
    "runs": "The names of the runs have changed.",
    "lockstep": "Two runs that are compared started or stopped.",
    "scenario": "What a run consists of: scenario, lattice, fields, measures, branches.",
    "begun": "A run has begun, or its start was refused; only for the server.",
    "compiling": "Kernels are being compiled, and how many functions of theirs have been.",
    "arrived": "A run has done the steps that it was asked for.",
    "watchers": "How many browsers watch; only for the one that commands.",
    "look": "How the browser that commands shows the surface; only for those that watch.",
    "lost": "The process of a run has ended by itself; the newest step that all runs can continue from.",
    "progress": "How far the answer to a request is.",
    "done": "The answer to a request.",
    "refused": "A request that cannot be carried out, and why.",
}
"""Types of the messages that the browser gets, and their meanings."""

MAGIC = b"BRCH"

STATE_MAGIC = b"BRST"
"""How the complete state of a run begins, by which a worker and the server save it from a loss."""

STATE_HEAD = "<qq"
"""What follows it: the number of the start that the run goes back to, and the step."""

LARGEST_MESSAGE = 1 << 20
"""Bytes of a control message that the server takes."""

FRAMES_IN_FLIGHT = 2
"""Frames that may be on their way to a browser that has not confirmed them."""

ANSWERED = (BarchanError, OSError, LookupError, TypeError, ValueError, ArithmeticError, MemoryError)
"""Errors of a request that are answered: whatever a request holds, it ends neither server nor worker."""

Request = dict[str, Any]
"""A request as it arrives: ``command``, perhaps ``id`` and ``run``, and the command's own keys."""


@dataclass(frozen=True)
class EncodedField:
    """One field of a frame: whole numbers that become values as ``offset + scale * number``."""

    name: str
    numbers: NDArray
    scale: float = 1.0
    offset: float = 0.0

    def header(self) -> dict[str, Any]:
        """The keys by which the browser reads the numbers."""
        return {
            "name": self.name,
            "dtype": self.numbers.dtype.name,
            "scale": self.scale,
            "offset": self.offset,
        }


def read_request(text: str | bytes) -> Request:
    """The request in a message.

    Raises BarchanError where it is no object of JSON, or holds a number that is not finite: JSON has none,
    and a digit too many in an exponent must not become one.
    """
    try:
        data = json.loads(text, parse_constant=_finite, parse_float=_finite)
    except (ValueError, RecursionError) as error:
        raise BarchanError(f"a message that cannot be read: {error}") from None
    if not isinstance(data, dict):
        raise BarchanError("a message must be an object that names a command")
    return data


def _finite(text: str) -> float:
    number = float(text)
    if not math.isfinite(number):
        raise BarchanError(f"a message holds the number {text}; allowed: finite numbers")
    return number


def message(kind: str, **content: Any) -> bytes:
    """A control message of one of the ``MESSAGES``; raises KeyError for any other."""
    MESSAGES[kind]
    return _json({"type": kind, **content})


def frame(header: dict[str, Any], fields: Sequence[EncodedField]) -> bytes:
    """A frame."""
    numbers = [np.ascontiguousarray(field.numbers) for field in fields]
    padded = [part for one in numbers for part in (one.data, padding(one.nbytes))]
    return packed_frame(header, [field.header() for field in fields], padded)


def packed_frame(header: dict[str, Any], encoded: list[dict[str, Any]], numbers: Sequence[Any]) -> bytes:
    """A frame of the heads of its fields and of their numbers as bytes, filled up by ``padding``."""
    text = _json({**header, "encoded": encoded})
    return b"".join((MAGIC, struct.pack("<I", len(text)), text, padding(len(text)), *numbers))


def is_state(data: bytes) -> bool:
    """Whether data are the complete state of a run; see ``STATE_MAGIC``."""
    return data.startswith(STATE_MAGIC)


def state_head(data: bytes) -> tuple[int, int]:
    """The number of the start that a run goes back to, and the step of its state."""
    number, step = struct.unpack_from(STATE_HEAD, data, len(STATE_MAGIC))
    return number, step


def numbered(data: bytes, number: int) -> bytes:
    """The state of a run, for the start of that number."""
    _, step = state_head(data)
    head = len(STATE_MAGIC) + struct.calcsize(STATE_HEAD)
    return STATE_MAGIC + struct.pack(STATE_HEAD, number, step) + data[head:]


def is_frame(data: bytes) -> bool:
    """Whether data are a frame; if not they are a control message."""
    return data.startswith(MAGIC)


def fields_in(data: bytes) -> list[str]:
    """Names of the fields that a frame holds."""
    (length,) = struct.unpack_from("<I", data, len(MAGIC))
    begin = len(MAGIC) + 4
    return [field["name"] for field in json.loads(data[begin : begin + length])["encoded"]]


def padding(length: int) -> bytes:
    """Bytes that fill up to a multiple of four, as browsers need for arrays of numbers."""
    return b"\0" * (-length % 4)


def _json(content: dict[str, Any]) -> bytes:
    return json.dumps(content, separators=(",", ":"), ensure_ascii=False, allow_nan=False).encode()
