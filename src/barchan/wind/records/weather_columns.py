"""Temperature and snowfall beside the wind of a record: their columns and units, and what they come to."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from barchan.errors import Problem, RecordError
from barchan.wind.records.claims import Claim, Column, Documented, claims_of
from barchan.wind.records.durations import GAP
from barchan.wind.records.format import RecordFormat
from barchan.wind.records.quantities import QUANTITIES, WEATHER
from barchan.wind.records.units import AMOUNTS, ZEROS
from barchan.wind.records.values import Unit
from barchan.wind.weather import COLDEST, WARMEST

HOUR = 3600.0
"""An hour (s)."""

HEAVIEST = 30.0
"""Snowfall (kg/m²/h) above all that was measured: more is a wrong unit, or a code for a missing value."""

ALL_SNOW, ALL_RAIN = 0.0, 2.0
"""Temperatures (°C) up to which precipitation is snow, and from which on it is rain; between them a share."""

LONGEST_BRIDGE = 3 * HOUR
"""Longest time (s) over which a missing temperature is taken from its neighbours."""

GREATEST_JUMP = 30.0
"""Change of temperature in an hour (K) that no weather makes."""

Numbers = Callable[[Claim, Unit], NDArray[np.float64]]
"""Reads a column in its own unit, NaN where a value is missing."""


@dataclass(frozen=True)
class WeatherColumns:
    """What a file holds of the weather, row by row."""

    temperature: NDArray[np.float64] | None = None
    """°C."""
    snowfall: NDArray[np.float64] | None = None
    """kg/m²/s."""
    remarks: tuple[str, ...] = ()


def weather_of(
    columns: list[Column],
    form: RecordFormat,
    documented: Documented,
    taken: frozenset[str],
    read: Numbers,
    time: NDArray[np.float64],
    numbers: NDArray[np.int64],
    source: str,
) -> WeatherColumns:
    """Temperature and snowfall of the rows.

    A column that the user states must be of use; RecordError says why it is not. One that is only known
    by its name is left out then, with a remark, for a record may be read for its wind alone.
    """
    names = [column.name for column in columns]
    absent = [q for q in WEATHER if getattr(form, q) and getattr(form, q) not in names]
    if absent:
        told = f"; the columns are {', '.join(names)}"
        raise RecordError([Problem(q, f"no column '{getattr(form, q)}'{told}") for q in absent], source)
    found: dict[str, NDArray[np.float64]] = {}
    remarks: list[str] = []
    for quantity, claims in claims_of(columns, form, documented, taken, WEATHER).items():
        if not claims or (documented and not getattr(form, quantity) and quantity not in documented):
            continue
        try:
            found[quantity] = _values(claims[0], read, time, numbers, source)
            remarks.append(f"{quantity} is read from '{claims[0].column}'")
        except RecordError as error:
            if getattr(form, quantity):
                raise
            said = "; ".join(f"{p.key}: {p.message}" for p in error.problems)
            remarks.append(f"{quantity} is not read from '{claims[0].column}': {said}")
    temperature = found.pop("temperature", None)
    _warn_of_jumps(temperature, time, remarks)
    temperature = _bridged(temperature, time)
    snowfall = _snowfall(found, temperature, form, remarks, source)
    return WeatherColumns(temperature, snowfall, tuple(remarks))


def _values(
    claim: Claim, read: Numbers, time: NDArray[np.float64], numbers: NDArray[np.int64], source: str
) -> NDArray[np.float64]:
    """A column in °C or kg/m²/s; raises RecordError where its unit or a value cannot be."""
    kind = QUANTITIES[claim.quantity]
    spelled = claim.unit or kind.usual_unit
    if not spelled:
        allowed = ", ".join(kind.dimension.sizes)
        message = f"states no unit; name one in its heading or units, of {allowed}"
        raise RecordError([Problem(f"column '{claim.column}'", message)], source)
    name = kind.dimension.required(spelled, claim.column, source)
    raw = read(claim, Unit(name, kind.dimension.sizes[name]))
    if claim.quantity == "temperature" and not claim.unit and np.nanmin(raw, initial=np.inf) > 150.0:
        name = "K"
    values = raw * kind.dimension.sizes[name] + ZEROS.get(name, 0.0)
    values = _rates(values, time) if name in AMOUNTS else values
    low, high = (COLDEST, WARMEST) if claim.quantity == "temperature" else (0.0, HEAVIEST / HOUR)
    if claim.quantity == "precipitation":
        high = np.inf
    wrong = (values < low) | (values > high)
    if wrong.any():
        row = int(np.argmax(wrong))
        shown = raw[row] if name not in AMOUNTS else values[row] * HOUR
        limits = (
            f"{low:g} to {high:g} °C" if claim.quantity == "temperature" else f"0 to {HEAVIEST:g} kg/m²/h"
        )
        where = f"row {numbers[row]}, column '{claim.column}'"
        unit = name if name not in AMOUNTS else "kg/m²/h"
        raise RecordError([Problem(where, f"is {shown:g} {unit}; allowed: {limits}")], source)
    return values


def _rates(amounts: NDArray[np.float64], time: NDArray[np.float64]) -> NDArray[np.float64]:
    """Rates (kg/m²/s) of amounts (kg/m²) that fell since the row before; that row has the rate.

    The last row's rate is not known.
    """
    order = np.argsort(time, kind="stable")
    rates = np.full(len(time), np.nan)
    steps = np.diff(time[order])
    usual = float(np.median(steps)) if len(steps) else 1.0
    lasting = np.where(steps > GAP * usual, usual, steps)
    with np.errstate(divide="ignore", invalid="ignore"):
        rates[order[:-1]] = amounts[order[1:]] / lasting
    return np.where(np.isfinite(rates), rates, np.nan)


def _snowfall(
    found: dict[str, NDArray[np.float64]],
    temperature: NDArray[np.float64] | None,
    form: RecordFormat,
    remarks: list[str],
    source: str,
) -> NDArray[np.float64] | None:
    """Snowfall as stated, or the part of precipitation that is snow at its temperature."""
    if "precipitation" not in found:
        return found.get("snowfall")
    if "snowfall" in found:
        if form.snowfall and form.precipitation:
            message = f"is '{form.precipitation}', and snowfall is '{form.snowfall}'; allowed: one of them"
            raise RecordError([Problem("precipitation", message)], source)
        remarks.append("precipitation is not used, for there is snowfall")
        return found["snowfall"]
    if temperature is None:
        if form.precipitation:
            message = f"is '{form.precipitation}', but there is no temperature to tell snow from rain"
            raise RecordError([Problem("precipitation", message)], source)
        remarks.append("precipitation is not used, for there is no temperature to tell snow from rain")
        return None
    share = np.clip((ALL_RAIN - temperature) / (ALL_RAIN - ALL_SNOW), 0.0, 1.0)
    remarks.append(
        f"precipitation is snow up to {ALL_SNOW:g} °C, rain from {ALL_RAIN:g} °C on, and in between both; "
        "rain is left out"
    )
    snow: NDArray[np.float64] = found["precipitation"] * share
    if np.nanmax(snow, initial=0.0) > HEAVIEST / HOUR:
        message = (
            f"comes to {np.nanmax(snow) * HOUR:g} kg/m²/h of snow; allowed: {HEAVIEST:g} kg/m²/h or less"
        )
        raise RecordError([Problem("precipitation", message)], source)
    return snow


def _bridged(values: NDArray[np.float64] | None, time: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """Temperatures, those missing for a short time on a straight line between their neighbours."""
    if values is None or np.isnan(values).all():
        return None
    known = ~np.isnan(values)
    order = np.argsort(time[known], kind="stable")
    at, there = time[known][order], values[known][order]
    after = np.clip(np.searchsorted(at, time), 1, len(at) - 1) if len(at) > 1 else np.zeros(len(time), int)
    inside = (time >= at[0]) & (time <= at[-1])
    short = inside & (at[after] - at[np.maximum(after - 1, 0)] <= LONGEST_BRIDGE)
    return np.where(known, values, np.where(short, np.interp(time, at, there), np.nan))


def _warn_of_jumps(values: NDArray[np.float64] | None, time: NDArray[np.float64], remarks: list[str]) -> None:
    """Remark on temperatures that change as if units were mixed."""
    if values is None or len(values) < 2:
        return
    jumps = (np.abs(np.diff(values)) > GREATEST_JUMP) & (np.abs(np.diff(time)) <= HOUR)
    if jumps.any():
        at = int(np.argmax(jumps))
        remarks.append(
            f"temperature goes from {values[at]:g} to {values[at + 1]:g} °C within an hour: are K and °C "
            "mixed?"
        )
