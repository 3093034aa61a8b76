"""What an uploaded file holds, as far as the page needs it to use the file as ground or as wind."""

from contextlib import suppress
from pathlib import Path
from typing import Any

from barchan.errors import ScenarioError
from barchan.ground.fitting import doubtful, raster_in
from barchan.ground.raster import Hints, Raster, UnreadableError
from barchan.ground.reading import READERS
from barchan.wind.recorded import Recorded


def file_content(path: Path) -> dict[str, Any]:
    """Heights, and where there are none whether it is a record of winds; read as a scenario would read it.

    What cannot be read is refused with the reason by the command that uses it.
    """
    heights = heights_in(path) if path.suffix.lower() in READERS else None
    record = False
    if heights is None:
        with suppress(ScenarioError):
            Recorded(path=str(path)).series()
            record = True
    return {"heights": heights, "record": record}


def heights_in(path: Path) -> dict[str, Any] | None:
    """Rows, columns, cell size (m, where it has one), undeclared codes for missing cells, whether in colour.

    None where the file holds no heights, or holds them in a way that is refused with the reason later.
    """
    try:
        raster = raster_in(path, Hints())
    except UnreadableError:
        return None
    rows, columns = raster.values.shape
    codes = [] if raster.full_scale is not None else [value for value, _ in doubtful(raster, _cell(raster))]
    return {
        "rows": rows,
        "columns": columns,
        "cell_size": None if raster.place is None else raster.place.cell_size,
        "codes": codes,
        "coloured": raster.coloured,
    }


def _cell(raster: Raster) -> float:
    return 1.0 if raster.place is None else raster.place.cell_size
