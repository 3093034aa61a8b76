"""Slab transport of some steps, shared among threads where that gives the same bits as one thread."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from barchan.kernels.bed.state import Stacks
from barchan.kernels.slabs.plan import Plan, plan_rounds, reach_of
from barchan.kernels.slabs.state import TALLY_SIZE, Round, Schedule, SlabRules, Work
from barchan.slabs.arguments import work_space
from barchan.streams import derive
from barchan.wind.segment import Segment

_POLLS = 4_000_000
"""Polls of the rounds planned together, where they are more than one: some tenths of a second."""

_MOST_ROUNDS = 64

_LEAST_POLLS = 4096
"""Polls of a round below which a second thread is not worth its start."""

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
            self._work.append(work_space(self.rules, self.schedule))
        return self._work[number]

    def run(self, segment: Segment, threads: int) -> None:
        """Run the polls of a segment's steps; the bits are the same for any number of threads."""
        from barchan.kernels.slabs.step import run_forced_steps

        if self.schedule.forced:
            polls = segment.first, segment.polls
            key, steps = np.uint64(self.key), (segment.step, segment.steps)
            run_forced_steps(self.stacks, self.rules, self.work(), self.schedule, key, *steps, *polls, self.counts)
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
        """Run some rounds, in one thread if a walk in several leaves the rows that its band may touch."""
        if not rounds or self.rules.interruption[0]:
            return
        while (threads := self._useful(threads, rounds)) > 1:
            before = self.stacks.surface.copy(), None if self.stacks.sand is None else self.stacks.sand.copy()
            if self._run_in(threads, rounds):
                return
            self.stacks.surface[:] = before[0]
            if self.stacks.sand is not None:
                self.stacks.sand[:] = before[1]
            self.distance += 1
        self._run_in(1, rounds)

    def _run_in(self, threads: int, rounds: list[Round]) -> bool:
        """Run some rounds in some threads; whether every walk kept to the rows that it may touch."""
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
            kept = bool(await_rounds(plan))
        if kept:
            self.counts += tallies.sum(axis=0)
        return kept

    def _plan(self, threads: int, rounds: list[Round]) -> Plan:
        rows, bands = self.rules.grid.rows, self.work().polls.band_order.size
        reach = rows
        if threads > 1:
            reach = reach_of(self.distance, rows, self.schedule, self.rules.grid.wrap_across)
        peak = int(self.stacks.surface.max())
        return plan_rounds(rounds, bands, peak, self.distance, reach, in_step=self._heights_change())

    def _heights_change(self) -> bool:
        """Whether the heights that hops are measured against change from round to round."""
        speedup, grid = self.rules.speedup, self.rules.grid
        if speedup is None:
            return False
        return speedup.deviation_weight != 0.0 or not (grid.wrap_along and grid.wrap_across)

    def _useful(self, threads: int, rounds: list[Round]) -> int:
        """How many threads can be busy with some rounds."""
        alone = self.rules.axis is None or self.work().unstable is not None or self.distance > _FARTHEST
        if alone or rounds[0].stop - rounds[0].start < _LEAST_POLLS:
            return 1
        bands = self.work().polls.band_order.size
        return max(1, min(threads, bands // (self.distance + 1)))


def rounds_of(segment: Segment, key: int, rules: SlabRules, schedule: Schedule) -> Iterator[Round]:
    """The rounds of polls of a segment: one a step, or as many as go through all cells where each has its turn."""
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
