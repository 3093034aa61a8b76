"""Slabs on one thread and on two, in turns; and how many threads the order of bands could keep busy.

For more cores than the machine has, the waiting is played through: bands of equal work are given to threads
by the rule of the kernel, which takes the first band, of the earliest step, that need not wait.
"""

import copy
import hashlib
import heapq
import statistics
import time
from dataclasses import dataclass

import numpy as np

from barchan.bed import Bed
from barchan.kernels.core import threads
from barchan.lattice import Lattice
from barchan.models import models
from barchan.streams import Stream
from barchan.wind.segment import Segment


@dataclass(frozen=True)
class Case:
    """A field of a model, 30 steps from flat to let bedforms begin, and the slabs or quanta on each cell."""

    size: int
    steps: int
    direction: float = 270.0
    model: str = "werner"
    repetitions: int = 5
    depth: int = 3
    cell_size: float = 1.0
    speed: float | None = None

    @property
    def name(self) -> str:
        wind = "" if self.direction == 270.0 else f", wind from {self.direction:g}°"
        return f"{self.model}, {self.size}²{wind}"


CASES = (
    Case(256, 200),
    Case(1024, 12),
    Case(4096, 2, repetitions=3),
    Case(256, 200, 247.5),
    Case(256, 200, 225.0),
    Case(1024, 12, 247.5),
    Case(1024, 12, 225.0),
    Case(256, 200, model="momiji"),
    Case(256, 200, model="bishop"),
    Case(256, 100, model="snow", depth=60, cell_size=0.1, speed=10.0),
    Case(1024, 10, model="snow", depth=60, cell_size=0.1, speed=10.0),
)


@dataclass(frozen=True)
class Speeds:
    """Nanoseconds a poll on one thread and on two, and whether both made the same bed."""

    one: float
    two: float
    same: bool


def measure(case: Case) -> Speeds:
    """Time a case on one thread and on two, in turns, each from the same bed."""
    lattice = Lattice(rows=case.size, columns=case.size, cell_size=case.cell_size)
    model = models()[case.model](models()[case.model].Parameters(), lattice)
    start = Bed(lattice, np.zeros(lattice.shape), np.full(lattice.shape, case.depth), layers=model.layers)
    model.initialise(start, 1)
    _advance(model, start, case, 30 if case.size < 4096 else 1, 2)
    times: dict[int, list[float]] = {1: [], 2: []}
    hashes = set()
    for _ in range(case.repetitions):
        for count in (1, 2):
            bed = copy.deepcopy(start)
            seconds = _advance(model, bed, case, case.steps, count)
            times[count].append(seconds * 1e9 / (case.steps * lattice.cells))
            digest = hashlib.sha256()
            for name in sorted(bed.arrays):
                digest.update(np.ascontiguousarray(bed.arrays[name]).tobytes())
            hashes.add(digest.digest())
    return Speeds(statistics.median(times[1]), statistics.median(times[2]), len(hashes) == 1)


def _advance(model, bed, case, steps, count):
    """Advance a bed by some steps on so many threads; the seconds that they took."""
    state = model.state()
    seconds = model.step_seconds
    segment = Segment(
        7, steps, 0, model.lattice.cells, case.direction, speed=case.speed, step_seconds=seconds
    )
    whole = threads.thread_count
    threads.thread_count = lambda: count
    try:
        began = time.perf_counter()
        model.advance(bed, segment, Stream(1, "transport"))
        return time.perf_counter() - began
    finally:
        threads.thread_count = whole
        model.restore(state)


def busy(bands: int, count: int, distance: int = 1, steps: int = 60, serial: float = 0.0) -> float:
    """How many of ``count`` threads are busy on the average with a field of so many bands.

    A band of a step takes one unit of time; what one thread does in each step takes the share ``serial`` of
    the work of all bands, and no band of a step begins before.
    """
    random = np.random.default_rng(1)
    places = np.array([random.permutation(bands) for _ in range(steps)])
    done = np.zeros(bands, int)
    running: set[int] = set()
    begun = 0
    counting = False
    events: list[tuple[float, int]] = []
    now, free = 0.0, count
    while done.min() < steps:
        started = True
        while free and started:
            started = False
            if begun < min(steps, done.min() + 4) and not counting:
                heapq.heappush(events, (now + serial * bands, -1))
                counting, started, free = True, True, free - 1
                continue
            ready = [
                (done[band], places[done[band], band], band)
                for band in range(bands)
                if band not in running and done[band] < begun and not _waits(band, done, places, distance)
            ]
            if ready:
                band = min(ready)[2]
                running.add(band)
                heapq.heappush(events, (now + 1.0, band))
                started, free = True, free - 1
        now, band = heapq.heappop(events)
        free += 1
        if band < 0:
            counting, begun = False, begun + 1
        else:
            running.discard(band)
            done[band] += 1
    return steps * bands * (1.0 + serial) / now


def _waits(band, done, places, distance):
    step, bands = done[band], len(done)
    for other in {(band + k) % bands for k in range(-distance, distance + 1)} - {band}:
        if done[other] < step + (places[step, other] < places[step, band]):
            return True
    return False
