"""Forms of snow on made-up surfaces with known answers."""

import math

import numpy as np
import pytest

from barchan.measures.snow_forms import (
    Arrest,
    arrest,
    central_relief,
    edge_retreat,
    form_of,
    roughness_length,
    slope_skewness,
)


def sawtooth(steep_faces_downwind):
    """Waves of 2 m and 0.2 m: nine tenths rise or fall gently, one tenth steeply (a wind from the west)."""
    x = (np.arange(2000) + 0.5) * 0.01 % 2.0
    wave = np.where(x < 1.8, x / 1.8, (2.0 - x) / 0.2) * 0.2
    wave = wave if steep_faces_downwind else wave[::-1]
    return np.tile(wave, (4, 1))


def test_slopes_of_a_sawtooth_are_as_skew_as_two_slopes():
    """Slopes of +1/9 on 0.9 of the field and -1 on 0.1: skewness (1 - 2p)/sqrt(p (1 - p)) at p = 0.1."""
    expected = -(1 - 0.2) / math.sqrt(0.1 * 0.9)
    found = slope_skewness(sawtooth(True), 0.01, 270.0, width=0.0)
    assert found == pytest.approx(expected, rel=0.05)
    assert slope_skewness(sawtooth(False), 0.01, 270.0, width=0.0) == pytest.approx(-expected, rel=0.05)
    assert slope_skewness(sawtooth(True), 0.01, 90.0, width=0.0) == pytest.approx(-found)


def test_a_sine_has_no_skew_and_a_plane_none_at_all():
    sine = np.tile(np.sin(np.arange(64) * 2 * np.pi / 16), (8, 1))
    assert slope_skewness(sine, 1.0, 270.0) == pytest.approx(0.0, abs=1e-9)
    assert math.isnan(slope_skewness(np.zeros((8, 8)), 1.0, 270.0))


def test_relief_leaves_out_a_hundredth_on_either_side():
    surface = np.linspace(0.0, 1.0, 10_001).reshape(73, 137)
    assert central_relief(surface) == pytest.approx(0.98)


def test_roughness_of_a_sine_is_half_its_height_times_its_frontal_area():
    """A wave of height H and length λ has the frontal area H over λ: z0 = H²/(2 λ)."""
    wave = 0.5 * np.tile(np.sin(np.arange(400) * 2 * np.pi / 200), (8, 1))
    assert roughness_length(wave, 0.1, 270.0) == pytest.approx(1.0 / (2 * 20.0), rel=1e-3)
    assert roughness_length(wave, 0.1, 0.0) == pytest.approx(0.0, abs=1e-12)


FORM = {"relief": 0.2, "spacing": 5.0, "skewness": -1.0, "speed": 1.0, "bonded": 0.0, "quantum": 0.003}


@pytest.mark.parametrize(
    ("change", "form"),
    [
        ({}, "depositional, moving"),
        ({"relief": 0.008}, "flat"),
        ({"relief": 0.02, "spacing": 5.0}, "flat"),
        ({"speed": 0.04}, "depositional, stationary"),
        ({"speed": math.nan}, "depositional, stationary"),
        ({"skewness": 0.6, "bonded": 0.6}, "erosional"),
        ({"skewness": 0.6, "bonded": 0.4}, "mixed"),
        ({"skewness": 0.1}, "mixed"),
        ({"skewness": math.nan, "spacing": math.nan, "relief": 0.0}, "flat"),
    ],
)
def test_classes_of_fields(change, form):
    assert form_of(**{**FORM, **change}) == form


def test_arrest_is_when_the_last_motion_ended():
    """1 m/h for two hours, then 0.01 m/h."""
    hours, way = np.arange(5.0), np.array([0.0, 1.0, 2.0, 2.01, 2.02])
    assert arrest(hours, way) == Arrest(2.0, 2.0)
    assert arrest(hours, hours) == Arrest(math.inf, 4.0)
    assert arrest(hours, hours * 0.01) == Arrest(0.0, 0.0)
    with pytest.raises(ValueError, match="at least two times"):
        arrest(hours[:1], way[:1])


def test_an_edge_that_lost_three_cells_of_each_row_went_back_by_three_cells():
    """Four rows of cells of 0.05 m: 12 cells of 0.0025 m² over an edge of 0.2 m are 0.15 m."""
    before, after = np.zeros((4, 20)), np.zeros((4, 20))
    before[:, 8:], after[:, 11:] = 0.1, 0.1
    assert edge_retreat(before, after, 0.05, 0.05, 0.2) == pytest.approx(0.15)
    assert edge_retreat(after, before, 0.05, 0.05, 0.2) == pytest.approx(-0.15)
