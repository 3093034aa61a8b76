"""The horns of one barchan, grown out of a round heap, at several angles to the lattice.

Momiji's model works on a round heap (a Gaussian 7 m high with a standard deviation of 24 m) on bare
ground, 256 × 256 m, open edges all around, for 200 steps from upwind of its middle; winds at 0 to 45°
to the lattice, 8 seeds; shadow from the centre, and from each slab's place over level and over
sloping tops of stacks; slides to the steepest of four neighbours or to one drawn by the steps, also of
eight neighbours (limits of 2 and 3 slabs).
A horn's length is how far the outer quarter of the downwind edge on its side lies beyond the middle half
([measures](measures.md#dunes-one-by-one)). *Unequal* is the left length less the right one over their mean:
of the means over all seeds, where chance is smallest, with its standard error, and its size in a single run.
"""

import numpy as np

import barchan
from barchan.directions import downwind
from barchan.measures.dunes import find_dunes
from barchan.measures.horns import horns
from barchan.squares import Squares
from validation.isotropy_bench import kept
from validation.study import Row

TITLE = "The horns of a heap off the axes"

ANGLES = (0.0, 7.5, 15.0, 22.5, 30.0, 45.0)
SEEDS = tuple(range(1, 9))
STEPS = 200
UPWIND = 0.33
"""Where the heap starts: upwind of the field's middle, by this share of its width."""

LEAST = 1.0
"""Height (m) above the mean surface from which a heap counts as a dune."""

LEVEL = {"shadow_from": "place", "stack_tops": "level"}
SLOPING = {"shadow_from": "place", "stack_tops": "sloping"}
EIGHT = {"neighbourhood": "moore", "corner_limit": 3}
DOWNSLOPE = {"neighbour_order": "downslope"}
RULES = {
    "shadow from the centre": {"shadow_from": "centre"},
    "shadow from the place": LEVEL,
    "sloping tops": SLOPING,
    "shadow from the place, slides downslope": {**LEVEL, **DOWNSLOPE},
    "sloping tops, slides downslope": {**SLOPING, **DOWNSLOPE},
    "sloping tops, eight neighbours, slides downslope": {**SLOPING, **EIGHT, **DOWNSLOPE},
}
HEXAGONS = {
    "hexagons, shadow from the place": LEVEL,
    "hexagons, sloping tops, slides downslope": {**SLOPING, **DOWNSLOPE},
}
HEXAGONAL = {"kind": "hex", "rows": 296}
"""A field of hexagons as wide as that of squares."""


def shape(rule, angle, seed):
    """Horns (m), width (m) and height (m) of the largest dune; NaN where none is left."""
    return kept(f"heap-{rule}-{angle:g}-{seed}", lambda: _grown(rule, angle, seed))


def _grown(rule, angle, seed):
    lattice = {"rows": 256, "columns": 256, "boundary_x": "open", "boundary_y": "open"}
    if rule in HEXAGONS:
        lattice |= HEXAGONAL
    east, north = (0.5 - UPWIND * part for part in downwind(270.0 + angle))
    scenario = barchan.load(
        {
            "barchan": 4,
            "lattice": lattice,
            "sand": {"kind": "mound", "height": 7, "width": 24, "x": east, "y": north},
            "wind": {"kind": "steady", "direction": 270.0 + angle},
            "model": {"name": "momiji", **(RULES | HEXAGONS)[rule]},
            "run": {"seed": seed, "steps": STEPS, "save_every": STEPS, "threads": 1},
        }
    )
    simulation = barchan.Simulation(scenario)
    simulation.advance(STEPS)
    dunes = find_dunes(Squares(scenario.lattice).between(simulation.elevation), LEAST, (False, False))
    if not dunes:
        return dict.fromkeys(("left", "right", "width", "height"), np.nan)
    dune = max(dunes, key=lambda dune: dune.cells)
    seen = horns(dune, 270.0 + angle, scenario.lattice.cell_size)
    return {"left": seen.left, "right": seen.right, "width": seen.width, "height": dune.height}


def rows():
    for rule in RULES:
        for angle in ANGLES:
            yield row(f"{rule}, {angle:g}°", [shape(rule, angle, seed) for seed in SEEDS])


def row(what, found):
    grown = [result for result in found if np.isfinite(result["width"])]
    none = f"no dune left in {len(found) - len(grown)} of {len(found)} runs"
    if len(grown) < 2:
        return Row(what, "alike", none)
    left, right = (np.array([result[side] for result in grown]) for side in ("left", "right"))
    mean = (left.mean() + right.mean()) / 2
    off = 100 * (left - right).mean() / mean
    error = 100 * (left - right).std(ddof=1) / np.sqrt(len(grown)) / mean
    single = 100 * np.abs(left - right).mean() / mean
    width, height = (np.mean([result[name] for result in grown]) for name in ("width", "height"))
    size = f"{width:.0f} m wide, {height:.1f} m high"
    return Row(
        what,
        "alike",
        f"left {left.mean():.1f} m, right {right.mean():.1f} m: unequal by {off:+.0f} ± {error:.0f} %, "
        f"in a single run by {single:.0f} %",
        size if len(grown) == len(found) else f"{size}; {none}",
    )


READING = """
With shadow from the centre, as published, no wind off the axes leaves a dune. With shadow from the place over
level tops a dune as high and as wide stays at every angle, but off the axes its horns are a fifth to a half
as long as along an axis, and unequal. Two rules do that. Level tops make a staircase of a slope across the
wind, whose steps shelter the flanks of a dune under an oblique wind and not along an axis: with sloping tops
the horns on the diagonal are as long as along an axis, but between axis and diagonal the right one is longer
by a fifth to two fifths. That is what slides do: to the steepest of four neighbours all sand of a slip face
goes to one side. With the neighbour drawn by the steps horns are alike within 10 % at every angle, and 15 to
20 m long where they are 22 m along an axis. Eight neighbours with two limits of whole slabs, whose slip
faces are of the same steepness all round but for 8 %, are not better: horns are unequal by up to 38 %.
"""
