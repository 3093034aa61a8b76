"""OpenEXR of 32-bit floats: one field of one frame."""

from pathlib import Path
from typing import Any

from barchan.export.numbers import first_row, floats, northern_first
from barchan.export.source import Source

CHANNEL = "Y"
"""The channel of grey pictures; Blender reads no channel by another name of ours."""


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write a field in its own unit."""
    import OpenEXR

    channels = {CHANNEL: northern_first(source, floats(source.sheet().values))}
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    try:
        with OpenEXR.File(header, channels) as file:
            file.write(str(path))
        OpenEXR.File(str(path)).channels()  # the library is silent where a disk is full: read it back
    except RuntimeError as error:
        raise OSError(str(error)) from error
    return {"first_row": first_row(source), "numbers": "32-bit floats", "channel": CHANNEL}
