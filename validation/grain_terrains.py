"""Grains over flat ground, a hump, a valley and a form like a dune (Szabó 2019, §6, Figs. 6.1 to 6.6).

Presets `szabo-…`, 3000 iterations of `wang_hu`, 3 seeds; flat ground with 128 rows. Published, in words and
pictures: crests grow higher and stand farther apart from 10 to 15 m/s; sand settles in the lee of a hump;
it slides off a steep one and gathers at the foot of its windward slope; ripples are more oblique on the
sides of a dune, and flatter the higher they lie on the slope of a valley. Height is 2√2 times the standard
deviation of the surface, smoothed over 1 cell; where the ground is not level, of the depth of sand about
its mean over 12 cells. The sides of a hump are the cells from 1 to 2 of its widths before and behind the
top, its feet those from 2 to 3.5, within a width of the line through it; depths of sand are compared with
the 500 (steep hump: 100) parcels of the start. The presets smooth slopes by the published filter; "steepest"
are the same runs with sand that slides to the steepest neighbour, as the seed's text has it (§5.1.3).
"""

import numpy as np

import barchan
from barchan.measures import crest_orientation, dominant_spacing
from barchan.measures.filters import smoothed
from validation.study import Row, order, over_seeds, spread

TITLE = "Ripples of grains over four terrains"

SEEDS = (1, 2, 3)
WINDS = (10, 12, 15)
AFTER = (1000, 2000, 3000)
"""Iterations."""
JOINED = (True, True)
SINGLE, WIDE = 1.0, 12.0
"""Widths (cells) that leave out single parcels, and that leave the ground's shape."""


def ripples_on_flat_ground(speed, seed):
    """Height (mm) and spacing (cm) of the relief after some iterations."""
    simulation = barchan.Simulation(barchan.load(f"szabo-{speed}", lattice__rows=128, run__seed=seed))
    cell = simulation.bed.lattice.cell_size
    found = {}
    for iterations in AFTER:
        simulation.advance(100)
        surface = simulation.bed.elevation
        found[f"height {iterations}"] = height(smoothed(surface, SINGLE, JOINED))
        found[f"spacing {iterations}"] = 100 * dominant_spacing(surface, cell, 270.0, width=2.0)
    return found


def height(relief):
    """Height (mm) of waves with the standard deviation of a relief (m)."""
    return float(2e3 * np.sqrt(2) * relief.std())


def after(preset, collapse, seed):
    """The run after 3000 iterations and the fine relief (m) of its sand."""
    simulation = barchan.Simulation(barchan.load(preset, model__collapse=collapse, run__seed=seed))
    simulation.advance(300)
    depth = simulation.bed.sand * simulation.bed.lattice.thickness
    return simulation, smoothed(depth, SINGLE, JOINED) - smoothed(depth, WIDE, JOINED)


def sand_about_a_hump(preset, collapse, seed):
    """Change of the sand's depth (mm) before, on and behind the hump and away from it, and bare ground."""
    simulation, _ = after(preset, collapse, seed)
    bed, ground = simulation.bed, simulation.scenario.ground
    x, y = np.meshgrid(bed.lattice.x / bed.lattice.x.mean() - 1, bed.lattice.y / bed.lattice.y.mean() - 1)
    east, north = x * bed.lattice.x.mean() / ground.width, y * bed.lattice.y.mean() / ground.width
    change = 1e3 * bed.lattice.thickness * (bed.sand - float(simulation.scenario.sand.mean))
    distance = np.hypot(east, north)
    near = np.abs(north) < 1.0
    places = {
        "windward": near & (east < -1.0) & (east > -2.0),
        "lee": near & (east > 1.0) & (east < 2.0),
        "windward foot": near & (east < -2.0) & (east > -3.5),
        "lee foot": near & (east > 2.0) & (east < 3.5),
        "top": distance < 0.5,
        "away": np.abs(north) > 3.0,
    }
    return {
        **{name: float(change[where].mean()) for name, where in places.items()},
        "bare": float((bed.sand[distance < 1.0] == 0).mean()),
    }


def ripples_in_a_valley(collapse, seed):
    """Height (mm) of ripples on the upper, the middle and the lower third of the slopes."""
    simulation, relief = after("szabo-valley", collapse, seed)
    ground = simulation.bed.ground
    share = (ground - ground.min()) / np.ptp(ground)
    thirds = {"low": share < 1 / 3, "middle": (share >= 1 / 3) & (share < 2 / 3), "high": share >= 2 / 3}
    return {name: height(relief[where]) for name, where in thirds.items()}


def lean_on_a_dune(collapse, seed):
    """How far (degrees) crests lean from across the wind on the dune's southern and northern side."""
    simulation, relief = after("szabo-dune-form", collapse, seed)
    lattice, form = simulation.bed.lattice, simulation.scenario.ground
    middle_x, middle_y = lattice.columns // 2, lattice.rows // 2
    width, length = (round(size / lattice.cell_size) for size in (form.width, form.length))
    columns = slice(middle_x - width, middle_x + width)
    sides = {
        "south": slice(middle_y - 3 * length // 2, middle_y - length // 2),
        "top": slice(middle_y - length // 2, middle_y + length // 2),
        "north": slice(middle_y + length // 2, middle_y + 3 * length // 2),
    }
    return {name: lean(relief[rows, columns], lattice.cell_size) for name, rows in sides.items()}


def lean(relief, cell):
    """Azimuth (degrees, -90 to 90) of the crests of a part of the field."""
    return (crest_orientation(relief, cell, (False, False)).azimuth + 90) % 180 - 90


def rows():
    yield from on_flat_ground()
    yield from on_terrains("filter", "")
    yield from on_terrains("steepest", ", steepest")


def on_flat_ground():
    by_wind = dict(zip(WINDS, over_seeds(ripples_on_flat_ground, [(u,) for u in WINDS], SEEDS), strict=True))
    for quantity, unit in (("height", "mm"), ("spacing", "cm")):
        for iterations in AFTER:
            fast, slow = (by_wind[u][f"{quantity} {iterations}"] for u in (15, 10))
            yield order(
                f"{quantity} after {iterations} iterations, 15 against 10 m/s", "more", fast, slow, unit
            )
        for u in WINDS:
            late, early = (by_wind[u][f"{quantity} {iterations}"] for iterations in (3000, 1000))
            yield order(f"{quantity} at {u} m/s, after 3000 against 1000", "more", late, early, unit)


def on_terrains(collapse, note):
    hump, steep = over_seeds(
        sand_about_a_hump, [(f"szabo-{kind}", collapse) for kind in ("hump", "steep-hump")], SEEDS
    )
    yield order(
        f"hump{note}: sand on the lee side against the windward", "more", hump["lee"], hump["windward"], "mm"
    )
    yield order(
        f"hump{note}: sand at the lee foot against away", "more", hump["lee foot"], hump["away"], "mm"
    )
    foot = hump["windward foot"]
    yield order(
        f"hump{note}: sand at the lee foot against the windward", "more", hump["lee foot"], foot, "mm"
    )
    yield order(f"hump{note}: sand at the windward foot against away", "more", foot, hump["away"], "mm")
    yield order(f"steep hump{note}: sand on the top against away", "less", steep["away"], steep["top"], "mm")
    yield Row(f"steep hump{note}: bare within a width of its top", "some", spread(steep["bare"]))
    foot = steep["windward foot"]
    yield order(
        f"steep hump{note}: sand at the windward foot against away", "more", foot, steep["away"], "mm"
    )
    yield order(
        f"steep hump{note}: sand at the windward foot against the lee", "more", foot, steep["lee foot"], "mm"
    )
    (valley,) = over_seeds(ripples_in_a_valley, [(collapse,)], SEEDS)
    yield order(
        f"valley{note}: height of ripples, low against high", "more", valley["low"], valley["high"], "mm"
    )
    yield Row(f"valley{note}: height of ripples half way up", "–", f"{spread(valley['middle'])} mm")
    (dune,) = over_seeds(lean_on_a_dune, [(collapse,)], SEEDS)
    for side in ("south", "top", "north"):
        yield Row(
            f"dune{note}: azimuth of crests, {side}", "–", ", ".join(f"{angle:+.0f}°" for angle in dune[side])
        )
    flanks = [(abs(a) + abs(b)) / 2 for a, b in zip(dune["south"], dune["north"], strict=True)]
    yield order(
        f"dune{note}: lean of crests, sides against top", "more", flanks, [abs(a) for a in dune["top"]], "°"
    )


READING = """
On flat ground spacing agrees: twice as wide at 15 as at 10 m/s. Height does not: it grows with time at every
wind, but at equal times it is lower in stronger wind, in every seed. Whether the order turns round once
heights have saturated was not followed. At 10 m/s spacing is that of the first 1000 iterations.

With the published filter sand settles behind the hump and before it, more on the lee side; the steep hump
sheds its sand, which gathers at its feet, more at the windward one; ripples in the valley are flatter high
up: as the seed describes. Only the crests on the sides of the dune are no more oblique than on its top. How
much of the millimetres at the foot of slopes the wind brought was not separated from what the filter
brings: a cell that it finds too sharp exchanges sand with the neighbours above and below it on the slope.

With sand that slides to the steepest neighbour amounts are smaller, and some turn round. Behind the hump
sand stays that its windward foot loses; a band up to 3 mm deep settles just behind the crest (seen in seed
1; the rows begin a width behind it, where the bed has hardly changed). Sand gathers on the hump's windward
side, not at its windward foot. The steep hump is bare, with more sand at its windward foot than anywhere
else. Crests lean more on the sides of the dune than on its top, by 2° only. In the valley ripples are lower
on the shoulders than on the floor, and lowest on the slopes between.

The sizes of the seed's ground, the damping of bounces, the time step and the filter's factors are not
published; those here are ours and were left as they were.
"""
