"""Elevation models that GDAL reads: GeoTIFF, and tiles of SRTM heights (.hgt)."""

import re
import warnings
from pathlib import Path
from typing import Any

import numpy as np

from barchan.ground.raster import Hints, Raster, UnreadableError, placed, refuse_many_cells
from barchan.ground.reference import METRES, MISSING_EXTRA, stated
from barchan.ground.units import metres_in

_VERTICAL = re.compile(r'VERT_CS\[.*?UNIT\["([^"]+)",([0-9.eE+-]+)', re.DOTALL)


def read_elevation_model(path: Path, hints: Hints) -> Raster:
    """The one band of an elevation model; raises UnreadableError where it has none, or no metres."""
    with _opened(path) as source:
        if source.count != 1:
            raise UnreadableError(f"has {source.count} bands; allowed: one, of elevations")
        refuse_many_cells(source.height, source.width)
        crs = stated(source.crs, hints)
        if crs is None and hints.crs != METRES:
            raise UnreadableError(
                "has no coordinate reference system; allowed: a projected one in metres, stated by the file "
                f"or by crs, for instance 'EPSG:32633', or crs '{METRES}' for local coordinates"
            )
        values = source.read(1, masked=True)
        if np.ma.is_masked(values):
            values = np.ma.filled(values.astype(np.float64), np.nan)
        values = np.asarray(values)
        scale, unit = _vertical(source, crs)
        scale, offset = scale * source.scales[0], scale * source.offsets[0]
        if source.transform.is_identity:
            return Raster(values[::-1], None, None, scale, offset, unit)
        values, place = placed(values, source.transform[:6], crs)
        return Raster(values, place, None, scale, offset, unit)


def _vertical(source: Any, crs: Any) -> tuple[float, str | None]:
    """Metres in the unit of the heights, and that unit where one is stated."""
    unit = (source.units[0] or "").strip()
    if unit:
        return metres_in(unit), unit
    found = _VERTICAL.search(crs.to_wkt(version="WKT1_GDAL")) if crs is not None else None
    return (float(found[2]), found[1]) if found else (1.0, None)


def _opened(path: Path) -> Any:
    try:
        import rasterio
    except ImportError:
        raise UnreadableError(MISSING_EXTRA) from None
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", rasterio.errors.NotGeoreferencedWarning)
            return rasterio.open(path)
    except rasterio.errors.RasterioError as error:
        raise UnreadableError(f"cannot be read as a GeoTIFF: {error}") from None
