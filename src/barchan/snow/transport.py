"""Snow that the wind takes, carries and lays down in a part of a segment."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from barchan.kernels.core.interruption import interruptible, new_interruption
from barchan.kernels.core.state import TRAVEL_UNIT
from barchan.kernels.slabs.state import TRAVEL_ACROSS, TRAVEL_ALONG, Schedule
from barchan.kernels.snow.state import SnowRules
from barchan.lattice import Lattice
from barchan.slabs.influx import INFLUX, edge_influx
from barchan.slabs.model import SHORT
from barchan.slabs.rounds import rounds_of
from barchan.snow.conditions import Conditions
from barchan.snow.drift_meter import DriftMeter
from barchan.snow.pack import Field
from barchan.snow.rounds import SnowRounds
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
        from barchan.kernels.core.threads import thread_count

        before = counts[[TRAVEL_ALONG, TRAVEL_ACROSS]].copy()
        shared = self._rounds(counts)
        threads = thread_count()
        if segment.steps * segment.polls > SHORT:
            interruption = shared.lattice_rules.interruption
            interruptible(lambda: self._poll(shared, segment, stream, threads), interruption)
        else:
            self._poll(shared, segment, stream, threads)
        travelled = counts[[TRAVEL_ALONG, TRAVEL_ACROSS]] - before
        saturated = round(self._saturated_travel(segment.polls) * TRAVEL_UNIT) * segment.steps
        drift.note(round(float(np.hypot(*travelled))), saturated)

    def _rounds(self, counts: NDArray[np.int64]) -> SnowRounds:
        slabs = self.rules.slabs._replace(interruption=new_interruption())
        schedule = Schedule(False, False, self.now.parameters.band_rows)
        rules = self.rules._replace(slabs=slabs)
        return SnowRounds(pack=self.field.pack, rules=rules, schedule=schedule, counts=counts)

    def _poll(self, shared: SnowRounds, segment: Segment, stream: Stream, threads: int) -> None:
        """The segment's steps; where snow enters across open edges it does so before each of them."""
        from barchan.kernels.snow.influx import let_enter

        rounds = rounds_of(segment, stream.key, self.lattice.cells, shared.schedule)
        if segment.influx is None:
            shared.run_all(rounds, segment.polls, threads)
            return
        saturated = self._saturated_travel(segment.polls) / self.lattice.cells
        influx = edge_influx(segment, lambda: saturated, self.lattice, self.field.frame)
        for step, part in enumerate(rounds, start=segment.step):
            own = np.uint64(derive(derive(derive(stream.key, step), INFLUX), segment.first))
            let_enter(shared.pack, shared.rules, influx, own, shared.counts)
            shared.run_all([part], segment.polls, threads)

    def _saturated_travel(self, polls: int) -> float:
        """Cells that quanta travel, all together, when flat, fresh drift is polled."""
        parameters = self.now.parameters
        hop = parameters.hop / self.lattice.cell_size
        return parameters.erosion_chance * self.now.supply * hop / parameters.p_s * polls
