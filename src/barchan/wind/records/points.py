"""One point of a grid: the nearest to a place, told, and refused where it is none of the grid's own."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.errors import Problem, RecordError
from barchan.wind.records.format import RecordFormat
from barchan.wind.records.netcdf_values import fill_values
from barchan.wind.records.stations import FARTHEST

if TYPE_CHECKING:
    import xarray as xr

_MEMBERS = ("number", "realization", "member", "ensemble", "ens")
_LEVELS = ("height", "heightaboveground", "height_above_ground", "z")


@dataclass(frozen=True)
class PointSeries:
    """A variable over time, at one point."""

    values: "xr.DataArray"
    place: str
    """The point that was read, in words; empty where the file tells none."""
    height: float | None
    """Height (m) of the level that was read, where there were levels."""


def at_one_point(variable: "xr.DataArray", time: str, form: RecordFormat, source: str) -> PointSeries:
    """A variable at the one point that is there or that is asked for.

    Of final and preliminary values (``expver``) whichever is there is taken. Raises RecordError where
    a point is
    asked for outside the grid, and where more than one point, member or level remains.
    """
    variable = _either_version(variable, time)
    variable = _member(variable, form, source)
    variable, height = _level(variable, form)
    variable, place = _nearest(variable, form, source)
    single = [d for d in variable.dims if d != time and variable.sizes[d] == 1]
    variable = variable.squeeze(single, drop=True)
    if variable.dims != (time,):
        sizes = ", ".join(f"{name} ({size})" for name, size in variable.sizes.items() if name != time)
        message = f"has more than one point: {sizes}; state {_needed(variable, time)}"
        raise RecordError([Problem(str(variable.name), message)], source)
    return PointSeries(variable, place, height)


def _needed(variable: "xr.DataArray", time: str) -> str:
    """Which options would leave one point."""
    latitude, longitude = latitude_longitude(variable)
    spread = {d for c in (latitude, longitude) if c is not None for d in c.dims}
    others = [str(d) for d in variable.dims if d != time and d not in spread]
    return "latitude and longitude" if not others else f"a file without {', '.join(others)}"


def latitude_longitude(variable: "xr.DataArray") -> tuple["xr.DataArray | None", "xr.DataArray | None"]:
    """The coordinates of latitude and longitude, of a grid, a line of stations or a single point."""

    def found(begin: str, standard: str) -> "xr.DataArray | None":
        named = [c for n, c in variable.coords.items() if c.attrs.get("standard_name") == standard]
        named += [c for n, c in variable.coords.items() if str(n).lower().lstrip("x").startswith(begin)]
        return named[0] if named else None

    return found("lat", "latitude"), found("lon", "longitude")


def _either_version(variable: "xr.DataArray", time: str) -> "xr.DataArray":
    """The final or else the preliminary values of ERA5."""
    if "expver" not in variable.dims:
        return variable
    fills = fill_values(variable.attrs).tolist()
    merged = variable.isel(expver=0, drop=True)
    for k in range(1, variable.sizes["expver"]):
        there = merged.notnull() & ~merged.isin(fills)
        merged = merged.where(there, variable.isel(expver=k, drop=True))
    merged.attrs = variable.attrs
    merged.name = variable.name
    return merged.transpose(time, ...)


def _member(variable: "xr.DataArray", form: RecordFormat, source: str) -> "xr.DataArray":
    name = next((d for d in variable.dims if str(d).lower() in _MEMBERS), None)
    if name is None:
        return variable
    labels = variable[name].to_numpy() if name in variable.coords else np.arange(variable.sizes[name])
    told = f"members {labels[0]} to {labels[-1]}"
    if form.member is None and len(labels) > 1:
        raise RecordError([Problem("member", f"the file holds an ensemble; state one of {told}")], source)
    at = np.flatnonzero(labels == form.member) if form.member is not None else np.zeros(1, np.intp)
    if not at.size:
        raise RecordError([Problem("member", f"is {form.member}; the file has {told}")], source)
    return variable.isel({name: int(at[0])}, drop=True)


def _level(variable: "xr.DataArray", form: RecordFormat) -> tuple["xr.DataArray", float | None]:
    """The variable at the height that is asked for, else the nearest to 10 m; and that height."""
    name = next((d for d in variable.dims if str(d).lower() in _LEVELS and d in variable.coords), None)
    if name is None:
        return variable, None
    heights = variable[name].to_numpy().astype(np.float64)
    wanted = form.height or 10.0
    at = int(np.argmin(np.abs(heights - wanted)))
    if form.height is not None and not np.isclose(heights[at], wanted, rtol=1e-3):
        message = f"is {wanted:g} m; the file has winds at {', '.join(f'{h:g}' for h in heights)} m"
        raise RecordError([Problem("height", message)], str(variable.name))
    return variable.isel({name: at}, drop=True), float(heights[at])


def _nearest(variable: "xr.DataArray", form: RecordFormat, source: str) -> tuple["xr.DataArray", str]:
    """The variable at the point nearest to the one asked for, and that point in words."""
    latitude, longitude = latitude_longitude(variable)
    if latitude is None or longitude is None:
        if form.latitude is not None or form.longitude is not None:
            raise RecordError([Problem("latitude", "is stated, but the file has no coordinates")], source)
        return variable, ""
    if latitude.dims == longitude.dims and latitude.ndim:
        return _scattered(variable, latitude, longitude, form, source)
    found = {}
    for axis, coordinate, wanted in (
        ("latitude", latitude, form.latitude),
        ("longitude", longitude, form.longitude),
    ):
        values = np.atleast_1d(coordinate.to_numpy().astype(np.float64))
        if wanted is None:
            if values.size > 1:
                return variable, ""
            at = 0
        else:
            at = _index(values, wanted, axis, source)
        found[axis] = float(values[at])
        if coordinate.ndim:
            variable = variable.isel({coordinate.dims[0]: at})
    return variable, place_words(found["latitude"], found["longitude"])


def _index(values: NDArray[np.float64], wanted: float, axis: str, source: str) -> int:
    """Which value of an axis is nearest; raises RecordError where it is farther than half a step."""
    away = np.abs(values - wanted)
    if axis == "longitude":
        away = np.abs((values - wanted + 180.0) % 360.0 - 180.0)
    at = int(np.argmin(away))
    step = float(np.median(np.abs(np.diff(values)))) if values.size > 1 else 2 * FARTHEST
    if away[at] > step / 2 * (1 + 1e-6):
        message = (
            f"is {wanted:g}, outside the grid; allowed: {values.min():g} to {values.max():g} degrees "
            f"(steps of "
            f"{step:g})"
        )
        raise RecordError([Problem(axis, message)], source)
    return at


def _scattered(
    variable: "xr.DataArray",
    latitude: "xr.DataArray",
    longitude: "xr.DataArray",
    form: RecordFormat,
    source: str,
) -> tuple["xr.DataArray", str]:
    """The nearest of stations, or of a grid in rows and columns of its own."""
    if form.latitude is None or form.longitude is None:
        return variable, ""
    north, east = (c.to_numpy().astype(np.float64) for c in (latitude, longitude))
    away = np.hypot(
        north - form.latitude,
        np.cos(np.radians(form.latitude)) * ((east - form.longitude + 180.0) % 360.0 - 180.0),
    )
    at = np.unravel_index(int(np.nanargmin(away)), away.shape)
    if away[at] > FARTHEST:
        message = (
            f"is {form.latitude:g}, {form.longitude:g}; the nearest point, "
            f"{place_words(north[at], east[at])}, is "
            f"farther than {FARTHEST:g}°"
        )
        raise RecordError([Problem("latitude, longitude", message)], source)
    chosen = {dim: int(k) for dim, k in zip(latitude.dims, at, strict=True)}
    return variable.isel(chosen), place_words(float(north[at]), float(east[at]))


def place_words(latitude: float, longitude: float) -> str:
    """A point as people write it: 23.5°N 15.5°E."""
    east = (longitude + 180.0) % 360.0 - 180.0
    return f"{abs(latitude):g}°{'N' if latitude >= 0 else 'S'} {abs(east):g}°{'E' if east >= 0 else 'W'}"
