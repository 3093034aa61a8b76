"""Dimensions of simulated dunes beside those of dunes in nature, by the measures of `barchan measure`.

Last frames of presets, 3 seeds each. Height over width is the median over single dunes that stand apart and
are at least eight cells wide; side slopes are the slopes across the wind, each weighted with itself; the
slip face is the 95th percentile of lee slopes. Models have no size of their own: a cell may be one metre or
five, so ratios and angles are compared, not lengths. A slab is a third of a cell high unless a preset says
otherwise, and relief grows in proportion to it.
"""

import numpy as np

import barchan
from barchan.measures.slopes import streamwise_slopes
from barchan.survey.height_field import HeightField
from barchan.survey.measuring import Survey
from validation.study import Row, over_seeds, spread

TITLE = "Proportions of dunes"

SEEDS = (1, 2, 3)

WIDE = 8
"""Cells across the wind that a dune has at least."""

BARCHANS = ("barchans", "momiji-barchans", "bishop-barchans", "stretched-barchans")

RIDGES = {"transverse": {}, "momiji-transverse": {"run__steps": 2000, "run__save_every": 2000}}


def dimensions(preset, changes, seed):
    """Ratios and angles of the last frame."""
    scenario = barchan.load(preset, run__seed=seed, **dict(changes))
    last = barchan.simulate(scenario).isel(step=-1)
    cell, periodic = scenario.lattice.cell_size, scenario.lattice.periodic
    field = HeightField.of_array(last["elevation"].values, cell, periodic)
    seen = Survey(field, float(last["wind_direction"]))
    dunes = [shape for _, shape in seen.dunes if shape.width >= WIDE * cell]
    across = streamwise_slopes(seen.heights, cell, (seen.wind + 90.0) % 360.0, periodic)
    return {
        "ratio": float(np.median([shape.height / shape.width for shape in dunes])) if dunes else np.nan,
        "dunes": len(dunes),
        "side": (across.windward + across.lee) / 2,
        "windward": seen.slopes.windward,
        "slip": seen.slip_face_angle,
        "relief": seen.bedform_height / seen.spacing,
    }


def rows():
    cases = [(preset, ()) for preset in BARCHANS] + [(p, tuple(c.items())) for p, c in RIDGES.items()]
    results = dict(zip([preset for preset, _ in cases], over_seeds(dimensions, cases, SEEDS), strict=True))
    for preset in BARCHANS:
        found = results[preset]
        dunes = ", ".join(f"{count:.0f}" for count in found["dunes"])
        yield _row(f"`{preset}`: height over width ({dunes} dunes)", 0.1, found["ratio"], 0.02)
        yield _row(f"`{preset}`: side slopes (°)", 11.0, found["side"], 2.0)
        yield _between(f"`{preset}`: slip face (°)", 30.0, 34.0, found["slip"])
        yield _between(f"`{preset}`: windward slope (°)", 5.0, 15.0, found["windward"])
    for preset in RIDGES:
        found = results[preset]
        yield _between(f"`{preset}`: height over spacing", 0.0, 0.1, found["relief"])
        yield _between(f"`{preset}`: slip face (°)", 30.0, 34.0, found["slip"])
        yield _between(f"`{preset}`: windward slope (°)", 5.0, 15.0, found["windward"])


def _row(what, published, values, around):
    return _between(what, published - around, published + around, values, f"about {published:g}")


def _between(what, low, high, values, stated=None):
    """Agrees where the mean lies between two values."""
    found = spread(values)
    mean = float(np.mean(values))
    verdict = "" if not np.isfinite(mean) else "agrees" if low <= mean <= high else "differs"
    return Row(what, stated or f"{low:g} to {high:g}", found, verdict)


READING = """
The height of a barchan is a tenth of its width, and its sides slope by 11° (Hesp & Hastings 1998,
abstract). Slip faces of 30 to 34° are those of the Prague thesis and of continuum models; windward slopes
of 5 to 15° and a height of at most a tenth of the spacing are quoted from memory, no source was found.

Dunes of models whose wind speeds up are too steep: slip faces of 39 to 46° where 30 to 34° are wanted,
sides of 19 to 21°. Slip faces exceed the repose angle that the scenarios state, 33.7°, because an avalanche
looks at four neighbours: two slabs of a third of a cell stand towards each face, which is 33.7° along an
axis, but a face that lies obliquely to both axes then has a slope of up to √2 · 2/3, 43.3°; what is
measured beyond that are single slabs. The option `neighbourhood` `moore` looks at corners too. Werner's
dunes with erosion in the lee are too flat towards the lee, 27 to 29°. The proportions of barchans come out:
height over width of 0.11 to 0.14 with wind that speeds up, 0.11 for stretched barchans, 0.07 for those of
Table 6.1, whose tops are low and whose bodies touch others.
"""
