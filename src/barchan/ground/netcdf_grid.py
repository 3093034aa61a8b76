"""Elevation models in NetCDF files, by the CF conventions."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from barchan.ground.raster import Hints, Raster, UnreadableError, placed, refuse_many_cells
from barchan.ground.reference import reference_of, stated
from barchan.ground.units import metres_in
from barchan.missing import marked

if TYPE_CHECKING:
    import xarray as xr

ACROSS = ("x", "projection_x_coordinate", "lon", "longitude", "easting", "degrees_east")
ALONG = ("y", "projection_y_coordinate", "lat", "latitude", "northing", "degrees_north")
"""Names, standard names and units of the coordinates from west to east, and from south to north."""

HEIGHTS = (
    "surface_altitude",
    "altitude",
    "height_above_reference_ellipsoid",
    "height_above_geopotential_datum",
)
"""Standard names of elevations."""

UNEVEN = 0.02
"""Largest part of a cell by which a coordinate may lie beside even spacing."""


def read_netcdf(path: Path, hints: Hints) -> Raster:
    """A variable over two horizontal coordinates.

    Raises UnreadableError where there is none, where there are several and ``hints`` name none, and where
    coordinates are not evenly spaced.
    """
    import xarray as xr

    try:
        with xr.open_dataset(path, mask_and_scale=False, decode_times=False) as opened:
            return _raster(opened, hints)
    except (OSError, ValueError):
        raise UnreadableError("cannot be read as NetCDF: it is another kind of file, or damaged") from None


def _raster(dataset: "xr.Dataset", hints: Hints) -> Raster:
    variable = _variable(dataset, hints.variable)
    along, across = _axis(variable, ALONG), _axis(variable, ACROSS)
    others = {str(d): n for d, n in variable.sizes.items() if d not in (along, across) and n > 1}
    if others:
        said = ", ".join(f"{name} of {size}" for name, size in others.items())
        raise UnreadableError(f"has the dimension {said} in {variable.name}; allowed: one grid of y and x")
    refuse_many_cells(variable.sizes[along], variable.sizes[across])
    values = variable.transpose(..., along, across).to_numpy().reshape(variable.sizes[along], -1)
    unit = variable.attrs.get("units")
    factor = 1.0 if unit in (None, "", "1") else metres_in(str(unit))
    scale = factor * float(variable.attrs.get("scale_factor", 1.0))
    offset = factor * float(variable.attrs.get("add_offset", 0.0))
    crs = stated(_reference(dataset, variable, str(across)), hints)
    (west, width), (south, height) = (_spacing(variable, name, crs) for name in (across, along))
    transform = (width, 0.0, west, 0.0, height, south)
    known = None if unit in (None, "", "1") else str(unit)
    turned, place = placed(_without_fill(values, variable.attrs), transform, crs)
    return Raster(turned, place, None, scale, offset, known)


def _variable(dataset: "xr.Dataset", name: str | None) -> "xr.DataArray":
    grids = [v for v in dataset.data_vars.values() if _axis(v, ALONG) and _axis(v, ACROSS)]
    names = ", ".join(str(v.name) for v in grids)
    if not grids:
        raise UnreadableError("has no variable over x and y (or longitude and latitude) with coordinates")
    chosen = [v for v in grids if v.name == name] if name is not None else grids
    if not chosen:
        raise UnreadableError(f"has no grid of the name '{name}'; allowed as variable: {names}")
    elevations = [v for v in chosen if v.attrs.get("standard_name") in HEIGHTS]
    chosen = elevations if len(elevations) == 1 else chosen
    if len(chosen) > 1:
        raise UnreadableError(f"has several grids; state variable, one of: {names}")
    return chosen[0]


def _axis(variable: "xr.DataArray", names: tuple[str, ...]) -> Any:
    """The dimension of a variable that runs along an axis, or None."""
    for dimension in variable.dims:
        if dimension not in variable.coords:
            continue
        attributes = variable[dimension].attrs
        words = (dimension, attributes.get("standard_name"), attributes.get("units"))
        if any(str(word).lower() in names for word in words):
            return dimension
    return None


def _spacing(variable: "xr.DataArray", name: Any, crs: Any) -> tuple[float, float]:
    """The outer edge of the first cell and the (signed) spacing of a coordinate, lengths in m."""
    places = variable[name].to_numpy().astype(np.float64)
    if len(places) < 2:
        raise UnreadableError(f"has a single {name}; allowed: a grid")
    step = float(places[-1] - places[0]) / (len(places) - 1)
    rounding = np.spacing(np.abs(variable[name].to_numpy()).max().astype(variable[name].dtype))
    beside = np.abs(places - places[0] - step * np.arange(len(places))).max()
    if not step or beside > UNEVEN * abs(step) + 2 * float(rounding):
        raise UnreadableError(f"has {name} that are not evenly spaced; allowed: a grid of equal cells")
    unit = str(variable[name].attrs.get("units", "m"))
    factor = 1.0 if (crs is not None and crs.is_geographic) or unit in ("", "1") else metres_in(unit)
    return (float(places[0]) - step / 2) * factor, step * factor


def _reference(dataset: "xr.Dataset", variable: "xr.DataArray", across: str) -> Any:
    """The reference system of a variable's grid mapping; degrees where its coordinates are longitudes."""
    mapping = str(variable.attrs.get("grid_mapping", "")).split(":")[0].strip()
    attributes = dataset[mapping].attrs if mapping in dataset.variables else {}
    for key in ("crs_wkt", "spatial_ref", "epsg_code"):
        if key in attributes:
            return reference_of(str(attributes[key]))
    unit = str(variable[across].attrs.get("units", "")).lower()
    if unit.startswith("degree") or across.lower() in ("lon", "longitude"):
        return reference_of("EPSG:4326")
    return None


def _without_fill(values: NDArray[Any], attributes: dict[str, Any]) -> NDArray[Any]:
    """Values with NaN where the attributes say that there is none."""
    marks = [np.atleast_1d(attributes.get(key, [])) for key in ("_FillValue", "missing_value")]
    empty = marked(values.astype(np.float64), [float(mark) for mark in np.concatenate(marks)])
    low, high = attributes.get("valid_range", (None, None))
    low, high = attributes.get("valid_min", low), attributes.get("valid_max", high)
    if low is not None:
        empty |= values < low
    if high is not None:
        empty |= values > high
    return np.where(empty, np.nan, values.astype(np.float64)) if empty.any() else values
