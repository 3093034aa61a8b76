"""Ripples of grains that grow by themselves from a flat bed, under `ripples`.

Fields of 256 × 32 cells of 5 mm, sand of 0.15 mm unless it says otherwise, half an hour of wind, an hour at
the three winds, 3 seeds. A simulated grain's sand is half a grain diameter thick and lies over a patch of
nine stacks; once, for comparison, a whole diameter on single stacks. For comparison too, at 12 m/s, nothing
is pushed along the bed (`creep_momentum` 0), the stress of the wind on the bed is alike everywhere
(`crest_stress` and `stoss_stress` 0) or in step with crests (`stoss_stress` 0), or the wind blows level
(`streamline_height` null). The speed is that of half a minute at
the end of half an hour. Height is 2√2 times the standard deviation of the bed, as of a wave; the share that
rises is that of the way along the wind: above one half the lee faces are shorter than the stoss faces, and
steeper.
"""

import numpy as np

import barchan
from barchan.analysis.migration import migration
from barchan.analysis.spacing import dominant_spacing
from validation.study import Row, order, over_seeds, spread

TITLE = "Ripples of grains that grow by themselves"

SEEDS = (1, 2, 3)
CELL, DIAMETER, DEPTH = 0.005, 0.15e-3, 0.03
ROWS, COLUMNS = 32, 256
THIN = 1 / 32
"""Height of a parcel of the thin sand, in grain diameters; a patch takes sixteen."""
MINUTE = 60.0
LOOKS = (10, 20, 30)
"""Minutes after which heights and spacings are told."""
HOUR = (*LOOKS, 60)
"""The same at the three winds."""
FRAME, FRAMES = 5.0, 7
"""Seconds of wind between the frames that tell the speed, and how many of them."""


def grown(speed, diameter, thin, rules, looks, seed):
    """What an hour or half of it makes of a flat bed."""
    parcel = diameter * (THIN if thin else 1.0)
    model = {
        "name": "ripples",
        "wind_speed": speed,
        "grain_diameter": diameter,
        "footprint": "patch" if thin else "stack",
        "weight": 0.04 if thin else 0.02,
        "load": 16.0,
        "iterations_per_step": 50,
        "time_step": 5e-4,
        **rules,
    }
    scenario = barchan.load(
        {
            "barchan": 1,
            "lattice": {"rows": ROWS, "columns": COLUMNS, "cell_size": CELL, "slab_height": parcel},
            "sand": {"kind": "flat", "mean": round(DEPTH / parcel)},
            "model": model,
            "run": {"steps": 10**6, "seed": seed},
        }
    )
    simulation = barchan.Simulation(scenario)
    beds = {}
    for look in looks:
        simulation.advance(round(look * MINUTE / simulation.model.step_seconds) - simulation.steps_done)
        beds[look] = simulation.bed.sand * parcel
        if look == LOOKS[-1]:
            moved, airborne = _travel(simulation, parcel), simulation.model.flying / scenario.lattice.cells
    bed = beds[LOOKS[-1]]
    rise = np.diff(_smooth(bed), axis=1)
    spacing = {look: dominant_spacing(bed, CELL, 270.0) for look, bed in beds.items()}
    height = {look: 2.0 * np.sqrt(2.0) * float(bed.std()) for look, bed in beds.items()}
    early, middle, late = (height[look] for look in LOOKS)
    return {
        "slowing": (late - middle) / (middle - early),
        "speed": moved.x * CELL / FRAME * 1e3,
        "alike": moved.correlation,
        **{f"spacing {at}": one * 1e2 for at, one in spacing.items()},
        **{f"height {at}": one * 1e3 for at, one in height.items()},
        "index": spacing[LOOKS[-1]] / late,
        "index at last": spacing[looks[-1]] / height[looks[-1]],
        "rising": float((rise > 0.0).mean()),
        "slope": float(np.degrees(np.arctan(np.abs(np.diff(bed, axis=1)).mean() / CELL))),
        "airborne": airborne,
    }


def _travel(simulation, parcel):
    """How far ripples travel between frames (cells)."""
    beds = [simulation.bed.sand * parcel]
    for _ in range(FRAMES - 1):
        simulation.advance(round(FRAME / simulation.model.step_seconds))
        beds.append(simulation.bed.sand * parcel)
    return migration(np.arange(FRAMES), beds, lags=FRAMES - 1)


def _smooth(bed):
    """The bed over three cells along the wind: single steps would count as faces."""
    return (np.roll(bed, 1, axis=1) + bed + np.roll(bed, -1, axis=1)) / 3.0


def rows():
    winds = (10.0, 12.0, 15.0)
    middling = 12.0, DIAMETER, True
    cases = {
        **{f"{speed:g} m/s": (speed, DIAMETER, True, {}, HOUR) for speed in winds},
        "12 m/s, grains of 0.30 mm": (12.0, 2 * DIAMETER, True, {}, LOOKS),
        "12 m/s, whole diameters": (12.0, DIAMETER, False, {}, LOOKS),
        "12 m/s, no creep": (*middling, {"creep_momentum": 0.0}, LOOKS),
        "12 m/s, stress alike": (*middling, {"crest_stress": 0.0, "stoss_stress": 0.0}, LOOKS),
        "12 m/s, stress in step": (*middling, {"stoss_stress": 0.0}, LOOKS),
        "12 m/s, wind that blows level": (*middling, {"streamline_height": None}, LOOKS),
    }
    found = dict(zip(cases, over_seeds(grown, cases.values(), SEEDS), strict=True))
    fine, coarse = [found[f"{speed:g} m/s"] for speed in winds], found["12 m/s, grains of 0.30 mm"]
    for name, result in found.items():
        downwind = sum(value > 0 for value in result["speed"])
        yield Row(
            f"speed, {name}",
            "downwind" if name != "10 m/s" else "downwind; 0.5 mm/s in a wind of about 10 m/s (Lorenz 2011)",
            f"{spread(result['speed'])} mm/s",
            f"{downwind} of {len(SEEDS)} seeds downwind",
        )
    yield order("speed, 15 against 10 m/s", "more", fine[2]["speed"], fine[0]["speed"], "mm/s")
    for name, result in found.items():
        looks = [at for at in HOUR if f"height {at}" in result]
        when = ", ".join(str(at) for at in looks)
        heights = ", ".join(spread(result[f"height {at}"], 2) for at in looks)
        yield Row(f"height after {when} min, {name}", "saturates", f"{heights} mm")
        yield Row(
            f"growth in the third ten minutes over that in the second, {name}",
            "below 1: saturates",
            spread(result["slowing"], 2),
            f"{sum(value < 1.0 for value in result['slowing'])} of {len(SEEDS)} seeds below 1",
        )
        spacings = ", ".join(spread(result[f"spacing {at}"], 2) for at in looks)
        yield Row(f"spacing after {when} min, {name}", "grows, then saturates", f"{spacings} cm")
    last = f"spacing {LOOKS[-1]}"
    yield order("spacing, 15 against 10 m/s", "more", fine[2][last], fine[0][last], "cm")
    yield order("spacing, grains of 0.30 against 0.15 mm", "more", coarse[last], fine[1][last], "cm")
    for name, result in found.items():
        yield Row(f"ripple index after {LOOKS[-1]} min, {name}", "15 to 20", spread(result["index"]))
        yield Row(f"share that rises, {name}", "above 0.5", spread(result["rising"]))
    for speed, result in zip(winds, fine, strict=True):
        yield Row(f"ripple index after an hour, {speed:g} m/s", "15 to 20", spread(result["index at last"]))
    height = f"height {HOUR[-1]}"
    yield order(
        "height after an hour, 10 against 15 m/s",
        "more (Walker 1981)",
        fine[0][height],
        fine[2][height],
        "mm",
    )
    for name, result in found.items():
        yield Row(f"mean slope, {name}", "–", f"{spread(result['slope'])}°")
        yield Row(f"simulated grains in the air, {name}", "–", f"{spread(result['airborne'])} a cell")


READING = """
Ripples that form by themselves travel downwind at 10, 12 and 15 m/s in every seed, the faster and the farther
apart the stronger the wind. They do not saturate within half an hour, and so are met at different stages: the
ripple index comes down from above as they grow, to 42 at 10 m/s, 27 at 12 m/s and 14 at 15 m/s, where 15 to
20 are published. Grains of 0.30 mm make ripples that stand closer, not farther apart, but are also lower, for
the same wind moves less of them. Faces are steeper in the lee at 10 and 12 m/s, and the other way about at
15 m/s, which disagrees.

How the wind goes over waves decides what becomes of them. In a wind that blows level, as in the published
models, they travel half as fast and run together. In one that is faster over crests they stay lower, and
keep their lee faces the steeper ones. Over an hour at 15 m/s (3 seeds) ripples grew to 40 mm in a level wind
and to 30 mm under the default, 45 and 33 cm apart, over 30 mm of sand: nothing holds them down. With twice
the speed-up of a flow without friction, but no turn across oblique crests, they saturated at 9 mm and 13 cm
in these narrow fields; in one twice as wide their crests then stood at 45° to the wind. With the turn that
belongs to it a field 32 cm wide had only low bumps after 22 minutes (one seed). So the default is a wind that
is no faster over crests, and saturation, which is published, does not come out.

They are slow: Lorenz (2011, Aeolian Research 3) filmed ripples of 10 cm at 3 cm a minute in a wind of about
10 m/s, ours travel 0.3 mm a minute at 10 m/s and 2 mm at 15 m/s. What moves ripples is what hops short. Our
ejecta fly by the published laws of splash, and half of all grains land within 2 mm of where they were thrown
out: ways of less than 3 cm make up 0.023 of all travel over a flat bed (one seed, at 10 and at 15 m/s), where
a quarter, the share that creeps by measurements (from memory), would do for such a speed. Grains that are
pushed along the bed without being thrown out are not in the model unless they are coarse.
"""
