"""Does the model after Pelletier show a steady state, and a spacing in proportion to the roughness length?

Preset `pelletier` (128 × 512 cells of 1 m, 30 slabs a cell) for 6000 steps, and at 1500 steps for roughness
lengths from 1 mm to 0.1 m; 3 seeds. The paper's ripples grow to a steady state of spacing about 3000 z0 (from
memory). Nothing was chosen to make either come out.
"""

import numpy as np

import barchan
from barchan.measures import dominant_spacing
from validation.study import Row, over_seeds, spread

TITLE = "After Pelletier: steady state and roughness"

TIMES = (375, 750, 1500, 3000, 6000)
ROUGHNESS = (0.001, 0.00316, 0.01, 0.0316, 0.1)


def course(seed):
    simulation = barchan.Simulation(barchan.load("pelletier", run__steps=TIMES[-1], run__seed=seed))
    result = {}
    for time in TIMES:
        simulation.advance(time - simulation.steps_done)
        result[f"spacing {time}"] = dominant_spacing(simulation.elevation, 1.0, 270.0)
        result[f"relief {time}"] = float(simulation.elevation.std())
    return result


def spacing(roughness, seed):
    simulation = barchan.Simulation(barchan.load("pelletier", model__roughness=roughness, run__seed=seed))
    simulation.advance(1500)
    return {
        "spacing": dominant_spacing(simulation.elevation, 1.0, 270.0),
        "relief": float(simulation.elevation.std()),
    }


def rows():
    (grown,) = over_seeds(course, [()], (1, 2, 3))
    for time in TIMES:
        found = f"spacing {spread(grown[f'spacing {time}'])} m, relief {spread(grown[f'relief {time}'])} m"
        yield Row(f"after {time} steps", "constant in the end", found)
    results = over_seeds(spacing, [(z0,) for z0 in ROUGHNESS], (1, 2, 3))
    for z0, result in zip(ROUGHNESS, results, strict=True):
        found = f"{spread(result['spacing'])} m, relief {spread(result['relief'])} m"
        yield Row(f"spacing at z0 = {z0 * 1000:g} mm", f"{3000 * z0:g} m", found)
    exponents = [
        np.polyfit(np.log(ROUGHNESS), np.log([result["spacing"][k] for result in results]), 1)[0]
        for k in range(3)
    ]
    yield Row("power of z0 in the spacing", "1", spread(exponents))


READING = """
Neither comes out. Growth slows down and spacing is the same at 3000 and 6000 steps within the spread, but
relief still grows, so a steady state is not shown. Spacing does not follow z0 (a power of -0.03 instead of
1): with cells of 1 m and this closure it is set by the length of hops and shadows, which do not know z0.
Crests come to lie 40 to 60° from the wind's normal, to either side. A faithful model would need the paper's
own rule.
"""
