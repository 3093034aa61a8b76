"""The class of fields whose class is drawn into them."""

import numpy as np
import pytest

from barchan.measures.landform import landform
from barchan.measures.lee_side import lee_side
from tests.measures.landforms import FIELDS
from tests.measures.waves import ridges, sine


@pytest.mark.parametrize("name", FIELDS)
def test_a_field_is_of_the_class_that_was_drawn(name):
    surface, cell_size, wind = FIELDS[name]
    found = landform(surface, cell_size, wind)
    assert (found.name, bool(found.reason)) == (name, True)


@pytest.mark.parametrize("name", FIELDS)
def test_the_class_does_not_depend_on_where_north_is(name):
    surface, cell_size, wind = FIELDS[name]
    turned = np.rot90(surface)  # row 0 in the south: its quarter turn runs against the clock seen from below
    assert landform(turned, cell_size, (wind + 90.0) % 360.0).name == name


@pytest.mark.parametrize("name", FIELDS)
def test_a_void_and_a_trend_do_not_change_the_class(name):
    surface, cell_size, wind = FIELDS[name]
    tilted = surface + 0.01 * cell_size * np.arange(surface.shape[0])[:, None]
    tilted[:3, :5] = np.nan
    assert landform(tilted, cell_size, wind, (False, False)).name == name


def test_symmetric_ridges_across_a_known_wind_are_transverse():
    assert landform(3.0 * sine(5, 0), 1.0, 270.0).name == "transverse"
    assert landform(3.0 * sine(5, 0), 1.0, 10.0).name == "linear"
    assert landform(3.0 * sine(5, 0), 1.0).name == "undetermined"


def test_the_lee_side_of_ridges_follows_from_their_slopes():
    surface = 3.0 * ridges(5, 0, windward=0.75)
    found = lee_side(surface, 1.0, width=0.0)
    windward, lee = 3.0 / 12.0, 3.0 / 4.0  # ridges of 16 cells
    assert found.wind == pytest.approx(270.0)
    # central differences round a cell or two at each corner
    assert found.strength == pytest.approx((lee**2 - windward**2) / (lee**2 + windward**2), abs=0.1)


def test_waves_have_no_lee_side():
    assert lee_side(sine(5, 0), 1.0).strength < 1e-9
    assert np.isnan(lee_side(np.zeros((8, 8)), 1.0).wind)
