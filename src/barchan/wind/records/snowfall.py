"""How much snow falls in the rows of a record: as stated, as a part of precipitation, or by rising depth."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.snow.density import hedstrom_pomeroy
from barchan.errors import Problem, RecordError
from barchan.wind.records.durations import GAP
from barchan.wind.records.format import RecordFormat

HOUR = 3600.0
"""An hour (s)."""

HEAVIEST = 30.0
"""Snowfall (kg/m²/h) above all that was measured: more is a wrong unit, or a code for a missing value."""

ALL_SNOW, ALL_RAIN = 0.0, 2.0
"""Temperatures (°C) up to which precipitation is snow, and from which on it is rain; between them a share."""

SNOW_OF_TYPE = {0: np.nan, 1: 0.0, 3: 0.0, 5: 1.0, 6: 1.0, 7: 0.5, 8: 0.0, 12: 0.0}
"""Share of snow by ERA5's code of the type: none, rain, freezing rain, snow, wet snow, a mixture of rain and
snow, ice pellets, freezing drizzle. The half of a mixture is ours."""

Values = NDArray[np.float64]


@dataclass(frozen=True)
class Fallen:
    """What the rows hold of what fell; None where the file lacks it."""

    time: Values
    """s."""
    numbers: NDArray[np.int64]
    """Numbers of the rows in the file."""
    source: str
    names: dict[str, str]
    """The column of each quantity."""
    temperature: Values | None = None
    """°C."""
    snowfall: Values | None = None
    """kg/m²/s."""
    precipitation: Values | None = None
    """kg/m²/s."""
    in_amounts: bool = False
    """Whether precipitation is reported as amounts since the row before, and its kind with it."""
    rain_share: Values | None = None
    """0: all snow, 1: all rain."""
    precipitation_type: Values | None = None
    """Codes, see ``SNOW_OF_TYPE``."""
    snow_depth: Values | None = None
    """m."""


def snowfall_of(fallen: Fallen, form: RecordFormat) -> tuple[Values | None, list[str]]:
    """Snowfall (kg/m²/s) of each row, and what was assumed; None where nothing tells of it.

    What is stated comes first, then precipitation, then a depth that rises. Raises RecordError where columns
    that the user states exclude each other or lack what they need.
    """
    if fallen.precipitation is not None:
        return _of_precipitation(fallen, form)
    if fallen.snowfall is not None:
        return fallen.snowfall, []
    if fallen.snow_depth is not None:
        return _of_depth(fallen, form)
    return None, []


def rates(amounts: Values, time: Values) -> Values:
    """Rates (per s) of amounts that fell since the row before; that row has the rate.

    The last row's rate is not known.
    """
    order = np.argsort(time, kind="stable")
    found = np.full(len(time), np.nan)
    steps = np.diff(time[order])
    usual = float(np.median(steps)) if len(steps) else 1.0
    lasting = np.where(steps > GAP * usual, usual, steps)
    with np.errstate(divide="ignore", invalid="ignore"):
        found[order[:-1]] = amounts[order[1:]] / lasting
    return np.where(np.isfinite(found), found, np.nan)


def _of_precipitation(fallen: Fallen, form: RecordFormat) -> tuple[Values | None, list[str]]:
    """The part of precipitation that is snow, unless snowfall itself is there."""
    assert fallen.precipitation is not None
    if fallen.snowfall is not None:
        if form.snowfall and form.precipitation:
            message = f"is '{form.precipitation}', and snowfall is '{form.snowfall}'; allowed: one of them"
            raise RecordError([Problem("precipitation", message)], fallen.source)
        return fallen.snowfall, ["precipitation is not used, for there is snowfall"]
    share, remarks = _snow_share(fallen)
    if share is None:
        if form.precipitation:
            message = f"is '{form.precipitation}', but there is no temperature to tell snow from rain"
            raise RecordError([Problem("precipitation", message)], fallen.source)
        return None, ["precipitation is not used, for there is no temperature to tell snow from rain"]
    # A dry row needs no share, and one without a temperature then still has none.
    snow = np.where(fallen.precipitation == 0.0, 0.0, fallen.precipitation * share)
    _refuse_too_much(snow, fallen, "precipitation")
    return snow, [*remarks, "rain is left out"]


def _snow_share(fallen: Fallen) -> tuple[Values | None, list[str]]:
    """The share of precipitation that is snow: as stated, by its type, and where both lack by warmth."""
    stated, remarks = None, []
    if fallen.rain_share is not None:
        stated = 1.0 - fallen.rain_share
        remarks.append(f"rain and snow are parted by '{fallen.names['rain_share']}'")
    elif fallen.precipitation_type is not None:
        stated = _by_type(fallen)
        name = fallen.names["precipitation_type"]
        remarks.append(f"rain and snow are parted by '{name}', a mixture by half")
    if stated is not None and fallen.in_amounts:
        stated = _of_row_after(stated, fallen.time)
    if fallen.temperature is None:
        return stated, remarks
    warmth = np.clip((ALL_RAIN - fallen.temperature) / (ALL_RAIN - ALL_SNOW), 0.0, 1.0)
    if stated is None or np.isnan(stated).any():
        where = "" if stated is None else "where that is not stated "
        remarks.append(
            f"{where}precipitation is snow up to {ALL_SNOW:g} °C, rain from {ALL_RAIN:g} °C on, and in "
            "between both"
        )
    return (warmth if stated is None else np.where(np.isnan(stated), warmth, stated)), remarks


def _by_type(fallen: Fallen) -> Values:
    assert fallen.precipitation_type is not None
    codes = fallen.precipitation_type
    known = np.isnan(codes) | np.isin(codes, list(SNOW_OF_TYPE))
    if not known.all():
        row = int(np.argmin(known))
        where = f"row {fallen.numbers[row]}, column '{fallen.names['precipitation_type']}'"
        allowed = ", ".join(map(str, SNOW_OF_TYPE))
        raise RecordError([Problem(where, f"is {codes[row]:g}; allowed: {allowed}")], fallen.source)
    share = np.full(len(codes), np.nan)
    for code, snow in SNOW_OF_TYPE.items():
        share[codes == code] = snow
    return share


def _of_row_after(values: Values, time: Values) -> Values:
    """The values of the row after each, as amounts are; unknown at the last."""
    order = np.argsort(time, kind="stable")
    found = np.full(len(time), np.nan)
    found[order[:-1]] = values[order[1:]]
    return found


def _of_depth(fallen: Fallen, form: RecordFormat) -> tuple[Values | None, list[str]]:
    """Snowfall by rising depth: each rise times the density of fresh snow."""
    assert fallen.snow_depth is not None
    name = fallen.names["snow_depth"]
    if form.fresh_density is None and fallen.temperature is None:
        message = f"is '{name}', but there is neither fresh_density nor a temperature to find it by"
        if form.snow_depth:
            raise RecordError([Problem("snow_depth", message)], fallen.source)
        return None, [f"snow depth '{name}' is not used, for there is no temperature"]
    if form.fresh_density is not None:
        density = np.full(len(fallen.time), form.fresh_density)
        told = f"{form.fresh_density:g} kg/m³"
    else:
        assert fallen.temperature is not None
        known = (hedstrom_pomeroy(t, 0.0) if np.isfinite(t) else np.nan for t in fallen.temperature)
        density = np.array(list(known))
        told = "the density of fresh snow by temperature (Hedstrom & Pomeroy 1998)"
    order = np.argsort(fallen.time, kind="stable")
    rises = np.full(len(order), np.nan)
    rises[order[1:]] = np.maximum(np.diff(fallen.snow_depth[order]), 0.0)
    # What fell before a row is known in that row; its air was that of the row in which it fell.
    snow = rates(rises, fallen.time) * density
    _refuse_too_much(snow, fallen, "snow_depth")
    told_of = f"snowfall is derived from the rising snow depth '{name}', times {told}"
    return snow, [f"{told_of}: drift and noise that raise it count as well, and settling hides some"]


def _refuse_too_much(snow: Values, fallen: Fallen, quantity: str) -> None:
    most = float(np.nanmax(snow, initial=0.0))
    if most > HEAVIEST / HOUR:
        row = int(np.nanargmax(snow))
        where = f"row {fallen.numbers[row]}, column '{fallen.names[quantity]}'"
        message = f"comes to {most * HOUR:.4g} kg/m²/h of snow; allowed: {HEAVIEST:g} kg/m²/h or less"
        raise RecordError([Problem(where, message)], fallen.source)
