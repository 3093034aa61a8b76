"""Where iterations are cut into batches, and that simulations side by side do not disturb one another."""

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import barchan
from barchan.grains.iterations import batches
from barchan.kernels.core import threads as thread_pool
from barchan.simulation import Simulation

SMALL = {
    "barchan": 5,
    "lattice": {"rows": 32, "columns": 64, "cell_size": 0.01, "slab_height": 0.15e-3},
    "sand": {"kind": "flat", "mean": 20},
    "model": {"name": "wang_hu", "max_grains_per_cell": 1.0, "iterations_per_step": 20},
    "run": {"steps": 20, "seed": 3},
}


def test_batches_end_where_an_interval_begins():
    assert list(batches(0, 12, 1, 5, 4)) == [(0, 4), (4, 1), (5, 3), (8, 2), (10, 2)]
    assert list(batches(7, 12, 1, 5)) == [(7, 3), (10, 2)]
    assert list(batches(3, 3, 1, 5)) == []
    assert sum(count for _, count in batches(0, 5000, 1, 10**6)) == 5000


def test_simulations_at_once_in_several_threads_give_the_bits_of_each_alone(monkeypatch):
    monkeypatch.setattr(thread_pool, "LEAST", 256)
    monkeypatch.setattr(thread_pool, "thread_count", lambda: 3)

    def run(seed):
        simulation = Simulation(barchan.load(SMALL, run__seed=seed))
        for _ in range(10):
            simulation.advance(1)
        return simulation.bed.sand.copy(), simulation.model.pool.motion.copy()

    alone = [run(seed) for seed in range(4)]
    with ThreadPoolExecutor(4) as pool:
        together = list(pool.map(run, range(4)))
    for one, other in zip(alone, together, strict=True):
        np.testing.assert_array_equal(one[0], other[0])
        np.testing.assert_array_equal(one[1], other[1])


@pytest.mark.parametrize("threads", [1, 2])
def test_an_interrupted_step_leaves_no_helper_behind(monkeypatch, threads):
    monkeypatch.setattr(thread_pool, "LEAST", 256)
    monkeypatch.setattr(thread_pool, "thread_count", lambda: threads)
    simulation = Simulation(barchan.load(SMALL, model__shelter__angle=15.0))
    simulation.advance(1)

    def interrupt(_ground):
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr("barchan.grains.bed.GrainGround.raise_shelter", interrupt)
        with pytest.raises(KeyboardInterrupt):
            simulation.model.advance(simulation.bed, simulation.forcing.wind_of(0), simulation.stream)
    with thread_pool._workers[0].taken(threads - 1) as workers:
        assert len(workers) == threads - 1
        for worker in workers:
            worker.wait()
