"""How old is snow when its forms come to rest?

60 kg/m² of loose drift, 2.4 × 9.6 m, periodic, cells and hops of 0.1 m, quanta of 2 kg/m², bonds growing. Six
hours of 12 m/s, then a weaker wind for 24 hours. Forms are at rest once they travel less than 0.05 m/h for
good; frames are half an hour apart, and hours are counted from the fall of the wind. Five seeds.
"""

import numpy as np

from barchan.measures import migration
from barchan.measures.snow_forms import MOVING, arrest
from validation.snow_scenes import advance, fine, part
from validation.study import Row, over_seeds, spread

TITLE = "Age of snow at arrest"

GROWING, WATCHED, BETWEEN = 6.0, 24.0, 0.5
CASES = ((7.0, -10.0), (7.9, -10.0), (7.9, -1.0))


def age(wind, temperature, seed):
    """Hours until forms rest, the way until then (m), and the speed (m/h) at first."""
    winds = [part(GROWING, 12.0, temperature), part(WATCHED, wind, temperature)]
    simulation = fine(
        winds, seed, mean=30, rows=24, columns=96, temperature=temperature, reference_wind=10, quantum=2
    )
    advance(simulation, GROWING)
    way = [0.0]
    for _ in range(round(WATCHED / BETWEEN)):
        before = simulation.elevation.copy()
        advance(simulation, BETWEEN)
        shift = migration((0, 1), (before, simulation.elevation)).along(1.0, 0.0)
        way.append(way[-1] + simulation.scenario.lattice.cell_size * (0.0 if np.isnan(shift) else shift))
    found = arrest(BETWEEN * np.arange(len(way)), np.array(way), MOVING)
    return {"age": found.age, "distance": found.distance, "speed": way[1] / BETWEEN}


def rows():
    for (wind, cold), found in zip(CASES, over_seeds(age, CASES), strict=True):
        ages = found["age"]
        moving = sum(np.isinf(ages))
        rested = [value for value in ages if np.isfinite(value)]
        text = f"{np.mean(rested):.3g} h ({min(rested):g} to {max(rested):g})" if rested else "none rests"
        expected = "24 h or less" if (wind < 8.0 and cold == -10.0) else ""
        yield Row(
            f"{wind:g} m/s, {cold:g} °C",
            expected,
            f"{text}; {moving} of {len(ages)} still move after {WATCHED:g} h; "
            f"way {spread(found['distance'])} m, first {spread(found['speed'])} m/h",
            f"{sum(value <= 24.0 for value in ages)} of {len(ages)} seeds" if expected else "",
        )


READING = """
Where the wind cannot start fresh drift (7.5 m/s at -10 °C, 8.8 m/s at -1 °C) but grains in the air keep it
moving, forms come to rest within one to three hours and about a metre. In 7.9 m/s at -10 °C, little above
that threshold, they do not come to rest: a carpet of drift that always comes down anew, and so stays young,
travels over snow that has bonded, ever faster as its relief falls. So rest within a day, which is expected
below 8 m/s, comes out up to the threshold of fresh drift only.
"""
