"""What an uploaded file of heights holds, as far as the browser needs it to use the file as ground."""

from pathlib import Path
from typing import Any

from barchan.ground.fitting import doubtful
from barchan.ground.raster import Raster, UnreadableError
from barchan.ground.reading import read


def heights_in(path: Path) -> dict[str, Any] | None:
    """Rows, columns, cell size (m, where it has one) and undeclared codes for missing cells.

    None where the file holds no heights, or holds them in a way that is refused with the reason later.
    """
    try:
        raster = read(path)
    except UnreadableError:
        return None
    rows, columns = raster.values.shape
    codes = [] if raster.full_scale is not None else [value for value, _ in doubtful(raster, _cell(raster))]
    return {
        "rows": rows,
        "columns": columns,
        "cell_size": None if raster.place is None else raster.place.cell_size,
        "codes": codes,
    }


def _cell(raster: Raster) -> float:
    return 1.0 if raster.place is None else raster.place.cell_size
