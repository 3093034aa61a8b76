"""Wind records in NetCDF files: time series, or one point of a reanalysis such as ERA5."""

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.wall import REFERENCE_HEIGHT
from barchan.errors import Problem, RecordError
from barchan.wind.records.boom import boom_of, brought_to_ten_metres
from barchan.wind.records.choice import choose
from barchan.wind.records.claims import Claim, Column, claims_of, guess
from barchan.wind.records.format import RecordFormat
from barchan.wind.records.netcdf_values import variable_values
from barchan.wind.records.points import at_one_point, latitude_longitude
from barchan.wind.records.providers import UNKNOWN, provider_of
from barchan.wind.records.record import Rows
from barchan.wind.records.times import Dated, offset_of
from barchan.wind.records.values import Unit, unit_of, wind_of
from barchan.wind.records.weather_columns import WeatherColumns, weather_of

if TYPE_CHECKING:
    import xarray as xr

_HEIGHTS = ("height", "heightAboveGround", "height_above_ground", "altitude", "level", "z")
"""Coordinates that may state the height of a variable."""

_TURNED = (
    "is along the columns of a grid that is not one of latitude and longitude, and Barchan does not "
    "turn it; give "
    "eastward and northward wind"
)


def read_grid(path: Path, form: RecordFormat) -> Rows:
    """The rows of a NetCDF file; raises RecordError where it holds no wind over time."""
    import xarray as xr

    try:
        with xr.open_dataset(path, mask_and_scale=False) as opened:
            return _rows(opened, form, path.name)
    except (OSError, ValueError) as error:
        raise RecordError([Problem("", f"cannot be read as NetCDF: {error}")], path.name) from None


def _rows(dataset: "xr.Dataset", form: RecordFormat, source: str) -> Rows:
    names = [str(name) for name in dataset.data_vars]
    provider = provider_of([*names, *map(str, dataset.coords)]) or UNKNOWN
    claims = claims_of([_column(dataset, name) for name in names], form, {}, frozenset())
    choice = choose(claims, form, names, source, "variable")
    time = _time_name(dataset, dataset[choice.first.column], form, source)
    measured, units, place = [], [], ""
    height = choice.height
    for claim in (choice.first, choice.second):
        unit = unit_of(claim, form, source)
        point = at_one_point(dataset[claim.column], time, form, source)
        measured.append(variable_values(point.values, claim, unit, form, source) * unit.size)
        units.append(unit)
        place = point.place
        height = point.height if height is None or point.height is not None else height
    speed, direction = wind_of(choice, measured[0], measured[1], form)
    seconds, start, utc = _dated(dataset[time], form)
    numbers = np.arange(1, len(seconds) + 1)

    def numbers_of(claim: Claim, unit: Unit) -> NDArray[np.float64]:
        point = at_one_point(dataset[claim.column], time, form, source)
        return variable_values(point.values, claim, unit, form, source)

    boom, told = boom_of(choice.first.column, names, form, source), ""
    if boom is not None:
        tall = numbers_of(Claim(boom, "boom_height", "m", None, ""), Unit("m", 1.0))
        speed, told = brought_to_ten_metres(speed, tall, boom, numbers, source)
        height = REFERENCE_HEIGHT
    over_time = [name for name in names if time in dataset[name].dims]
    weather = weather_of(
        [_column(dataset, name) for name in over_time],
        form,
        {},
        frozenset((choice.first.column, choice.second.column)),
        numbers_of,
        seconds,
        numbers,
        source,
    )
    return Rows(
        source,
        seconds,
        start,
        speed,
        direction,
        {**choice.names, "time": time},
        numbers,
        (units[0].name, units[0].size),
        tuple(filter(None, (*(u.remark for u in units), *choice.remarks, told, *weather.remarks))),
        height,
        provider.name,
        weather.temperature,
        weather.snowfall,
        place=place,
        unit_stated=units[0].stated,
        utc=utc,
    )


def _dated(times: "xr.DataArray", form: RecordFormat) -> Dated:
    """Times of a file, which are in UTC by the CF conventions unless the user states another zone."""
    stamps = times.to_numpy().astype("datetime64[ms]")
    if not len(stamps):
        return Dated(np.zeros(0), None, utc=True)
    stamps = stamps - offset_of(form.time_zone or "UTC")
    return Dated((stamps - stamps[0]).astype(np.float64) / 1e3, stamps[0].astype("datetime64[s]"), utc=True)


def weather_grid(path: Path, form: RecordFormat) -> tuple[Dated, WeatherColumns]:
    """Times and weather of a NetCDF file, whatever wind it holds.

    Raises RecordError where it holds no weather over time.
    """
    import xarray as xr

    source = path.name
    try:
        with xr.open_dataset(path, mask_and_scale=False) as dataset:
            time = form.time or guess(list(map(str, dataset.dims)), "time")
            over_time = [str(n) for n in dataset.data_vars if time in dataset[n].dims]
            if time is None or not over_time:
                raise RecordError([Problem("time", "no variable over time")], source)
            _time_name(dataset, dataset[over_time[0]], form, source)
            dated = _dated(dataset[time], form)

            def numbers_of(claim: Claim, unit: Unit) -> NDArray[np.float64]:
                point = at_one_point(dataset[claim.column], time, form, source)
                return variable_values(point.values, claim, unit, form, source)

            columns = [_column(dataset, name) for name in over_time]
            rows = np.arange(1, len(dated.seconds) + 1)
            weather = weather_of(columns, form, {}, frozenset(), numbers_of, dated.seconds, rows, source)
            return dated, weather
    except (OSError, ValueError) as error:
        raise RecordError([Problem("", f"cannot be read as NetCDF: {error}")], source) from None


def _column(dataset: "xr.Dataset", name: str) -> Column:
    """A variable as its attributes describe it."""
    variable = dataset[name]
    attributes = {key: str(variable.attrs.get(key, "")) for key in ("units", "standard_name", "long_name")}
    standard = attributes["standard_name"]
    latitude, _ = latitude_longitude(variable)
    turned = standard in {"x_wind", "y_wind"} or not standard
    sideways = latitude is not None and latitude.ndim == 2 and turned
    averaged = str(variable.attrs.get("cell_methods", ""))
    described = attributes["long_name"]
    extreme = next(
        (f" {word}" for word in ("maximum", "minimum", "standard deviation") if word in averaged), ""
    )
    return Column(
        name,
        attributes["units"],
        standard,
        described + extreme,
        _height(variable),
        _TURNED if sideways else "",
    )


def _height(variable: "xr.DataArray") -> float | None:
    """The height (m) that a coordinate of one value states."""
    for name in _HEIGHTS:
        if name in variable.coords and variable[name].size == 1:
            coordinate = variable[name]
            if str(coordinate.attrs.get("units", "")).lower() in {"m", "metre", "metres", "meter", "meters"}:
                return float(coordinate)
    return None


def _time_name(dataset: "xr.Dataset", variable: "xr.DataArray", form: RecordFormat, source: str) -> str:
    name = form.time or guess(list(map(str, variable.dims)), "time")
    if name is None or name not in variable.dims or name not in dataset:
        problem = Problem("time", f"no dimension of times in {variable.name}{variable.dims}")
        raise RecordError([problem], source)
    if dataset[name].dtype.kind != "M":
        raise RecordError([Problem(name, "holds no dates of the standard calendar")], source)
    return name
