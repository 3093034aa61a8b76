"""Winds in turn: highest stacks of star dunes, and which way ridges run.

Presets `star` (Werner, 80 steps a wind, 640 steps: 23 slabs in the Prague thesis) and `momiji-star` (40
steps a wind, 320 steps: 22 slabs). Two exactly opposite winds make ridges across them, which the Prague
thesis took for a failure to make linear dunes and the rule of gross bedform-normal transport predicts
(preset `opposite-winds`, crest azimuth 0°); two equal winds 120° apart make linear dunes along their
resultant (preset `linear`, 90°).
"""

import numpy as np

from validation.study import Row, measures_after, number, over_seeds, spread

TITLE = "Winds in turn"


def rows():
    presets = ("star", "momiji-star", "opposite-winds", "linear")
    star, momiji, opposite, linear = over_seeds(measures_after, [(preset, {}) for preset in presets])
    yield number("star dunes, Werner", 23, star["highest_stack"], "slabs")
    yield number("star dunes, Momiji", 22, momiji["highest_stack"], "slabs")
    across = [(azimuth + 90) % 180 - 90 for azimuth in opposite["crest_azimuth"]]
    yield Row("crest azimuth under opposite winds from west and east", "0°", f"{spread(across)}°")
    yield Row("crest azimuth under winds from 210° and 330°", "90°", f"{spread(linear['crest_azimuth'])}°")
    yield Row("bare ground between linear dunes", "-", spread(np.array(linear["bare_fraction"])))


READING = """
Star dunes agree with the Prague thesis in both models. Ridges run as theory has it: across two opposite
winds, along the resultant of two winds 120° apart. The attempt at vegetated linear dunes (preset
`vegetated-linear`: two acute winds, one stronger, plants everywhere at first) makes none: plants cover the
field within some years and hold a net of low mounds.
"""
