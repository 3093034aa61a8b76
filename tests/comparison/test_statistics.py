"""Statistics over seeds, against values from tables and by hand."""

import math

import numpy as np
import pytest

from barchan.comparison.statistics import holm, paired_difference, spread
from barchan.figures.comparison import Course, measures_over_time
from barchan.measures.slopes import slope_shares


def test_mean_and_sample_deviation_leave_out_what_has_no_value():
    found = spread([2.0, math.nan, 4.0, 6.0])
    assert (found.mean, found.deviation, found.count) == (4.0, 2.0, 3)


def test_crests_on_both_sides_of_north_have_a_mean_at_north():
    found = spread([170.0, 10.0], turn=180.0)
    assert min(found.mean, 180.0 - found.mean) == pytest.approx(0.0, abs=1e-9)
    assert found.deviation == pytest.approx(math.sqrt(200.0))


def test_a_paired_difference_has_the_t_of_the_textbook():
    # Differences 1, 2, 3: mean 2, error 1/√3, t = 2√3 with two degrees of freedom, for which
    # p = 1 − t/√(2 + t²) and the 97.5 % point is 4.3027.
    ours, theirs = {1: 5.0, 2: 7.0, 3: 9.0, 4: 1.0}, {3: 6.0, 1: 4.0, 2: 5.0}
    found = paired_difference("height", "b", "a", ours, theirs)
    t = 2 * math.sqrt(3)
    assert (found.mean, found.count) == (2.0, 3)
    assert found.p == pytest.approx(1 - t / math.sqrt(2 + t * t))
    assert found.high - found.mean == pytest.approx(4.3027 / math.sqrt(3), rel=1e-4)


def test_one_pair_and_constant_differences_have_no_test():
    assert math.isnan(paired_difference("m", "b", "a", {1: 2.0}, {1: 1.0}).p)
    found = paired_difference("m", "b", "a", {1: 2.0, 2: 3.0}, {1: 1.0, 2: 2.0})
    assert found.mean == 1.0
    assert math.isnan(found.p)


def test_directions_differ_by_the_shorter_way():
    assert paired_difference("crest_azimuth", "b", "a", {1: 178.0}, {1: 2.0}).mean == pytest.approx(-4.0)


def test_holm_multiplies_the_least_probability_by_the_number_of_tests():
    assert holm([0.01, math.nan, 0.04, 0.03]) == pytest.approx([0.03, math.nan, 0.06, 0.06], nan_ok=True)


def test_slopes_of_a_sawtooth_are_shared_between_its_flanks():
    # Eight cells up by 1/4 a cell, two down by 1: 14.04° on windward sides, 45° on lee sides; central
    # differences over the edges give two cells of each tooth other slopes.
    tooth = np.concatenate([np.arange(8) / 4, [2.0, 1.0]])
    surface = np.tile(tooth, (4, 3))
    edges = np.array([-50.0, -44.0, 13.0, 15.0])
    shares = slope_shares(surface, 1.0, 270.0, edges, width=0.0)
    assert shares[0] == pytest.approx(0.1)
    assert shares[2] == pytest.approx(0.7)
    reversed_wind = slope_shares(surface, 1.0, 90.0, -edges[::-1], width=0.0)
    assert reversed_wind == pytest.approx(shares[::-1])


def test_crests_of_two_variants_on_both_sides_of_north_are_drawn_next_to_each_other():
    """178.5° and 5.745° lie 7.245° apart about north. What has no value has no panel."""
    courses = {
        "crest_azimuth": [
            Course(label, np.array([0.0, 1.0]), np.full((1, 2), value))
            for label, value in (("one", 178.5), ("other", 5.745))
        ],
        "spacing": [Course("one", np.array([0.0]), np.full((1, 1), np.nan))],
    }
    titles = {"crest_azimuth": ("Crests", "degrees"), "spacing": ("Spacing", "m")}
    (axes,) = measures_over_time(courses, titles).axes
    assert [line.get_ydata()[0] for line in axes.lines] == pytest.approx([-1.5, 5.745])
