"""The measures of a running simulation, taken now and then so that they cost little."""

import math
import time
from collections import deque
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.analysis.time_series import LAGS, MeasuredFrame, measures_of
from barchan.directions import downwind
from barchan.measures import crest_orientation, migration, streamwise_slopes
from barchan.simulation import Simulation
from barchan.studio.worker.frame_fields import wind_over

LEAST_PAUSE = 0.25
"""Seconds from one look to the next, at least."""

SHARE = 0.02
"""Share of the time that may go into measuring."""

MOST_ROWS = 4000
"""Rows that are kept; beyond, every second one is forgotten."""


class Gauges:
    """Looks at a simulation now and then and keeps what it measured."""

    def __init__(self) -> None:
        """Nothing seen yet."""
        self.rows: list[dict[str, Any]] = []
        self.fresh: list[dict[str, Any]] = []
        """Rows that were not sent yet."""
        self._seen: deque[tuple[int, NDArray[np.float64]]] = deque(maxlen=LAGS + 1)
        self._travel = (0.0, 0.0)
        self._next = 0.0

    def look(self, simulation: Simulation, at_once: bool = False) -> None:
        """Measure, if it is time to and something happened."""
        began = time.perf_counter()
        step = simulation.steps_done
        if (self._seen and self._seen[-1][0] == step) or (began < self._next and not at_once):
            return
        row = self._measured(simulation)
        self.rows.append(row)
        self.fresh.append(row)
        if len(self.rows) > MOST_ROWS:
            self.rows = self.rows[::2]
        del self.fresh[:-MOST_ROWS]
        now = time.perf_counter()
        self._next = now + max(LEAST_PAUSE, (now - began) / SHARE)

    def sent(self) -> list[dict[str, Any]]:
        """The rows that were not sent yet; they count as sent from now on."""
        fresh, self.fresh = self.fresh, []
        return fresh

    def again(self) -> None:
        """Send everything once more."""
        self.fresh = list(self.rows)

    def until(self, step: int) -> "Gauges":
        """What was measured up to a step, for another run to go on from."""
        gauges = Gauges()
        gauges.rows = [row for row in self.rows if row["step"] <= step]
        gauges.again()
        return gauges

    def _measured(self, simulation: Simulation) -> dict[str, Any]:
        moment = self._moment(simulation)
        values = {measure.name: measure.compute(moment) for measure in measures_of(simulation.scenario)}
        return {
            "step": simulation.steps_done,
            **{name: float(value) if math.isfinite(value) else None for name, value in values.items()},
        }

    def _moment(self, simulation: Simulation) -> MeasuredFrame:
        lattice, surface = simulation.lattice, simulation.elevation
        joined, direction = lattice.periodic, simulation.wind_direction
        before = self._seen[-1][0] if self._seen else simulation.steps_done
        self._seen.append((simulation.steps_done, surface))
        steps, surfaces = zip(*self._seen, strict=True)
        travelled = simulation.tally.travel_x, simulation.tally.travel_y
        travel = np.dot(downwind(direction), np.subtract(travelled, self._travel))
        self._travel = travelled
        return MeasuredFrame(
            modelled=lambda: (simulation.model, simulation.bed, wind_over(simulation)),
            sand=simulation.bed.sand,
            elevation=surface,
            scenario=simulation.scenario,
            direction=direction,
            orientation=crest_orientation(surface, lattice.cell_size, joined),
            slopes=streamwise_slopes(surface, lattice.cell_size, direction, joined),
            migration=migration(steps, surfaces, joined),
            travel=float(travel),
            steps=simulation.steps_done - before,
        )


def declared_measures(simulation: Simulation) -> list[dict[str, str]]:
    """Name, title and unit of everything that is measured."""
    return [{"name": m.name, "title": m.title, "unit": m.unit} for m in measures_of(simulation.scenario)]
