"""Snow that the wind takes, carries and lays down in a part of a segment."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from barchan.kernels.core.interruption import interruptible
from barchan.kernels.core.state import TRAVEL_UNIT
from barchan.kernels.slabs.state import TRAVEL_ACROSS, TRAVEL_ALONG, Schedule, Work, prepared_polls
from barchan.kernels.snow.state import SnowRules
from barchan.lattice import Lattice
from barchan.slabs.influx import INFLUX, edge_influx
from barchan.slabs.model import SHORT
from barchan.snow.conditions import Conditions
from barchan.snow.drift_meter import DriftMeter
from barchan.snow.pack import Field
from barchan.streams import Stream, derive
from barchan.wind.segment import Segment


@dataclass(frozen=True)
class Transport:
    """A field under the wind of a segment, and the rules by which its snow moves."""

    field: Field
    rules: SnowRules
    now: Conditions
    lattice: Lattice

    def run(self, segment: Segment, stream: Stream, counts: NDArray[np.int64], drift: DriftMeter) -> None:
        """Run the polls of a segment; tallies are added to ``counts``, the travel of snow to ``drift``."""
        before = counts[[TRAVEL_ALONG, TRAVEL_ACROSS]].copy()
        if segment.steps * segment.polls > SHORT:
            interruptible(lambda: self._poll(segment, stream, counts), self.rules.slabs.interruption)
        else:
            self._poll(segment, stream, counts)
        travelled = counts[[TRAVEL_ALONG, TRAVEL_ACROSS]] - before
        saturated = round(self._saturated_travel(segment.polls) * TRAVEL_UNIT) * segment.steps
        drift.note(round(float(np.hypot(*travelled))), saturated)

    def _poll(self, segment: Segment, stream: Stream, counts: NDArray[np.int64]) -> None:
        """The segment's steps; where snow enters across open edges it does so before each of them."""
        from barchan.kernels.snow.step import let_enter, run_steps

        pack, rules, grid = self.field.pack, self.rules, self.rules.slabs.grid
        schedule = Schedule(False, False, self.now.parameters.band_rows)
        work = Work(prepared_polls(grid.rows, grid.cols, schedule), None)
        key, polls = np.uint64(stream.key), (segment.first, segment.polls)
        if segment.influx is None:
            run_steps(pack, rules, work, schedule, key, segment.step, segment.steps, *polls, counts)
            return
        saturated = self._saturated_travel(segment.polls) / self.lattice.cells
        influx = edge_influx(segment, lambda: saturated, self.lattice, self.field.frame)
        for step in range(segment.step, segment.step + segment.steps):
            own = np.uint64(derive(derive(derive(stream.key, step), INFLUX), segment.first))
            let_enter(pack, rules, influx, own, counts)
            run_steps(pack, rules, work, schedule, key, step, 1, *polls, counts)

    def _saturated_travel(self, polls: int) -> float:
        """Cells that quanta travel, all together, when flat, fresh drift is polled."""
        parameters = self.now.parameters
        hop = parameters.hop / self.lattice.cell_size
        return parameters.erosion_chance * self.now.supply * hop / parameters.p_s * polls
