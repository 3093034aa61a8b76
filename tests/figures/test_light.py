"""Gentle relief is lit as steeper than it is, steep relief as it is."""

import math

import numpy as np
import pytest

from barchan.figures.light import MOST_EXAGGERATED, brightness, exaggeration
from barchan.measures.filters import gradient
from tests.tiny import COLUMNS, ROWS, tiny


def triangles(slope):
    """Ridges across the field whose sides have one slope (degrees), 12 cells to a side."""
    side = np.abs(np.arange(COLUMNS) % 24 - 12)
    return np.tile(side * math.tan(math.radians(slope)), (ROWS, 1))


@pytest.mark.parametrize("slope", [30.0, 45.0])
def test_slip_faces_are_lit_as_steep_as_they_are(slope):
    assert exaggeration(triangles(slope), tiny()) == pytest.approx(1.0)


def test_slopes_of_15_degrees_are_lit_as_30():
    """tan 30° / tan 15° = 2.1547."""
    assert exaggeration(triangles(15.0), tiny()) == pytest.approx(2.1547, rel=1e-3)


def test_a_level_bed_is_lit_with_the_greatest_exaggeration():
    assert exaggeration(np.zeros((ROWS, COLUMNS)), tiny()) == MOST_EXAGGERATED


def test_ripples_of_8_degrees_show():
    """Lit from the north-west at 40°, 4 times as steep, slopes of tan 8° become 0.562.

    Their brightness is 1 + 0.9 ((sin 40° ± 0.562 cos 40° sin 45°) / √(1 + 0.562²) - sin 40°): 1.164 to the
    west and 0.687 to the east, so that the lit side is 1.7 times as bright as the lee; unexaggerated 1.2.
    """
    ripples = triangles(8.0)
    east, north = (exaggeration(ripples, tiny()) * slopes for slopes in gradient(ripples, 1.0, (True, True)))
    light = brightness(east, north)
    assert light[8, 18] == pytest.approx(1.164, abs=0.002)
    assert light[8, 6] == pytest.approx(0.687, abs=0.002)
