"""Ripples of grains that grow by themselves from a flat bed, under `ripples`.

Fields of 256 × 32 cells of 5 mm, sand of 0.15 mm unless it says otherwise, half an hour of wind, an hour at
the three winds, 3 seeds. A simulated grain's sand is half a grain diameter thick and lies over a patch of
nine stacks; once, for comparison, a whole diameter on single stacks. For comparison too, at 12 m/s, nothing
is pushed along the bed (`creep.momentum` 0), the stress of the wind on the bed is the same everywhere
(`stress_in_phase` and `stress_in_quadrature` 0) or in step with crests (`stress_in_quadrature` 0), or the
wind blows level (`streamline_height` null). The speed is that of half a minute at the end of half an hour.
Height is 2√2 times the standard deviation of the bed, as of a wave; the share that rises is that of the
distance along the wind: above one half the lee faces are shorter than the stoss faces, and steeper.
"""

import numpy as np

import barchan
from barchan.measures.migration import migration
from barchan.measures.spacing import dominant_spacing
from validation.study import Row, order, over_seeds, spread

TITLE = "Ripples of grains that grow by themselves"

SEEDS = (1, 2, 3)
CELL, DIAMETER, DEPTH = 0.005, 0.15e-3, 0.03
ROWS, COLUMNS = 32, 256
THIN = 1 / 32
"""Height of a parcel of the thin sand, in grain diameters; a patch takes sixteen."""
MINUTE = 60.0
LOOKS = (10, 20, 30)
"""Minutes after which heights and spacings are reported."""
HOUR = (*LOOKS, 60)
"""The same at the three winds."""
FRAME, FRAMES = 5.0, 7
"""Seconds of wind between the frames that give the speed, and how many of them."""


def grown(speed, diameter, thin, rules, looks, seed):
    """A flat bed after half an hour or an hour of wind."""
    parcel = diameter * (THIN if thin else 1.0)
    model = {
        "name": "ripples",
        "wind_speed": speed,
        "grain_diameter": diameter,
        "footprint": "patch" if thin else "stack",
        "feedback": {"momentum_weight": 0.04 if thin else 0.02},
        "max_grains_per_cell": 16.0,
        "iterations_per_step": 50,
        "time_step": 5e-4,
        **rules,
    }
    scenario = barchan.load(
        {
            "barchan": 5,
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
            moved, airborne = (
                _travel(simulation, parcel),
                simulation.model.pool.flying / scenario.lattice.cells,
            )
    bed = beds[LOOKS[-1]]
    rise = np.diff(_smooth(bed), axis=1)
    spacing = {look: dominant_spacing(bed, CELL, 270.0) for look, bed in beds.items()}
    height = {look: 2.0 * np.sqrt(2.0) * float(bed.std()) for look, bed in beds.items()}
    early, middle, late = (height[look] for look in LOOKS)
    return {
        "slowing": (late - middle) / (middle - early),
        "speed": moved.x * CELL / FRAME * 1e3,
        "correlation": moved.correlation,
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
        "12 m/s, no creep": (*middling, {"creep": {"momentum": 0.0}}, LOOKS),
        "12 m/s, uniform stress": (
            *middling,
            {"relief_flow": {"stress_in_phase": 0.0, "stress_in_quadrature": 0.0}},
            LOOKS,
        ),
        "12 m/s, stress in step": (*middling, {"relief_flow": {"stress_in_quadrature": 0.0}}, LOOKS),
        "12 m/s, wind that blows level": (*middling, {"relief_flow": {"streamline_height": None}}, LOOKS),
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
Ripples form within minutes, travel downwind in every seed and wind, join, and saturate: at 15 m/s within
ten minutes, 6 mm high and 11 cm apart, from then on for the rest of the hour; at 10 and 12 m/s their
spacing still grows by a tenth to a fifth in the last half-hour, and their height by a quarter. The stronger
the wind, the faster they travel and the farther apart they are at first; later all are 10 to 12 cm apart. In
the strongest wind they are lowest, as Walker (1981) found in a tunnel. The index lies between 15.5 and 19,
where 15 to 20 are published. Lee faces are the steeper ones in every wind. The speed, 13 mm a minute at
10 m/s and 71 at 15 m/s, is near what Lorenz (2011, Aeolian Research 3) filmed, ripples of 10 cm at 30 mm a
minute in a wind of about 10 m/s.

What does so are grains that impacts push along the bed, in a wind whose stress is higher over waves. None
of their numbers was fitted: the momentum is what rebounds and ejecta leave, the speed at which they start
is that which lifts a grain by its diameter, the stress is that of the theory of turbulent flow over low
waves (Fourrière et al. 2010), and the wind that keeps grains going is that of the impact threshold. Over a
flat bed they then carry 0.15 to 0.19 of all sand (one seed, 10 to 15 m/s); a quarter is what measurements
of creep say (from memory). Without them ripples of 12 m/s are a thirtieth as fast and two thirds as high
after half an hour, and their growth quickens. In a wind whose stress is the same everywhere they grow to 17
mm with the steeper faces windward, and do not saturate. If the stress is highest right on the crest instead
of ahead of it none form. Streamlines matter less: in a wind that blows level ripples are much the same.
Whole grain diameters roughen the bed and make steeper, higher ripples.

Grains of 0.30 mm make ripples a twentieth farther apart than those of 0.15 mm in 3 of 3 seeds, hardly more
than the seeds differ. They travel 2.6 times as fast: under them the wind near the bed stays at 0.94 of the
impact threshold, under those of 0.15 mm at 0.80 (flat beds, one seed), so that it takes 0.88 instead of
0.64 off the friction of a pushed grain, which goes three times as far for it, and half as far again for its
greater speed. Across the wind these fields are 16 cm wide; in one of 64 cm ripples of 12 m/s looked the
same after 20 minutes, with straight crests and forks (one seed). There the momentum that grains take must
spread less across the wind than along it: shared as widely, it lets grains crowd into lanes 10 cm apart,
which break crests up into pits after a quarter of an hour.
"""
