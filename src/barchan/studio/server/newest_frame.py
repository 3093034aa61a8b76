"""The newest frame of a run, whole: frames leave out what earlier ones have shown, and not all saw them."""

import json
import struct
from dataclasses import dataclass
from typing import Any

from barchan.studio.protocol import MAGIC, packed_frame, padding

SURFACE = ("ground", "depth")
"""Fields that every browser needs; the others are those that a frame names as ``shown``."""

HEAD = len(MAGIC) + 4
"""Bytes before the header."""

SIZES = {"uint8": 1, "uint16": 2, "int32": 4, "float32": 4}
"""Bytes of a number of each type that fields have."""

PARTS = ("history", "paths")
"""Keys of the header that a frame holds only where they have changed."""


@dataclass(frozen=True)
class _Part:
    """Something that frames hold now and then, and the number of the frame that held it last."""

    number: int
    head: Any
    data: bytes = b""


class NewestFrame:
    """What the frames of one run have shown up to now; frames are counted from 1 on.

    A frame that replaces all measures belongs to another run, or another branch, and comes with everything.
    """

    def __init__(self) -> None:
        """No frame yet."""
        self.number = 0
        self._data = b""
        self._header: dict[str, Any] = {}
        self._fields: dict[str, _Part] = {}
        self._parts: dict[str, _Part] = {}
        self._rows: dict[int, _Part] = {}
        self._replaced = 0

    def take(self, data: bytes) -> None:
        """Take the next frame."""
        self.number += 1
        self._data = data
        (length,) = struct.unpack_from("<I", data, len(MAGIC))
        header = json.loads(data[HEAD : HEAD + length])
        shape = header["rows"], header["columns"]
        if header.get("measures_replaced"):  # of another run, or of another past of this one
            self._fields.clear()
            self._parts.clear()
            self._rows.clear()
            self._replaced = self.number
        self._take_fields(header, shape[0] * shape[1], HEAD + length + len(padding(length)))
        for key in PARTS:
            if key in header:
                self._parts[key] = _Part(self.number, header.pop(key))
        self._take_rows(header)
        self._header = header

    def _take_fields(self, header: dict[str, Any], cells: int, at: int) -> None:
        for head in header.pop("encoded"):
            size = cells * SIZES[head["dtype"]]
            size += len(padding(size))
            self._fields[head["name"]] = _Part(self.number, head, self._data[at : at + size])
            at += size
        wanted = {*SURFACE, *header["shown"]}
        self._fields = {name: part for name, part in self._fields.items() if name in wanted}

    def _take_rows(self, header: dict[str, Any]) -> None:
        header.pop("measures_replaced", None)
        for row in header.pop("measures", ()):
            self._rows[row["step"]] = _Part(self.number, row)

    def since(self, number: int) -> bytes:
        """A frame for a browser that has all frames up to a number; 0 where it has none."""
        if number == self.number - 1:
            return self._data
        header = dict(self._header)
        header |= {key: part.head for key, part in self._parts.items() if part.number > number}
        rows = [part.head for part in self._rows.values() if part.number > number]
        if self._replaced > number:
            header["measures_replaced"] = True
        if rows or self._replaced > number:
            header["measures"] = rows
        fields = [part for part in self._fields.values() if part.number > number]
        return packed_frame(header, [part.head for part in fields], [part.data for part in fields])
