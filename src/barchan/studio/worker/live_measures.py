"""The measures of a running simulation, taken so seldom that they cost little."""

import math
from typing import Any

from barchan.analysis.declared_measures import measures_of
from barchan.analysis.frame_measurer import FrameMeasurer
from barchan.simulation import Simulation
from barchan.studio.worker.time_budget import TimeBudget

LEAST_PAUSE = 0.25
"""Seconds from one measurement to the next, at least."""

SHARE = 0.02
"""Share of the time that may go into measuring."""

MOST_ROWS = 4000
"""Rows that are kept; beyond, every second one is forgotten."""


class LiveMeasures:
    """Measures a simulation at intervals and keeps a row for each measurement."""

    def __init__(self) -> None:
        """Begin without any row."""
        self.rows: list[dict[str, Any]] = []
        self._unsent: list[dict[str, Any]] = []
        self._budget = TimeBudget(SHARE, LEAST_PAUSE)
        self._measurer: FrameMeasurer | None = None

    def take(self, simulation: Simulation, at_once: bool = False) -> None:
        """Measure, if the time for it has come or ``at_once``, and steps were done since."""
        measurer = self._measurer = self._measurer or FrameMeasurer(simulation.scenario)
        if measurer.last_step == simulation.steps_done or not (at_once or self._budget.is_due):
            return
        with self._budget.spending():
            row = _row(simulation, measurer)
        self.rows.append(row)
        self._unsent.append(row)
        if len(self.rows) > MOST_ROWS:
            self.rows = self.rows[::2]
        del self._unsent[:-MOST_ROWS]

    def unsent(self) -> list[dict[str, Any]]:
        """The rows that were not sent yet; they count as sent from now on."""
        rows, self._unsent = self._unsent, []
        return rows

    def resend(self) -> None:
        """Let all rows count as not sent."""
        self._unsent = list(self.rows)

    def until(self, step: int) -> "LiveMeasures":
        """The rows up to a step, for another run that continues from there."""
        earlier = LiveMeasures()
        earlier.rows = [row for row in self.rows if row["step"] <= step]
        earlier.resend()
        return earlier


def _row(simulation: Simulation, measurer: FrameMeasurer) -> dict[str, Any]:
    """The measures of a simulation as it is now, by name, and why some should not be quoted.

    None stands where one has no value.
    """
    tally = simulation.tally
    frame = measurer.measured(
        simulation.steps_done,
        simulation.bed,
        simulation.forcing,
        simulation.wind_direction,
        (tally.travel_x, tally.travel_y),
        lambda: (simulation.model, simulation.bed, simulation.last_segment),
    )
    found = [measure.of(frame) for measure in measures_of(simulation.scenario)]
    return {
        "step": simulation.steps_done,
        "values": {v.measure.name: v.value if math.isfinite(v.value) else None for v in found},
        "doubts": {v.measure.name: v.doubt for v in found if v.doubt},
    }


def declared_measures(simulation: Simulation) -> list[dict[str, str]]:
    """Name, title and unit of every measure, and what an angle is counted from."""
    return [
        {"name": m.name, "title": m.title, "unit": m.unit, "reference": m.reference}
        for m in measures_of(simulation.scenario)
    ]
