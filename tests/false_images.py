"""Images of a few bytes that claim any size."""

import struct
import zlib


def false_png(columns, rows):
    """A PNG of a few bytes whose heading claims a size in greys of 8 bits."""

    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    heading = struct.pack(">IIBBBBB", columns, rows, 8, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", heading) + chunk(b"IDAT", b"") + chunk(b"IEND", b"")


def false_jpeg(columns, rows):
    """A JPEG that ends after a heading (SOF0, then SOS) that claims a size."""
    frame = struct.pack(">BHHB3B", 8, rows, columns, 1, 1, 0x11, 0)
    scan = bytes([1, 1, 0, 0, 63, 0])
    parts = [(0xC0, frame), (0xDA, scan)]
    return (
        b"\xff\xd8" + b"".join(struct.pack(">BBH", 0xFF, m, len(d) + 2) + d for m, d in parts) + b"\xff\xd9"
    )
