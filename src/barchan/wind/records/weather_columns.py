"""Temperature and snowfall beside the wind of a record: their columns and units, and what they come to."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from barchan.errors import Problem, RecordError
from barchan.wind.records.claims import Claim, Column, Documented, claims_of
from barchan.wind.records.format import RecordFormat
from barchan.wind.records.gaps import bridged
from barchan.wind.records.quantities import QUANTITIES, WEATHER
from barchan.wind.records.snowfall import HEAVIEST, HOUR, Fallen, rates, snowfall_of
from barchan.wind.records.sums import amounts_of
from barchan.wind.records.units import AMOUNTS, FALL, ZEROS
from barchan.wind.records.values import Unit
from barchan.wind.weather import COLDEST, WARMEST

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
    found: dict[str, Reading] = {}
    remarks: list[str] = []
    for quantity, claims in claims_of(columns, form, documented, taken, WEATHER).items():
        if not claims or not _wanted(quantity, form, documented):
            continue
        try:
            found[quantity] = _reading(claims[0], read, time, numbers, source, form.accumulated)
        except RecordError as error:
            if getattr(form, quantity):
                raise
            said = "; ".join(f"{p.key}: {p.message}" for p in error.problems)
            remarks.append(f"{quantity} is not read from '{claims[0].column}': {said}")
    temperature = found.pop("temperature", None)
    values = None if temperature is None else temperature.values
    if temperature is not None:
        remarks.append(f"temperature is read from '{temperature.column}'")
    _warn_of_jumps(values, time, remarks)
    values = None if values is None else bridged(values, time)
    fallen = Fallen(
        time,
        numbers,
        source,
        {quantity: one.column for quantity, one in found.items()},
        values,
        in_amounts="precipitation" in found and found["precipitation"].in_amounts,
        **{quantity: one.values for quantity, one in found.items()},
    )
    snowfall, said_of_snow = snowfall_of(fallen, form)
    remarks += [
        f"{quantity} is read from '{found[quantity].column}'"
        for quantity in ("snowfall", "precipitation")
        if quantity in found
    ]
    return WeatherColumns(values, snowfall, (*remarks, *said_of_snow))


def _wanted(quantity: str, form: RecordFormat, documented: Documented) -> bool:
    """Whether a quantity is read: where the user states it, or the format knows it or fixes no columns.

    The depth of snow also has other uses, so no table but those of a format that fixes it is searched for it.
    """
    if getattr(form, quantity):
        return True
    return quantity in documented or (not documented and quantity != "snow_depth")


@dataclass(frozen=True)
class Reading:
    """A column of the weather in SI units."""

    column: str
    values: NDArray[np.float64]
    in_amounts: bool
    """Whether the file has amounts since the row before, not rates."""


_LIMITS = {
    "temperature": (COLDEST, WARMEST, "°C"),
    "snowfall": (0.0, HEAVIEST / HOUR, "kg/m²/h"),
    "precipitation": (0.0, np.inf, "kg/m²/h"),
    "rain_share": (0.0, 1.0, ""),
    "precipitation_type": (-np.inf, np.inf, ""),
    "snow_depth": (0.0, 30.0, "m"),
}
"""Least and greatest value of each quantity, and the unit that people read them in."""


def _reading(
    claim: Claim,
    read: Numbers,
    time: NDArray[np.float64],
    numbers: NDArray[np.int64],
    source: str,
    accumulated: bool | None,
) -> Reading:
    """A column in °C, kg/m²/s or m; raises RecordError where its unit or a value cannot be."""
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
    in_amounts = kind.dimension is FALL and name in AMOUNTS
    values = raw * kind.dimension.sizes[name] + ZEROS.get(name, 0.0)
    if in_amounts:
        values = rates(amounts_of(values, time, accumulated, numbers, claim.column, source), time)
    low, high, shown_in = _LIMITS[claim.quantity]
    wrong = (values < low) | (values > high)
    if wrong.any():
        row = int(np.argmax(wrong))
        scale = HOUR if shown_in == "kg/m²/h" else 1.0
        shown = f"{values[row] * HOUR:g} {shown_in}" if in_amounts else f"{raw[row]:g} {name}"
        allowed = f"{low * scale:g} to {high * scale:g} {shown_in}" if high < np.inf else f"{low:g} or more"
        where = f"row {numbers[row]}, column '{claim.column}'"
        message = f"is {shown if shown_in else f'{raw[row]:g}'}; allowed: {allowed}".rstrip()
        raise RecordError([Problem(where, message)], source)
    return Reading(claim.column, values, in_amounts)


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
