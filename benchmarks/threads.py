"""Slabs on one thread and on two, in turns; and how many threads the order of bands could keep busy.

For more cores than the machine has, the waiting is played through: bands of equal work are given to threads
by the rule of the kernel, which takes the first band, of the earliest step, that need not wait.
"""

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
    """A field of Werner's model with three slabs a cell, 30 steps from flat to let bedforms begin."""

    size: int
    steps: int
    direction: float = 270.0
    model: str = "werner"
    repetitions: int = 5

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
)


@dataclass(frozen=True)
class Speeds:
    """Nanoseconds a poll on one thread and on two, and whether both made the same bed."""

    one: float
    two: float
    same: bool


def measure(case: Case) -> Speeds:
    """Time a case on one thread and on two, in turns, each from the same bed."""
    lattice = Lattice(rows=case.size, columns=case.size)
    model = models()[case.model](models()[case.model].Parameters(), lattice)
    start = np.full(lattice.shape, 3, np.int32)
    start = _after(model, start, case, 30 if case.size < 4096 else 1, 2)[0]
    times: dict[int, list[float]] = {1: [], 2: []}
    hashes = set()
    for _ in range(case.repetitions):
        for count in (1, 2):
            sand, seconds = _after(model, start, case, case.steps, count)
            times[count].append(seconds * 1e9 / (case.steps * lattice.cells))
            hashes.add(hashlib.sha256(sand.tobytes()).digest())
    return Speeds(statistics.median(times[1]), statistics.median(times[2]), len(hashes) == 1)


def _after(model, sand, case, steps, count):
    """The sand after some steps on so many threads, and the seconds that they took."""
    bed = Bed(model.lattice, np.zeros(model.lattice.shape), sand)
    segment = Segment(7, steps, 0, model.lattice.cells, case.direction)
    whole = threads.thread_count
    threads.thread_count = lambda: count
    try:
        began = time.perf_counter()
        model.advance(bed, segment, Stream(1, "transport"))
        return bed.sand, time.perf_counter() - began
    finally:
        threads.thread_count = whole


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
