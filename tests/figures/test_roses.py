"""Roses show what the wind does."""

import io

import numpy as np
import pytest

from barchan.aeolian import Saltation
from barchan.figures.roses import roses
from barchan.theory.assessment import assess, assess_record
from barchan.theory.drift import drift_of
from barchan.wind.records import read_record
from tests.theory.winds import record


def drawn(figure):
    figure.savefig(io.BytesIO(), dpi=40)
    return figure


def petals(axes):
    return np.array([bar.get_height() for bar in axes.patches])


def test_petals_are_the_shares_of_time_and_the_sand():
    winds = record([0.0, 9.0, 12.0, 3.0], [0.0, 270.0, 270.0, 90.0])
    found = assess_record(winds, Saltation())
    left, right = drawn(roses("Title", found, winds, 6.4)).axes
    assert petals(left).sum() == pytest.approx(75.0)
    assert "calm 25.0 %" in left.get_title()
    assert petals(right).sum() == pytest.approx(found.drift.total)
    assert petals(right)[12] == pytest.approx(found.drift.total)
    assert right.get_theta_direction() == -1


def test_crests_lie_where_they_are_predicted_and_rivals_beside_them():
    figure = drawn(roses("Star", assess(drift_of([(0.0, 1.0), (90.0, 1.0), (180.0, 1.0), (270.0, 1.0)]))))
    (axes,) = figure.axes
    lines = {
        line.get_label(): np.degrees(line.get_xdata()[0]) for line in axes.lines if len(line.get_xdata())
    }
    assert sorted([lines["crest, gross transport"], lines["crest, gross transport, as good"]]) == [45, 135]
    assert not any(label.startswith(("resultant", "fingers")) for label in lines)


def test_a_wind_that_moves_nothing_says_so():
    winds = record([3.0, 2.0], [270.0, 90.0])
    axes = drawn(roses("Weak", assess_record(winds, Saltation()), winds)).axes[-1]
    assert [text.get_text() for text in axes.texts] == ["nothing would move"]


def test_the_sample_is_drawn_with_more_sectors():
    sample = read_record("sample")
    figure = drawn(roses("Sample", assess_record(sample, Saltation()), sample, count=36))
    assert len(figure.axes[-1].patches) == 36
