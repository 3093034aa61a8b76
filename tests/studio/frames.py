"""Frames read as the browser reads them."""

import json
import struct

import numpy as np

from barchan.studio.protocol import MAGIC, padding


def read_frame(data: bytes):
    """The header of a frame, and its fields' values as flat arrays."""
    (length,) = struct.unpack_from("<I", data, len(MAGIC))
    at = len(MAGIC) + 4
    header = json.loads(data[at : at + length])
    at += length + len(padding(length))
    fields = {}
    count = header["rows"] * header["columns"]
    for field in header["encoded"]:
        numbers = np.frombuffer(data, field["dtype"], count, at)
        at += numbers.nbytes + len(padding(numbers.nbytes))
        fields[field["name"]] = field["offset"] + field["scale"] * numbers.astype(np.float64)
    return header, fields
