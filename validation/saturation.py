"""Ridges in a row of 1024 cells with deep sand: Momiji's wind delays their merging (Elder 2009).

30 slabs a cell, no erosion in shadow, angle of repose 33.7°. Elder (2009): Werner's dunes are one after about
150,000 cycles; with wind speed-up there are still half a dozen after more than a million. Ridges are what
stands more than the mean height, after smoothing over five cells; 3 seeds.
"""

import numpy as np
from scipy.ndimage import gaussian_filter1d

import barchan
from validation.study import Row, over_seeds, spread

TITLE = "How long ridges stay apart"

TIMES = (10_000, 150_000, 1_000_000)
MODELS = {
    "werner": {"name": "werner", "lee_erosion": False, "repose_angle": 33.7, "repose_test": "after"},
    "momiji": {"name": "momiji"},
}


def ridges(model, seed):
    scenario = barchan.load(
        "transverse",
        lattice__rows=1,
        lattice__columns=1024,
        sand__mean=30,
        model=MODELS[model],
        run__steps=TIMES[-1],
        run__seed=seed,
    )
    simulation = barchan.Simulation(scenario)
    result = {}
    for time in TIMES:
        simulation.advance(time - simulation.steps_done)
        surface = gaussian_filter1d(simulation.elevation[0], 5.0, mode="wrap")
        above = surface > surface.mean()
        result[str(time)] = float(np.sum(above & ~np.roll(above, 1)))
    return result


def rows():
    published = {
        ("werner", 150_000): "1",
        ("momiji", 1_000_000): "about 6",
    }
    results = over_seeds(ridges, [(model,) for model in MODELS], (1, 2, 3))
    for model, result in zip(MODELS, results, strict=True):
        for time in TIMES:
            what = f"{model}: ridges after {time:,} steps"
            yield Row(what, published.get((model, time), "-"), spread(result[str(time)]))


READING = """
Both come out as Elder (2009) has it: Werner's dunes are one or two by 150,000 steps, Momiji's stay half a
dozen beyond a million.
"""
