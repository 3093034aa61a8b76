"""Rounds of polls over a bed of any kind, shared among threads with the bits of one."""

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.kernels.slabs.plan import Plan, near_of, plan_rounds, reach_of
from barchan.kernels.slabs.state import FULL, STRAYED, TALLY_SIZE, Round, Schedule, SlabRules, Work
from barchan.streams import derive
from barchan.wind.segment import Segment

_POLLS = 4_000_000
"""Polls of the rounds planned together, where they are more than one: some tenths of a second."""

_MOST_ROUNDS = 64

_LEAST_POLLS = 4096
"""Polls of a round below which a second thread is not worth its start."""

_FARTHEST = 4
"""Bands on either side that a band waits for at most, before one thread runs them all."""


@dataclass(kw_only=True)
class SharedRounds(ABC):
    """Rounds of polls over one bed. A kind of bed adds its arrays, rules and work space."""

    schedule: Schedule
    counts: NDArray[np.int64] = field(default_factory=lambda: np.zeros(TALLY_SIZE, np.int64))
    """The tally of all rounds so far."""
    distance: int = 1
    """Bands on either side that a band waits for."""
    _work: list[Work] = field(default_factory=list)

    @property
    @abstractmethod
    def lattice_rules(self) -> SlabRules:
        """The rules that beds of every kind have."""

    @property
    @abstractmethod
    def alone(self) -> bool:
        """Whether the rules leave all work to one thread."""

    @property
    def lands(self) -> bool:
        """Whether what hops far lands at the end of a round."""
        return False

    @property
    def heights_change(self) -> bool:
        """Whether the heights that hops are measured against change from round to round."""
        return False

    @abstractmethod
    def changed(self) -> list[NDArray[Any]]:
        """The arrays of the bed that polls change, the surface first."""

    @abstractmethod
    def bed_and_rules(self) -> tuple[Any, Any]:
        """The bed and its rules as kernels take them; nothing in them is scratch that threads would share."""

    @abstractmethod
    def new_work(self) -> Work:
        """The work space of one more thread."""

    def work(self, number: int = 0) -> Work:
        """The work space of a thread."""
        while len(self._work) <= number:
            self._work.append(self.new_work())
        return self._work[number]

    def make_room(self) -> None:
        """Make more room for what hops far, where it lands at the end of a round."""
        raise NotImplementedError("nothing hops far over this bed")

    def run_all(self, rounds: Iterable[Round], polls: int, threads: int) -> None:
        """Run rounds of so many polls each; the bits are the same for any number of threads."""
        most = max(1, min(_MOST_ROUNDS, _POLLS // polls))
        some: list[Round] = []
        for part in rounds:
            some.append(part)
            if len(some) == most:
                self._run_rounds(some, threads)
                some = []
        self._run_rounds(some, threads)

    def _run_rounds(self, rounds: list[Round], threads: int) -> None:
        """Run some rounds, with more room or in one thread where they need it."""
        interruption = self.lattice_rules.interruption
        if not rounds or interruption[0]:
            return
        threads = self._useful(threads, rounds)
        changed = self.changed() if self.lands or threads > 1 else []
        before = [heights.copy() for heights in changed]
        while broken := self._run_in(threads, rounds):
            if interruption[0]:
                return
            for heights, as_they_were in zip(changed, before, strict=True):
                heights[:] = as_they_were
            if broken == FULL:
                self.make_room()
            elif broken == STRAYED:
                self.distance += 1
            threads = self._useful(threads, rounds)

    def _run_in(self, threads: int, rounds: list[Round]) -> int:
        """Run some rounds in some threads; why they were broken off (``STRAYED``, ``FULL``), or 0."""
        from barchan.kernels.core.threads import with_helpers
        from barchan.kernels.slabs.bands import await_rounds, run_rounds

        plan = self._plan(threads, rounds)
        tallies = np.zeros((threads, TALLY_SIZE), np.int64)

        def help_as(number: int) -> Callable[[], None]:
            bed, rules = self.bed_and_rules()
            work, tally = self.work(number), tallies[number]
            return lambda: run_rounds(bed, rules, work, self.schedule, plan, tally)

        with with_helpers([help_as(number) for number in range(1, threads)], lambda: None):
            help_as(0)()
            broken = int(await_rounds(plan))
        if not broken:
            self.counts += tallies.sum(axis=0)
        return broken

    def _plan(self, threads: int, rounds: list[Round]) -> Plan:
        grid, bands = self.lattice_rules.grid, self.work().polls.band_order.size
        distance, reach = bands, grid.rows  # one thread: a poll may raise, or look at, cells of any band
        if threads > 1:
            distance = self.distance
            reach = reach_of(distance, grid.rows, self.schedule, grid.wrap_across)
        peak, bounds = int(self.changed()[0].max()), (distance, near_of(self.schedule), reach)
        return plan_rounds(rounds, bands, peak, bounds, lands=self.lands, measures=self.heights_change)

    def _useful(self, threads: int, rounds: list[Round]) -> int:
        """How many threads can be busy with some rounds."""
        if self.alone or self.distance > _FARTHEST or rounds[0].stop - rounds[0].start < _LEAST_POLLS:
            return 1
        bands = self.work().polls.band_order.size
        return max(1, min(threads, bands // (self.distance + 1)))


def rounds_of(segment: Segment, key: int, cells: int, schedule: Schedule) -> Iterator[Round]:
    """The rounds of polls of a segment: one a step, or where each cell has its turn parts of turns."""
    for step in range(segment.step, segment.step + segment.steps):
        step_key = derive(key, step)
        poll_key = np.uint64(derive(step_key, 0))
        last = segment.first + segment.polls
        if not schedule.each_once:
            yield Round(0, segment.first, last, np.uint64(step_key), poll_key, -1)
            continue
        for number in range(segment.first // cells, -(-last // cells)):
            start, stop = max(segment.first - number * cells, 0), min(last - number * cells, cells)
            yield Round(number, start, stop, np.uint64(derive(derive(step_key, 3), number)), poll_key, -1)
