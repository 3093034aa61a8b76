"""Slab transport of some steps, shared among threads where that gives the same bits as one thread."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.kernels.bed.state import Stacks
from barchan.kernels.slabs.state import NO_SLAB, Flights, SlabRules, Work
from barchan.slabs.arguments import work_space
from barchan.slabs.rounds import SharedRounds, rounds_of
from barchan.wind.segment import Segment

_FLIGHTS = 1024
"""Slabs that hop far in a round for which there is room at first."""


@dataclass(kw_only=True)
class Transport(SharedRounds):
    """The rules, stacks and work space of some steps of slab transport."""

    stacks: Stacks
    rules: SlabRules
    key: int
    """The key of the random stream."""

    @property
    def lattice_rules(self) -> SlabRules:
        """The rules."""
        return self.rules

    @property
    def alone(self) -> bool:
        """One thread runs avalanches that go on until every slope stands."""
        return self.work().unstable is not None

    @property
    def lands(self) -> bool:
        """An oblique wind carries slabs to rows far away."""
        return self.rules.ray is not None

    @property
    def heights_change(self) -> bool:
        """Where hops grow with height over the relief, or over a mean that open edges change."""
        speedup, grid = self.rules.speedup, self.rules.grid
        if speedup is None:
            return False
        return speedup.deviation_weight != 0.0 or not (grid.wrap_along and grid.wrap_across)

    def changed(self) -> list[NDArray[Any]]:
        """The surface, and the sand on a ground that is not flat."""
        return [self.stacks.surface, *([] if self.stacks.sand is None else [self.stacks.sand])]

    def bed_and_rules(self) -> tuple[Stacks, SlabRules]:
        """The stacks, and the rules with orders of neighbours to shuffle."""
        return self.stacks, self.rules._replace(orders=self.rules.orders.copy())

    def new_work(self) -> Work:
        """Work space of a thread: slabs that hop far have one home for all."""
        new = work_space(self.rules, self.schedule)
        if self._work:
            return new._replace(before=self._work[0].before, flights=self._work[0].flights)
        if self.rules.ray is not None:
            room = new_flights(_FLIGHTS, new.polls.band_order.size)
            return new._replace(before=self.stacks.surface.copy(), flights=room)
        return new

    def make_room(self) -> None:
        """Make room for twice as many flights."""
        for number, work in enumerate(self._work):
            flights = self._work[0].flights if number else work.flights
            if flights is not None and not number:
                flights = new_flights(2 * len(flights.slabs), flights.first.size)
            self._work[number] = work._replace(flights=flights)

    def run(self, segment: Segment, threads: int) -> None:
        """Run the polls of a segment's steps; the bits are the same for any number of threads."""
        from barchan.kernels.slabs.step import run_forced_steps

        if self.schedule.forced:
            polls = segment.step, segment.steps, segment.first, segment.polls
            state = self.stacks, self.rules, self.work(), self.schedule
            run_forced_steps(*state, np.uint64(self.key), *polls, self.counts)
            return
        cells = self.rules.grid.rows * self.rules.grid.cols
        rounds = rounds_of(segment, self.key, cells, self.schedule)
        self.run_all(rounds, segment.polls, threads)


def new_flights(room: int, bands: int) -> Flights:
    """Room for some slabs that hop far, with none there."""
    ends = np.full(bands, NO_SLAB, np.int64), np.full(bands, NO_SLAB, np.int64)
    return Flights(np.zeros((room, 7), np.int64), *ends, np.zeros(1, np.int64))
