"""Grains in flight: grain updates a second on one thread and on two, and the case of Szabó 2019.

A batch is an advance of some ``ITERATIONS`` iterations, as real runs make them: what an advance does once,
and the start of a helping thread, then count as much as they do there.
"""

import time
from typing import Any

import numpy as np

import barchan
from barchan.kernels.core import threads as thread_pool

CASES: tuple[tuple[str, str, dict[str, Any]], ...] = (
    ("`wang_hu`, `szabo-10`", "szabo-10", {}),
    ("`ripples`", "ripples", {}),
    ("`ripples`, 256 × 256 cells", "ripples", {"lattice__rows": 256}),
    ("`snow_grains`, nothing bonds: the work of `ripples`", "snow-grains", {}),
    ("`snow_grains`, bonds in 30 s", "snow-grains-sintering", {"model__sintering__bonding_time": 30.0}),
)

ITERATIONS = 100
"""Of a batch."""

PUBLISHED_SECONDS = 210.0
"""Wall time (s) of 3000 iterations there."""


def updates(preset: str, changes: dict[str, Any], batches: int = 40) -> tuple[float, float, bool]:
    """Millions of grain updates a second, at best, on one thread and on two in turns; whether bits agree."""
    runs = [barchan.Simulation(barchan.load(preset, run__seed=1, **changes)) for _ in range(2)]
    steps = max(1, ITERATIONS // runs[0].model.parameters.iterations_per_step)
    best = [0.0, 0.0]
    whole = thread_pool.thread_count
    try:
        for batch in range(batches + 1):
            for at, simulation in enumerate(runs):
                thread_pool.thread_count = lambda threads=at + 1: threads
                began = time.perf_counter()
                tally = simulation.advance(steps)
                rate = tally.polls / (time.perf_counter() - began) / 1e6
                best[at] = max(best[at], rate) if batch else 0.0
    finally:
        thread_pool.thread_count = whole
    return best[0], best[1], bool(np.array_equal(runs[0].bed.sand, runs[1].bed.sand))


def published_case_seconds() -> float:
    """Wall time (s) of the 3000 iterations of Szabó 2019, on as many threads as there are cores."""
    simulation = barchan.Simulation(barchan.load("szabo-10", run__seed=1))
    simulation.advance(1)
    began = time.perf_counter()
    simulation.advance(299)
    return time.perf_counter() - began
