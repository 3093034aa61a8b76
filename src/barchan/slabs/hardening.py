"""Hardening as the Prague thesis has it: snow that resists the wind the more the denser it packs."""

import math
from collections.abc import Iterable
from itertools import pairwise
from typing import Literal, Self

import numpy as np
from pydantic import ValidationError, model_validator

from barchan.parameters import Parameters, mistake, parameter

COLDEST, WARMEST = -20.0, 0.0
"""Temperatures (°C) between which the thesis lets its user choose."""

IMMOBILE = 1.0 - 1e-9
"""Resistance from which on snow does not move: 1 but for rounding."""

LEAST_GAIN = 1e-6
"""Density (kg/m³) below which a gain is rounding."""

RIPPLES = "Prague thesis, Table 6.7"
ASSUMED = "ours: assumed, read from the picture in the Prague thesis, Fig. 4.3"


class FreshSnow(Parameters):
    """A point of the curve of the density of fresh snow."""

    temperature: float = parameter(
        unit="°C", ge=-90, le=60, meaning="Temperature of the air.", source=ASSUMED
    )
    density: float = parameter(
        unit="kg/m³", ge=1, le=917, meaning="Density of snow that falls at that temperature.", source=ASSUMED
    )


class PackedSnow(Parameters):
    """A point of the curve of the density of a snowpack."""

    day: float = parameter(unit="days", ge=0, le=10_000, meaning="Age of the pack.", source=ASSUMED)
    density: float = parameter(
        unit="kg/m³", ge=1, le=917, meaning="Density of a pack of that age.", source=ASSUMED
    )


def _fresh_snow() -> list[FreshSnow]:
    pairs = (-20, 70), (-15, 60), (-10, 65), (-5, 60), (-2, 90), (0, 120)
    return [FreshSnow(temperature=float(x), density=float(y)) for x, y in pairs]


def _packed_snow() -> list[PackedSnow]:
    pairs = (0, 80), (10, 115), (20, 140), (40, 175), (60, 200), (80, 220), (100, 235), (150, 265)
    return [PackedSnow(day=float(x), density=float(y)) for x, y in pairs]


class Hardening(Parameters):
    """How snow hardens from day to day, by its density and the temperature of the air."""

    increment: Literal["curve", "density"] = parameter(
        "curve",
        unit="-",
        meaning="How much denser snow gets in a day: by the rise of the pack's curve in that day, or by that "
        "rise relative to the curve, times the snow's own density; both times the factor of temperature.",
        source="curve: Prague thesis, Alg. 9; density: Prague thesis, §5.12, text",
    )
    locks_after: int = parameter(
        98,
        unit="days",
        ge=1,
        le=10_000,
        meaning="Day on which snow that is kept at -20 °C becomes immobile; resistance per density follows.",
        source="Prague thesis, §6.8: the run of Table 6.7 ended after 98 steps",
    )
    cold_factor: float = parameter(
        0.32,
        unit="-",
        ge=0.001,
        le=1,
        meaning="Factor on the day's gain of density at -20 °C; it rises on a straight line to 1 at 0 °C.",
        source="ours: assumed, so that the thesis's Fig. 6.32 ends on day 51 as it says",
    )
    temperature: float = parameter(
        COLDEST,
        unit="°C",
        ge=COLDEST,
        le=WARMEST,
        live=True,
        meaning="Temperature of the air where neither the wind nor the weather states it.",
        source=RIPPLES,
    )
    fresh_snow: list[FreshSnow] = parameter(
        _fresh_snow,
        unit="-",
        min_length=2,
        max_length=100,
        meaning="Density of fresh snow against temperature: straight between the points, held beyond them.",
        source=ASSUMED,
    )
    packed_snow: list[PackedSnow] = parameter(
        _packed_snow,
        unit="-",
        min_length=2,
        max_length=100,
        meaning="Density of a pack against its age: straight between the points, held beyond them.",
        source=ASSUMED,
    )

    @model_validator(mode="after")
    def _hardens(self) -> Self:
        found = [
            mistake((curve, at, key), f"is {later} after {earlier}; allowed: {key}s that increase")
            for curve, key in (("fresh_snow", "temperature"), ("packed_snow", "day"))
            for at, (earlier, later) in enumerate(
                pairwise(getattr(point, key) for point in getattr(self, curve)), start=1
            )
            if later <= earlier
        ]
        found += [
            mistake(
                ("packed_snow", at, "density"),
                f"is {later} after {earlier}; allowed: no densities that fall",
            )
            for at, (earlier, later) in enumerate(pairwise(p.density for p in self.packed_snow), start=1)
            if later < earlier
        ]
        if not found and self.rise(self.locks_after - 1)[0] == 0.0:
            text = f"is {self.locks_after}, but the pack of packed_snow gets no denser on that day"
            found = [mistake(("locks_after",), f"{text}; allowed: a day on which it does")]
        elif not found and self.cold_gain() < LEAST_GAIN:
            text = f"is {self.locks_after}, but by then snow at {COLDEST:g} °C is no denser than at first"
            found = [mistake(("locks_after",), f"{text}; allowed: a day by which packed_snow rises")]
        if found:
            raise ValidationError.from_exception_data(type(self).__name__, found)
        return self

    def fresh_density(self, temperature: float) -> float:
        """Density (kg/m³) of snow that falls at a temperature (°C)."""
        return _along([(point.temperature, point.density) for point in self.fresh_snow], temperature)

    def rise(self, day: int) -> tuple[float, float]:
        """By how much a pack gets denser from a day to the next, and its density on that day (kg/m³)."""
        curve = [(point.day, point.density) for point in self.packed_snow]
        before = _along(curve, float(day))
        return _along(curve, day + 1.0) - before, before

    def gain(self, day: int, density: float, temperature: float) -> float:
        """By how much snow of a density gets denser on a day of the run, at a temperature (kg/m³)."""
        share = (temperature - COLDEST) / (WARMEST - COLDEST)
        rise, packed = self.rise(day)
        relative = 1.0 if self.increment == "curve" else density / packed
        return (self.cold_factor + (1.0 - self.cold_factor) * share) * rise * relative

    def cold_gain(self) -> float:
        """Density (kg/m³) that snow gains in ``locks_after`` days at -20 °C."""
        density = fresh = self.fresh_density(COLDEST)
        for day in range(self.locks_after):
            density += self.gain(day, density, COLDEST)
        return density - fresh

    def resistance_per_density(self) -> float:
        """Resistance that snow gains with density (m³/kg): 1 over the gain of ``locks_after`` cold days."""
        return 1.0 / self.cold_gain()

    def day_of_locking(self, temperatures: Iterable[float]) -> int | None:
        """The day on which snow becomes immobile under the temperatures (°C) of its days; None: on none."""
        factor, density, resistance = self.resistance_per_density(), math.nan, 0.0
        for day, temperature in enumerate(temperatures):
            density = self.fresh_density(temperature) if day == 0 else density
            gain = self.gain(day, density, temperature)
            density, resistance = density + gain, resistance + factor * gain
            if resistance >= IMMOBILE:
                return day + 1
        return None

    @property
    def last_day(self) -> int:
        """The day after which a pack gets no denser."""
        return math.ceil(self.packed_snow[-1].day)


def _along(points: list[tuple[float, float]], at: float) -> float:
    x, y = zip(*points, strict=True)
    return float(np.interp(at, x, y))
