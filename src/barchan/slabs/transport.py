"""Slab transport of some steps, shared among threads where that gives the same bits as one thread."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from barchan.kernels.bed.state import Stacks
from barchan.kernels.slabs.plan import Plan, near_of, plan_rounds, reach_of
from barchan.kernels.slabs.state import (
    FULL,
    NO_SLAB,
    STRAYED,
    TALLY_SIZE,
    Flights,
    Round,
    Schedule,
    SlabRules,
    Work,
)
from barchan.slabs.arguments import work_space
from barchan.streams import derive
from barchan.wind.segment import Segment

_POLLS = 4_000_000
"""Polls of the rounds planned together, where they are more than one: some tenths of a second."""

_MOST_ROUNDS = 64

_LEAST_POLLS = 4096
"""Polls of a round below which a second thread is not worth its start."""

_FLIGHTS = 1024
"""Slabs that hop far in a round for which there is room at first."""

_FARTHEST = 4
"""Bands on either side that a band waits for at most, before one thread runs them all."""


@dataclass
class Transport:
    """The rules, stacks and work space of some steps of slab transport."""

    stacks: Stacks
    rules: SlabRules
    schedule: Schedule
    key: int
    counts: NDArray[np.int64] = field(default_factory=lambda: np.zeros(TALLY_SIZE, np.int64))
    distance: int = 1
    """Bands on either side that a band waits for."""
    _work: list[Work] = field(default_factory=list)

    def work(self, number: int = 0) -> Work:
        """The work space of a thread."""
        while len(self._work) <= number:
            new = work_space(self.rules, self.schedule)
            if self._work:
                new = new._replace(before=self._work[0].before, flights=self._work[0].flights)
            elif self.rules.ray is not None:
                room = new_flights(_FLIGHTS, new.polls.band_order.size)
                new = new._replace(before=self.stacks.surface.copy(), flights=room)
            self._work.append(new)
        return self._work[number]

    def _make_room(self) -> None:
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
        most = max(1, min(_MOST_ROUNDS, _POLLS // segment.polls))
        rounds: list[Round] = []
        for part in rounds_of(segment, self.key, self.rules, self.schedule):
            rounds.append(part)
            if len(rounds) == most:
                self._run_rounds(rounds, threads)
                rounds = []
        self._run_rounds(rounds, threads)

    def _run_rounds(self, rounds: list[Round], threads: int) -> None:
        """Run some rounds, with more room or in one thread where they need it."""
        if not rounds or self.rules.interruption[0]:
            return
        changed = [self.stacks.surface, *([] if self.stacks.sand is None else [self.stacks.sand])]
        before = [heights.copy() for heights in changed]
        while broken := self._run_in(self._useful(threads, rounds), rounds):
            if self.rules.interruption[0]:
                return
            for heights, as_they_were in zip(changed, before, strict=True):
                heights[:] = as_they_were
            if broken == FULL:
                self._make_room()
            elif broken == STRAYED:
                self.distance += 1

    def _run_in(self, threads: int, rounds: list[Round]) -> int:
        """Run some rounds in some threads; why they were broken off (``STRAYED``, ``FULL``), or 0."""
        from barchan.kernels.core.threads import with_helpers
        from barchan.kernels.slabs.bands import await_rounds, run_rounds

        plan = self._plan(threads, rounds)
        tallies = np.zeros((threads, TALLY_SIZE), np.int64)

        def help_as(number: int) -> Callable[[], None]:
            rules = self.rules._replace(orders=self.rules.orders.copy())
            work, tally = self.work(number), tallies[number]
            return lambda: run_rounds(self.stacks, rules, work, self.schedule, plan, tally)

        with with_helpers([help_as(number) for number in range(1, threads)], lambda: None):
            help_as(0)()
            broken = int(await_rounds(plan))
        if not broken:
            self.counts += tallies.sum(axis=0)
        return broken

    def _plan(self, threads: int, rounds: list[Round]) -> Plan:
        rows, bands = self.rules.grid.rows, self.work().polls.band_order.size
        near, wrap = near_of(self.schedule), self.rules.grid.wrap_across
        reach = reach_of(self.distance, rows, self.schedule, wrap) if threads > 1 else rows
        peak, bounds = int(self.stacks.surface.max()), (self.distance, near, reach)
        lands = self.rules.ray is not None
        return plan_rounds(rounds, bands, peak, bounds, lands=lands, measures=self._heights_change())

    def _heights_change(self) -> bool:
        """Whether the heights that hops are measured against change from round to round."""
        speedup, grid = self.rules.speedup, self.rules.grid
        if speedup is None:
            return False
        return speedup.deviation_weight != 0.0 or not (grid.wrap_along and grid.wrap_across)

    def _useful(self, threads: int, rounds: list[Round]) -> int:
        """How many threads can be busy with some rounds."""
        alone = self.work().unstable is not None or self.distance > _FARTHEST
        if alone or rounds[0].stop - rounds[0].start < _LEAST_POLLS:
            return 1
        bands = self.work().polls.band_order.size
        return max(1, min(threads, bands // (self.distance + 1)))


def rounds_of(segment: Segment, key: int, rules: SlabRules, schedule: Schedule) -> Iterator[Round]:
    """The rounds of polls of a segment: one a step, or where each cell has its turn parts of turns."""
    for step in range(segment.step, segment.step + segment.steps):
        step_key = derive(key, step)
        poll_key = np.uint64(derive(step_key, 0))
        last = segment.first + segment.polls
        if not schedule.each_once:
            yield Round(0, segment.first, last, np.uint64(step_key), poll_key, -1)
            continue
        cells = rules.grid.rows * rules.grid.cols
        for number in range(segment.first // cells, -(-last // cells)):
            start, stop = max(segment.first - number * cells, 0), min(last - number * cells, cells)
            yield Round(number, start, stop, np.uint64(derive(derive(step_key, 3), number)), poll_key, -1)


def new_flights(room: int, bands: int) -> Flights:
    """Room for some slabs that hop far, with none there."""
    ends = np.full(bands, NO_SLAB, np.int64), np.full(bands, NO_SLAB, np.int64)
    return Flights(np.zeros((room, 7), np.int64), *ends, np.zeros(1, np.int64))
