"""Mean windward and lee slopes of ridges in three models, and the share of steep cells among sloping ones.

256 × 256 cells with 10 slabs a cell, 2000 steps, angle of repose 33.7° tested before a slab moves, no
erosion in shadow but for Werner's own row (its lee erosion is on, as in 1995). Momiji's and Bishop's models
are said to have gentler windward slopes than Werner's (Prague thesis, §6.2 and 6.3); field dunes have 5 to
15° windward and slip faces of 30 to 34°. The last rows are the strips of Elder (2009), Fig. 5.
"""

import numpy as np

from validation.study import Row, measures_after, order, over_seeds, spread

TITLE = "Windward and lee slopes"

MODELS = {
    "Werner": {"name": "werner", "repose_angle": 33.7, "lee_erosion": True},
    "Werner, no erosion in shadow": {"name": "werner", "repose_angle": 33.7, "lee_erosion": False},
    "Momiji": {"name": "momiji", "repose_test": "before"},
    "Bishop": {"name": "bishop", "repose_test": "before"},
}


def rows():
    cases = [("transverse", {"model": model, "run__steps": 2000}) for model in MODELS.values()]
    cases += [("werner-strip", {}), ("momiji-strip", {})]
    results = dict(
        zip([*MODELS, "Werner's strip", "Momiji's strip"], over_seeds(measures_after, cases), strict=True)
    )
    for name, result in results.items():
        ratio = np.divide(result["lee_slope"], result["windward_slope"])
        found = (
            f"windward {spread(result['windward_slope'])}°, lee {spread(result['lee_slope'])}°, "
            f"lee to windward {spread(ratio)}"
        )
        yield Row(name, "-", found)
    for name in ("Momiji", "Bishop"):
        what = f"windward slope, Werner without erosion in shadow against {name}"
        werner = results["Werner, no erosion in shadow"]["windward_slope"]
        yield order(what, "steeper", werner, results[name]["windward_slope"], "degrees")
    strips = [
        np.divide(results[name]["lee_slope"], results[name]["windward_slope"])
        for name in ("Momiji's strip", "Werner's strip")
    ]
    yield order("lee to windward slope, Momiji's strip against Werner's", "asymmetric", *strips)


READING = """
The speed-up halves the windward slope and makes profiles asymmetric the right way round, lee sides steeper.
Even so the windward slopes are steeper than the 5 to 15° of field dunes, but for the strip at two slabs of
repose. Werner's model without erosion in shadow has the steepest sides of all, with either side at its
angle of repose.
"""
