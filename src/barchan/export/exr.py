"""OpenEXR of 32-bit floats: one frame, a field a channel."""

from pathlib import Path
from typing import Any

from barchan.export.numbers import first_row, floats, northern_first
from barchan.export.source import Source


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write fields in their own units; a single one is the channel ``Y``, as grey pictures have it."""
    import OpenEXR

    sheets = source.sheets(source.steps[0])
    names = {name: "Y" if len(sheets) == 1 else name for name in sheets}
    channels = {names[name]: northern_first(source, floats(sheet.values)) for name, sheet in sheets.items()}
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    try:
        with OpenEXR.File(header, channels) as file:
            file.write(str(path))
        OpenEXR.File(str(path)).channels()  # the library is silent where a disk is full: read it back
    except RuntimeError as error:
        raise OSError(str(error)) from error
    return {"first_row": first_row(source), "numbers": "32-bit floats", "channels": names}
