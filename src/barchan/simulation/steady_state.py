"""When bedforms are steady: spacing, straightness and speed that stay constant."""

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from barchan.directions import downwind
from barchan.measures.migration import migration
from barchan.measures.orientation import crest_orientation
from barchan.measures.spacing import dominant_spacing
from barchan.model import Tally
from barchan.scenario import Scenario, SteadyState
from barchan.squares import bedforms_of
from barchan.wind.resultant import resultant_direction

if TYPE_CHECKING:
    from barchan.simulation.core import Simulation

LOOKS = 20
"""Looks at the bed in one window, about."""


class SteadyBedforms:
    """Ends a run when the measures of ``run.until.steady`` stay constant over its window."""

    def __init__(self, asked: SteadyState, scenario: Scenario) -> None:
        """Watch a run of ``scenario``."""
        self.asked = asked
        forcing = scenario.forcing()
        self.every = _whole_cycles(max(1, asked.window // LOOKS), forcing.wind.period(0, forcing.clock))
        self.looks = -(-asked.window // self.every) + 1
        lattice = scenario.lattice
        self.cell_size = lattice.cell_size
        self.periodic = lattice.periodic
        self.seen: list[list[float]] = []
        self.previous = np.zeros((0, 0))

    def check(self, simulation: "Simulation", _tally: Tally) -> str | None:
        """Measure the bed; the reason to end, once the window's measures are constant."""
        bed = simulation.bed
        surface = bedforms_of(bed)
        hop = getattr(simulation.scenario.model, "hop_length", 1.0)
        wind = resultant_direction(simulation.forcing, max(simulation.steps_done - 1, 0), hop)
        if math.isnan(wind):
            wind = simulation.wind_direction
        spacing = dominant_spacing(surface, self.cell_size, wind, self.periodic)
        straightness = crest_orientation(surface, self.cell_size, self.periodic).coherence
        speed = float("nan")
        if self.previous.size:
            moved = migration([0, self.every], [self.previous, surface], self.periodic)
            speed = moved.along(*downwind(wind))
        self.previous = surface
        self.seen = [*self.seen, [spacing, straightness, speed]][-self.looks :]
        return self._verdict()

    def _verdict(self) -> str | None:
        measures = np.array(self.seen)
        if len(measures) < self.looks or not np.isfinite(measures).all():
            return None
        steps = (self.looks - 1) * self.every
        spacing, straightness, speed = measures.mean(axis=0)
        slowest = 1 / steps  # less than a cell in the whole window: bedforms that stand
        scale = np.array([spacing, 1.0, max(abs(speed), slowest)])
        if (np.ptp(measures, axis=0) > self.asked.tolerance * scale).any():
            return None
        return (
            f"steady for {steps} steps: spacing {spacing:.3g} m, straightness {straightness:.2f}, "
            f"speed {round(speed, 6) + 0.0:.3g} cells per step"
        )

    def state(self) -> dict[str, Any]:
        """The observations up to now."""
        return {"seen": self.seen, "previous": self.previous}

    def restore(self, state: dict[str, Any]) -> None:
        """Take up what was seen before."""
        self.seen = state["seen"]
        self.previous = state["previous"]


def _whole_cycles(steps: int, cycle: float) -> int:
    """About as many steps, and as many whole cycles of the wind as they need: dunes swing within one."""
    if not 1.0 <= cycle < math.inf:
        return steps
    return round(cycle * math.ceil(steps / cycle))
