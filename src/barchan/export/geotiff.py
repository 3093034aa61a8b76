"""GeoTIFF, cloud-optimised: one frame, a field a band, north up."""

from pathlib import Path
from typing import Any

import numpy as np

from barchan.export.numbers import floats
from barchan.export.source import Source


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write a frame as 32-bit floats; without a reference system the file places its cells all the same."""
    import rasterio
    from rasterio._err import CPLE_BaseError
    from rasterio.crs import CRS
    from rasterio.transform import Affine

    grid, (step,) = source.grid, source.steps
    sheets = source.sheets(step)
    profile = {
        "driver": "COG",
        "height": grid.rows,
        "width": grid.columns,
        "count": len(sheets),
        "dtype": "float32",
        "nodata": np.nan,
        "crs": None if grid.wkt is None else CRS.from_wkt(grid.wkt),
        "transform": Affine(grid.width, 0.0, grid.west, 0.0, -grid.height, grid.north),
        "compress": "deflate",
        "level": 3,
        "predictor": "yes",
        "blocksize": 256,
        "overview_resampling": "average",
    }
    try:
        with rasterio.open(path, "w", **profile) as file:
            for band, sheet in enumerate(sheets.values(), 1):
                file.write(floats(sheet.values[::-1]), band)
                file.set_band_description(band, sheet.name)
                file.set_band_unit(band, sheet.unit)
                file.update_tags(band, long_name=sheet.meaning)
            seconds = source.seconds(step)
            file.update_tags(step=step, **({} if seconds is None else {"seconds": seconds}))
    except CPLE_BaseError as error:
        raise OSError(str(error)) from error
    return {"bands": [sheet.name for sheet in sheets.values()], "first_row": "north"}
