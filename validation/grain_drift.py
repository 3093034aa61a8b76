"""Which way ripples of grains travel: against the wind after the published rules, downwind with splash.

Fields of 256 × 48 cells, 3 seeds. `wang_hu`: cells of 1 cm, 10 m/s, 6000 iterations; lift-off from anywhere,
as in seed 000, which reports ripples that travel against the wind, and not from faces that look downwind, as
in seed 003. `ripples`: cells of 5 mm, 40,000 iterations, grains counting 1/50 of their mass, so that the bed
changes 50 times as fast as under real wind. The drift is that of the waves between 2.5 and 20 cm long,
weighted by their power, over the last half of a run, in ten parts.
"""

from itertools import pairwise

import numpy as np

import barchan
from barchan.analysis.slopes import streamwise_slopes
from validation.study import Row, order, over_seeds, spread

TITLE = "Which way ripples of grains travel"

SEEDS = (1, 2, 3)
WAVES = 0.025, 0.2
"""Shortest and longest waves (m) that count."""


def drift(beds, cell_size, seconds):
    """Speed downwind (m/s, wind from the west) of the waves in beds that lie ``seconds`` apart."""
    spectra = [np.fft.rfft(bed - bed.mean(), axis=1) for bed in beds]
    number = np.fft.rfftfreq(beds[0].shape[1], cell_size)
    chosen = (number > 1 / WAVES[1]) & (number < 1 / WAVES[0])
    total = sum((b * a.conj()).sum(axis=0) for a, b in pairwise(spectra))
    way = -np.angle(total[chosen]) / (2 * np.pi * number[chosen])
    return float(np.average(way, weights=np.abs(total[chosen])) / seconds)


def spacing(bed, cell_size):
    """Mean wavelength (m) over the chosen waves, weighted by their power."""
    power = (np.abs(np.fft.rfft(bed - bed.mean(), axis=1)) ** 2).mean(axis=0)
    number = np.fft.rfftfreq(bed.shape[1], cell_size)
    chosen = (number > 1 / WAVES[1]) & (number < 1 / WAVES[0])
    return float(1 / np.average(number[chosen], weights=power[chosen]))


def travelled(model, cell_size, steps, seed):
    scenario = barchan.load(
        {
            "barchan": 1,
            "lattice": {"rows": 48, "columns": 256, "cell_size": cell_size, "slab_height": 0.15e-3},
            "sand": {"kind": "flat", "mean": 200},
            "model": {"iterations_per_step": 100, **model},
            "run": {"steps": steps, "seed": seed},
        }
    )
    simulation = barchan.Simulation(scenario)
    simulation.advance(steps // 2)
    beds = [simulation.elevation]
    for _ in range(10):
        simulation.advance(steps // 20)
        beds.append(simulation.elevation)
    seconds = simulation.model.step_seconds * (steps // 20)
    slopes = streamwise_slopes(beds[-1], cell_size, 270.0, (True, True))
    return {
        "drift": drift(beds, cell_size, seconds) * 1e3,
        "spacing": spacing(beds[-1], cell_size) * 100,
        "height": float(beds[-1].mean(axis=0).std()) * 2e3,
        "lee": slopes.lee,
        "windward": slopes.windward,
        "airborne": simulation.ledger.airborne / scenario.lattice.cells,
    }


def rows():
    published = {"name": "wang_hu", "wind_speed": 10.0, "lift_from_lee": True}
    cases = [
        (published, 0.01, 60),
        ({**published, "lift_from_lee": False}, 0.01, 60),
        *(
            ({"name": "ripples", "wind_speed": speed, "weight": 0.02}, 0.005, 400)
            for speed in (10.0, 12.0, 15.0)
        ),
    ]
    anywhere, stoss, *winds = over_seeds(travelled, cases, SEEDS)
    yield _drift("`wang_hu`, lift-off from anywhere", "against the wind", anywhere, -1)
    yield _drift("`wang_hu`, not from lee faces", "about none (a trial in one dimension)", stoss, -1)
    for speed, found in zip((10, 12, 15), winds, strict=True):
        yield _drift(f"`ripples`, {speed} m/s", "downwind", found, 1)
    for slow, fast, names in ((0, 1, "12 against 10"), (1, 2, "15 against 12")):
        yield order(
            f"spacing of `ripples`, {names} m/s", "more", winds[fast]["spacing"], winds[slow]["spacing"], "cm"
        )
    yield order(
        "lee slope against windward slope, `ripples`, 12 m/s",
        "steeper",
        winds[1]["lee"],
        winds[1]["windward"],
        "°",
    )
    for speed, found in zip((10, 12, 15), winds, strict=True):
        yield Row(f"parcels in the air for each cell, {speed} m/s", "–", spread(found["airborne"]))
        yield Row(
            f"height of crests (2 σ of the mean section), {speed} m/s", "–", f"{spread(found['height'])} mm"
        )


def _drift(what, published, found, sign):
    values = found["drift"]
    votes = sum(value * sign > 0 for value in values)
    return Row(
        f"drift, {what}", published, f"{spread(values)} mm/s of flight", f"{votes} of {len(values)} seeds"
    )


READING = ""
