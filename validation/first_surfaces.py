"""Ripples and transverse dunes laid out at the start, against a flat start, 1000 steps.

Presets `first-ripples` and `first-transverse`, and the same with flat sand. The Prague thesis (§6.5.2): any
initial surface is forgotten.
"""

import barchan
from validation.study import Row, measures_after, over_seeds, spread

TITLE = "First surfaces are forgotten"


def rows():
    for preset in ("first-ripples", "first-transverse"):
        mean = barchan.load(preset).sand.mean
        flat = {"sand": {"kind": "flat", "mean": int(mean)}}
        laid, even = over_seeds(measures_after, [(preset, {}), (preset, flat)])
        for measure in ("highest_stack", "spacing", "bare_fraction"):
            found = f"{spread(laid[measure])} against {spread(even[measure])} from flat sand"
            yield Row(f"{preset}: {measure}", "no difference", found)


READING = """
Highest stack and spacing differ by no more than the seeds do. Some more ground is bare after 1000 steps
from a flat start with 10 slabs a cell: not all is forgotten by then.
"""
