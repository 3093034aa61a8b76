"""Measures over time."""

import numpy as np
import pytest

from barchan.analysis.course import MEASURES, course
from barchan.archive import simulate
from barchan.figures.series import SHOWN, time_series
from tests.tiny import tiny


@pytest.fixture(scope="module")
def measured():
    """The measures of a run."""
    return course(simulate(tiny()), tiny())


def test_every_panel_shows_a_measure_under_its_title(measured):
    titles = {measure.name: measure.title for measure in MEASURES}
    panels = time_series(measured, tiny()).axes
    assert [axes.get_title("left") for axes in panels] == [titles[name] for name in SHOWN]


def test_every_panel_shows_the_values_at_their_steps(measured):
    for axes, name in zip(time_series(measured, tiny()).axes, SHOWN, strict=True):
        (line,) = axes.get_lines()
        np.testing.assert_array_equal(line.get_xdata(), [0, 5, 10, 15, 20])
        np.testing.assert_array_equal(line.get_ydata(), measured[name])


def test_units_stand_beside_their_axes(measured):
    units = {measure.name: measure.unit for measure in MEASURES}
    for axes, name in zip(time_series(measured, tiny()).axes, SHOWN, strict=True):
        assert axes.get_ylabel() == ("" if units[name] == "-" else units[name])
