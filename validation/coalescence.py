"""Ridges merge for ever in Werner's model: spacing against time, and down to one ridge.

Both the Prague thesis and Elder (2009) say so.

The field of preset `transverse`, watched for 6400 steps; and a single row of 1024 cells (10 slabs a cell,
no erosion in shadow), whose dunes are one after about 150,000 steps in Elder (2009). Ridges are what stands
more than the mean height, after smoothing over five cells. A growth of spacing as a power of time of 0.3 to
0.5 is expected from speeds that fall with height.
"""

import numpy as np
from scipy.ndimage import gaussian_filter1d

import barchan
from barchan.measures import dominant_spacing
from validation.study import Row, over_seeds, spread

TITLE = "Coalescence of ridges"

TIMES = (100, 200, 400, 800, 1600, 3200, 6400)
ROW_TIMES = (1_000, 10_000, 50_000, 150_000, 300_000)


def spacings(seed):
    simulation = barchan.Simulation(barchan.load("transverse", run__seed=seed, run__steps=TIMES[-1]))
    result = {}
    for time in TIMES:
        simulation.advance(time - simulation.steps_done)
        result[str(time)] = dominant_spacing(simulation.elevation, 1.0, 270.0)
    late = np.log(list(result.values()))[1:]
    result["exponent"] = float(np.polyfit(np.log(TIMES[1:]), late, 1)[0])
    return result


def ridges_in_a_row(seed):
    changes = {"lattice__rows": 1, "lattice__columns": 1024, "model__lee_erosion": False}
    simulation = barchan.Simulation(
        barchan.load("transverse", run__seed=seed, run__steps=ROW_TIMES[-1], **changes)
    )
    result = {}
    for time in ROW_TIMES:
        simulation.advance(time - simulation.steps_done)
        surface = gaussian_filter1d(simulation.elevation[0], 5.0, mode="wrap")
        above = surface > surface.mean()
        result[str(time)] = float(np.sum(above & ~np.roll(above, 1)))
    return result


def rows():
    (field,) = over_seeds(spacings, [()])
    for time in TIMES:
        yield Row(f"spacing after {time} steps", "grows", f"{spread(field[str(time)])} cells")
    yield Row("power of time, 200 to 6400 steps", "0.3 to 0.5 expected", spread(field["exponent"]))
    (row,) = over_seeds(ridges_in_a_row, [()])
    for time in ROW_TIMES:
        published = "1 at about 150,000" if time == 150_000 else "falls"
        yield Row(f"ridges in a row of 1024 cells after {time:,} steps", published, spread(row[str(time)]))


READING = """
Spacing keeps growing, more slowly than the argument from speeds has it; it is a power of time only roughly.
The row of 1024 cells ends as Elder (2009) says: one ridge, in some runs two, at 150,000 steps.
"""
