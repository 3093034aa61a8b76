"""Measures over time."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from barchan.analysis.declared_measures import MEASURES
from barchan.analysis.time_series import measure_series
from barchan.entry import simulate
from barchan.figures.series import POSSIBLE, SHOWN, about_middle, alone, time_series
from tests.tiny import tiny


@pytest.fixture(scope="module")
def measured():
    """The measures of a run."""
    return measure_series(simulate(tiny()), tiny())


def test_every_panel_shows_a_measure_under_its_title(measured):
    titles = {measure.name: measure.title for measure in MEASURES}
    panels = time_series(measured, tiny()).axes
    assert [axes.get_title("left") for axes in panels] == [titles[name] for name in SHOWN]


def test_every_panel_shows_the_values_at_their_steps(measured):
    for axes, name in zip(time_series(measured, tiny()).axes, SHOWN, strict=True):
        (line,) = axes.get_lines()
        np.testing.assert_array_equal(line.get_xdata(), [0, 5, 10, 15, 20])
        turns = 180.0 if name == "crest_azimuth" else np.inf
        np.testing.assert_allclose(line.get_ydata() % turns, measured[name] % turns)


def test_units_stand_beside_their_axes(measured):
    units = {measure.name: measure.unit for measure in MEASURES}
    for axes, name in zip(time_series(measured, tiny()).axes, SHOWN, strict=True):
        assert axes.get_ylabel() == ("" if units[name] == "-" else units[name])


def test_crests_that_cross_north_do_not_jump():
    azimuths = np.array([np.nan, 170.0, 178.0, 1.0, 4.0, 179.0])
    shown, middle = about_middle(azimuths)
    assert middle % 180.0 == 0.0
    np.testing.assert_allclose(shown - middle, [np.nan, -10.0, -2.0, 1.0, 4.0, -1.0])


@given(st.lists(st.floats(0, 180, exclude_max=True), min_size=1, max_size=20))
def test_an_orientation_is_drawn_within_half_a_turn_and_stays_itself(azimuths):
    shown, middle = about_middle(np.array(azimuths))
    assert (np.abs(shown - middle) <= 90.0).all()
    assert np.abs((shown - azimuths + 90.0) % 180.0 - 90.0).max() < 1e-9


def test_the_axis_of_orientations_is_labelled_from_0_to_180(measured):
    turned = measured.copy(deep=True)
    turned["crest_azimuth"][:] = [170.0, 178.0, 1.0, 4.0, 179.0]
    axes = next(axes for axes in time_series(turned, tiny()).axes if "orientation" in axes.get_title("left"))
    assert [label.get_text() for label in axes.get_yticklabels()] == ["90", "135", "0", "45", "90"]
    assert np.ptp(axes.get_lines()[0].get_ydata()) == 14.0


def test_measures_of_the_model_have_panels_below():
    scenario = tiny(model={"name": "nield_baas"})
    panels = time_series(measure_series(simulate(scenario), scenario), scenario).axes
    own = [
        *("mean grass", "mean mesquite", "mean shrub"),
        *("plants on the floor between dunes", "plants on windward sides"),
        *("plants on crests", "plants on lee sides"),
    ]
    assert [axes.get_title("left") for axes in panels[len(SHOWN) :]] == own
    scenario = tiny(model={"name": "momiji"})
    (panel,) = time_series(measure_series(simulate(scenario), scenario), scenario).axes[len(SHOWN) :]
    assert panel.get_xlabel() == "step"


def test_a_single_frame_is_drawn_as_points():
    one = measure_series(simulate(tiny()).isel(step=[-1]), tiny())
    for axes, name in zip(time_series(one, tiny()).axes, SHOWN, strict=True):
        marked = [line for line in axes.get_lines() if line.get_marker() == "o"]
        if np.isfinite(one[name].values).any():
            assert [line.get_xdata().tolist() for line in marked] == [[20.0]]
        else:
            assert marked == []
            assert [text.get_text() for text in axes.texts] == ["no value"]


def test_values_between_gaps_are_points():
    values = np.array([1.0, np.nan, 2.0, 3.0, np.nan, np.nan, 4.0])
    assert alone(values).tolist() == [True, False, False, False, False, False, True]


def test_scales_stay_within_what_is_possible(measured):
    bare = measured.copy(deep=True)
    bare["bare_fraction"][:] = 1.0
    bare["straightness"][:] = [0.0, 0.01, 0.0, 0.01, 0.0]
    for axes, name in zip(time_series(bare, tiny()).axes, SHOWN, strict=True):
        low, high = axes.get_ylim()
        if name in POSSIBLE:
            assert POSSIBLE[name][0] <= low < high <= max(POSSIBLE[name][1], 1.0)
