"""The Prague thesis's snow: Werner's slabs, which hold the better the denser the snow packs."""

import math
from collections.abc import Sequence
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from barchan.bed import Bed
from barchan.fields import FieldInfo
from barchan.lattice import Lattice
from barchan.model import Curve, ModelMeasure
from barchan.parameters import parameter, redeclared
from barchan.slabs.hardening import COLDEST, IMMOBILE, RIPPLES, WARMEST, Hardening
from barchan.slabs.model import SlabModel
from barchan.slabs.parameters import SlabParameters
from barchan.wind.clock import DAY
from barchan.wind.forcing import Forcing
from barchan.wind.segment import Segment
from barchan.wind.weather import Weather


class SnowWernerParameters(SlabParameters):
    """Parameters of the Prague thesis's snow."""

    name: Literal["snow_werner"] = parameter("snow_werner", unit="-", meaning="The Prague thesis's snow.")
    hop_length: float = redeclared(SlabParameters, "hop_length", 20.0, RIPPLES)
    lee_erosion: bool = redeclared(SlabParameters, "lee_erosion", True, "Werner 1995")
    repose_angle: float = redeclared(SlabParameters, "repose_angle", 30.0, RIPPLES)
    repose_test: Literal["before", "after"] = redeclared(
        SlabParameters, "repose_test", "before", "Prague thesis, Alg. 4 and 5"
    )
    hardening: Hardening = Field(
        default_factory=Hardening, description="How snow hardens; its two curves and its factor are assumed."
    )


RESISTANCE = FieldInfo("resistance", "float64", "1", "resistance of snow to the wind")


class SnowWerner(SlabModel):
    """Snow ripples as the Prague thesis makes them: slabs after Werner that harden day by day.

    A step is a day. Slabs are polled, carried and dropped as in Werner's model, but each cell has a
    resistance R: a polled cell gives a slab with probability 1 - R, and a slab that lands hops on with
    (1 - p)(1 - R), where p is ``p_s`` on snow and ``p_ns`` on bare ground. After each day d

        R <- R + kappa s(T) [D(d + 1) - D(d)],

    with D the density of an ageing pack (``packed_snow``), T the day's mean temperature and s a factor from
    ``cold_factor`` at -20 °C to 1 at 0 °C. With ``increment`` "density" the rise is relative to D and times
    the snow's own density, which starts as that of ``fresh_snow`` at the temperature of the first day.
    kappa is such that at -20 °C snow is immobile, R = 1, on day ``locks_after``. Then the run ends; the day
    is predicted before it starts.

    Known deviations: the thesis shows its curves in pictures only; they are assumed here, and so is the
    factor of temperature. Scaled from 0 to 1, as the thesis writes, its own run at -20 °C would never
    harden. Real snow bonds within a day or so: this is the published rule, not a model of sintering.
    """

    name = "snow_werner"
    title = "Snow after Werner (Prague thesis)"
    citation = (
        "Prague thesis, §4.8, 5.12 and 6.8: an experimental model of snow, after Werner, B. T. (1995). "
        "Eolian dunes: computer simulations and attractor interpretation. Geology 23(12), 1107-1110."
    )
    material = "snow"
    temperature_range = (COLDEST, WARMEST)
    Parameters = SnowWernerParameters
    parameters: SnowWernerParameters
    fields = (RESISTANCE,)
    measures = (
        ModelMeasure(
            "mean_resistance",
            "mean resistance",
            "-",
            lambda _model, bed, _wind: float(bed.arrays["resistance"].mean()),
        ),
    )

    def __init__(self, parameters: Any, lattice: Lattice) -> None:
        """Set the model up before the first day."""
        super().__init__(parameters, lattice)
        self._per_density = self.parameters.hardening.resistance_per_density()
        self._density = 0.0
        self._immobile_on = 0
        self._today: list[tuple[float, float]] = []

    def initialise(self, bed: Bed, seed: int) -> None:
        """Lay snow that does not resist the wind yet."""
        super().initialise(bed, seed)
        bed.add(RESISTANCE, np.zeros(self.lattice.shape))

    @property
    def step_seconds(self) -> float | None:
        """A day (s)."""
        return DAY

    def mobility(self, bed: Bed, direction: float) -> NDArray[np.float64]:
        """What the snow's resistance leaves to the wind."""
        return 1.0 - bed.arrays["resistance"]

    def steps_until_update(self, segment: Segment) -> int:
        """One: snow hardens every day."""
        return 1

    def after_steps(self, bed: Bed, segment: Segment) -> None:
        """Let snow harden at the end of a day."""
        self._today.append((segment.share, self._temperature(segment.weather)))
        if segment.ends:
            self._harden(bed, segment.step, _mean(self._today))
            self._today = []

    def _harden(self, bed: Bed, day: int, temperature: float) -> None:
        hardening = self.parameters.hardening
        if not self._density:
            self._density = hardening.fresh_density(temperature)
        gain = hardening.gain(day, self._density, temperature)
        self._density += gain
        resistance = bed.arrays["resistance"]
        resistance += self._per_density * gain
        resistance[resistance >= IMMOBILE] = 1.0
        if not self._immobile_on and (resistance == 1.0).all():
            self._immobile_on = day + 1

    def _temperature(self, weather: Weather) -> float:
        """The temperature (°C) that the forcing states, or else the model's own."""
        stated = weather.temperature
        return self.parameters.hardening.temperature if stated is None else self.held_temperature(stated)

    def finished(self, bed: Bed) -> str | None:
        """The day on which the last snow became immobile, once it is."""
        return f"immobile on day {self._immobile_on}" if self._immobile_on else None

    def state(self) -> dict[str, NDArray | float | int | str]:
        """Density of the snow (kg/m³; 0 before the first day); the day it became immobile (0: not yet)."""
        return {"density": self._density, "immobile_on": self._immobile_on}

    def restore(self, state: dict[str, Any]) -> None:
        """Take up a remembered state."""
        self._density = float(state["density"])
        self._immobile_on = int(state["immobile_on"])

    def facts(self) -> dict[str, str]:
        """The two constants that are fixed on the thesis's runs, beside the angles of repose."""
        hardening = self.parameters.hardening
        fixed = f"so that snow at {COLDEST:g} °C is immobile on day {hardening.locks_after}"
        return {
            **super().facts(),
            "resistance per density": f"{self._per_density:.3g} m³/kg, {fixed}",
            "factor of temperature": f"{hardening.cold_factor:g} at {COLDEST:g} °C to 1 at {WARMEST:g} °C "
            "(assumed)",
        }

    def forecast(self, forcing: Forcing) -> dict[str, str]:
        """The day on which the snow will be immobile."""
        hardening = self.parameters.hardening
        runs = forcing.constant_intervals(0, hardening.last_day)
        days = (
            _mean([(interval.share, self._temperature(interval.weather)) for interval in intervals])
            for _, steps, intervals in runs
            for _ in range(steps)
        )
        found = hardening.day_of_locking(days)
        never = f"never: packed_snow gets no denser after day {hardening.last_day}"
        return {"predicted to be immobile": never if found is None else f"on day {found}"}

    @classmethod
    def curves(cls, parameters: SnowWernerParameters) -> list[Curve]:
        """Densities of fresh and of packed snow."""
        fresh, packed = parameters.hardening.fresh_snow, parameters.hardening.packed_snow
        return [
            Curve(
                title="fresh snow",
                x=tuple(point.temperature for point in fresh),
                y=tuple(point.density for point in fresh),
                x_title="temperature of the air (°C)",
                y_title="density (kg/m³)",
                remark="assumed",
            ),
            Curve(
                title="packed snow",
                x=tuple(point.day for point in packed),
                y=tuple(point.density for point in packed),
                x_title="age (days)",
                y_title="density (kg/m³)",
                remark="assumed",
            ),
        ]


def _mean(parts: Sequence[tuple[float, float]]) -> float:
    """Mean temperature of a day, from shares of the day and their temperatures."""
    return math.fsum(share * value for share, value in parts) / math.fsum(share for share, _ in parts)
