"""The measures of a surface of 1024² cells, crest lines and dunes included."""

import time
from collections.abc import Iterator

import numpy as np
from scipy import ndimage

from barchan.survey import measure

SIDE = 1024


def report() -> Iterator[str]:
    """The table, line by line."""
    yield ""
    yield f"| surface of {SIDE}² cells | seconds of a processor |"
    yield "|---|---|"
    yield f"| all measures, crest lines, dunes, class | {seconds():.2f} |"


def seconds() -> float:
    """Seconds of a processor for the second of two surfaces."""
    noise = np.random.default_rng(1).normal(size=(SIDE, SIDE))
    bumps = ndimage.gaussian_filter(noise, (12.0, 6.0), mode="wrap")
    surface = 3.0 * bumps / bumps.std()
    for _ in range(2):
        began = time.process_time()
        survey = measure(surface, cell_size=1.0, wind=270.0, periodic=True)
        _ = survey.values(), survey.landform, survey.crests, survey.dunes
        took = time.process_time() - began
    return took
