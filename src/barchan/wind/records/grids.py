"""Wind records in NetCDF files: time series, or one point of a reanalysis such as ERA5."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from barchan.errors import Problem, RecordError
from barchan.wind.records.columns import allowed_units, guess, speed_unit
from barchan.wind.records.format import UNITS, RecordFormat
from barchan.wind.records.record import Rows

if TYPE_CHECKING:
    import xarray as xr

STANDARD = {
    "speed": "wind_speed",
    "direction": "wind_from_direction",
    "u": "eastward_wind",
    "v": "northward_wind",
}
"""Standard names of the CF conventions."""


def read_grid(path: Path, form: RecordFormat) -> Rows:
    """The rows of a NetCDF file; raises RecordError where it holds no wind over time."""
    import xarray as xr

    try:
        with xr.open_dataset(path) as opened:
            return _rows(opened, form, path.name)
    except (OSError, ValueError) as error:
        raise RecordError([Problem("", f"cannot be read as NetCDF: {error}")], path.name) from None


def _rows(dataset: "xr.Dataset", form: RecordFormat, source: str) -> Rows:
    found = {q: _variable(dataset, form, q) for q in ("speed", "direction", "u", "v")}
    pair = ("speed", "direction") if found["speed"] and found["direction"] else ("u", "v")
    for quantity in pair:
        if found[quantity] is None:
            message = (
                "no variables for speed and direction, nor for eastward and northward wind; "
                f"the variables are {', '.join(map(str, dataset.data_vars))}"
            )
            raise RecordError([Problem("", message)], source)
    first, second = (dataset[found[quantity]] for quantity in pair)
    time = _time_name(dataset, first, form, source)
    units = [
        _unit(variable, form, source) for variable in ((first,) if pair[0] == "speed" else (first, second))
    ]
    one, other = (_series(variable, time, form, source) for variable in (first, second))
    if pair == ("speed", "direction"):
        speed, direction = one * UNITS[units[0][0]], other
        names = {"speed": str(first.name), "direction": str(second.name)}
    else:
        speed, direction = _polar(one * UNITS[units[0][0]], other * UNITS[units[1][0]])
        names = dict.fromkeys(("speed", "direction"), f"{first.name}, {second.name}")
    for values in (speed, direction):
        values[np.isin(values, form.missing)] = np.nan
    stamps = dataset[time].to_numpy().astype("datetime64[ms]")
    return Rows(
        source,
        (stamps - stamps[0]).astype(np.float64) / 1e3 if len(stamps) else np.zeros(0),
        stamps[0].astype("datetime64[s]") if len(stamps) else None,
        speed,
        direction,
        {**names, "time": time},
        np.arange(1, len(stamps) + 1),
        (units[0][0], UNITS[units[0][0]]),
        tuple(remark for _, remark in units if remark),
    )


def _variable(dataset: "xr.Dataset", form: RecordFormat, quantity: str) -> str | None:
    stated = getattr(form, quantity, None)
    if stated:
        return stated if stated in dataset.data_vars else None
    named = guess(map(str, dataset.data_vars), quantity)
    standard = STANDARD[quantity]
    return named or next(
        (str(n) for n, v in dataset.data_vars.items() if v.attrs.get("standard_name") == standard), None
    )


def _time_name(dataset: "xr.Dataset", variable: "xr.DataArray", form: RecordFormat, source: str) -> str:
    name = form.time or guess(map(str, variable.dims), "time")
    if name is None or name not in variable.dims or name not in dataset:
        raise RecordError(
            [Problem("time", f"no dimension of times in {variable.name}{variable.dims}")], source
        )
    if dataset[name].dtype.kind != "M":
        raise RecordError([Problem(name, "holds no dates of the standard calendar")], source)
    return name


def _unit(variable: "xr.DataArray", form: RecordFormat, source: str) -> tuple[str, str]:
    """Unit of a variable, and the assumptions made."""
    spelling = str(variable.attrs.get("units", ""))
    if form.unit:
        return form.unit, ""
    if not spelling:
        return "m/s", f"variable {variable.name} states no unit; taken as m/s"
    unit = speed_unit(spelling)
    if unit is None:
        problem = Problem(str(variable.name), f"is in '{spelling}'; allowed: {allowed_units()}")
        raise RecordError([problem], source)
    return unit, ""


def _series(variable: "xr.DataArray", time: str, form: RecordFormat, source: str) -> NDArray[np.float64]:
    """The values over time, at the one point that is there or that is asked for."""
    for axis, wanted, turn in (("lat", form.latitude, 0.0), ("lon", form.longitude, 360.0)):
        name = next((d for d in variable.dims if str(d).lower().startswith(axis)), None)
        if name is not None and wanted is not None and name in variable.coords:
            variable = variable.isel({name: _nearest(variable[name].to_numpy(), wanted, turn)})
    variable = variable.squeeze([d for d in variable.dims if d != time and variable.sizes[d] == 1], drop=True)
    if variable.dims != (time,):
        sizes = ", ".join(f"{name} ({size})" for name, size in variable.sizes.items() if name != time)
        message = f"has more than one point: {sizes}; state latitude and longitude"
        raise RecordError([Problem(str(variable.name), message)], source)
    return np.array(variable.to_numpy(), np.float64)


def _nearest(values: NDArray[Any], wanted: float, turn: float) -> int:
    away = np.abs(values - wanted)
    return int(np.argmin(np.minimum(away, np.abs(turn - away)) if turn else away))


def _polar(east: NDArray, north: NDArray) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Speed and where the wind comes from, of its eastward and northward parts."""
    return np.hypot(east, north), np.degrees(np.arctan2(-east, -north)) % 360.0
