"""Werner's model with the parameters of Table 6.1 of the Prague thesis, 1000 steps from flat sand.

Presets `barchans` (3 slabs a cell) and `transverse` (10 slabs a cell).
"""

from validation.study import measures_after, number, over_seeds

TITLE = "Highest stacks"


def rows():
    barchans, transverse = over_seeds(measures_after, [("barchans", {}), ("transverse", {})])
    yield number("barchans", 26, barchans["highest_stack"], "slabs")
    yield number("transverse dunes", 28, transverse["highest_stack"], "slabs")


READING = """
Both agree with single runs of the Prague thesis.
"""
