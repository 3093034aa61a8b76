"""The polls of a step taken band by band against polls over the whole field at once, 8 seeds.

A step's polls are taken from some tens of rows at a time (`model.band_rows`, part of the scenario), which
is what keeps large fields fast. Poll counts per cell keep their distribution; only the order within a step
changes. Presets `barchans` and `transverse`, 600 steps, with bands of 32 rows and without bands (256 rows
in one).
"""

import statistics

from validation.study import Row, measures_after, over_seeds, spread

TITLE = "Bands of rows"

MEASURES = ("highest_stack", "spacing", "bare_fraction", "straightness", "speed_cells", "flux")


def rows():
    presets = ("barchans", "transverse")
    cases = [(name, {"run__steps": 600, "model__band_rows": rows}) for name in presets for rows in (32, 256)]
    results = over_seeds(measures_after, cases, range(1, 9))
    for name, banded, whole in zip(presets, results[::2], results[1::2], strict=True):
        for measure in MEASURES:
            a, b = banded[measure], whole[measure]
            error = ((statistics.variance(a) + statistics.variance(b)) / len(a)) ** 0.5
            apart = abs(statistics.fmean(a) - statistics.fmean(b)) / error if error else 0.0
            found = f"{spread(a)} with, {spread(b)} without"
            yield Row(f"{name}: {measure}", "no difference", found, f"{apart:.1f} standard errors apart")


READING = """
No measure differs by as much as two standard errors: the dunes are the same.
"""
