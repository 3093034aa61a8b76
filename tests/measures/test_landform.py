"""The class of fields whose class is drawn into them."""

import numpy as np
import pytest

from barchan import Simulation, load
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


@pytest.mark.parametrize(("times", "young"), [(0.5, True), (1.6, True), (3.3, False), (6.0, False)])
def test_a_bed_is_young_where_roughness_outweighs_its_forms(times, young):
    """Of noise smoothing over 2 cells keeps 1/16π of the variance, of waves of 21.3 cells exp(-(4π/21.3)²).

    That is 0.02 and 0.71, so half is kept where the waves have 2.3 times the variance of the noise.
    """
    noise = np.random.default_rng(5).normal(0.0, 1.0, (128, 128))
    humps = sine(6, 0, (128, 128)) + sine(0, 6, (128, 128))  # crossing waves: no common direction
    humps *= np.sqrt(times) / humps.std()
    assert (landform(noise + humps, 1.0, 270.0).name == "young") is young


def test_short_but_parallel_waves_are_not_young():
    """Of waves of 8 cells smoothing over 2 cells keeps exp(-(4π/8)²), 8 %."""
    assert landform(0.5 * sine(16, 0, (128, 128)), 1.0, 270.0).name == "transverse"


@pytest.mark.parametrize("wind", [0.0, 90.0, 180.0, 270.0])
def test_round_mounds_are_neither_barchans_nor_parabolic_dunes_whatever_wind_is_stated(wind):
    """Mounds of one slope all round, with noise, and one of them cut by a void."""
    rng = np.random.default_rng(7)
    north, east = 5.0 * np.mgrid[:128, :128]
    surface = 300.0 + 0.004 * east + rng.normal(0.0, 0.05, east.shape)
    for x, y, height in (
        (120, 150, 6),
        (300, 260, 8),
        (180, 420, 7),
        (430, 470, 5),
        (470, 150, 6),
        (330, 560, 6),
    ):
        surface += height * np.exp(-((east - x) ** 2 + (north - y) ** 2) / (2.0 * 28.0**2))
    assert landform(surface, 5.0, wind, (False, False)).name == "undetermined"
    surface[40:46, 60:70] = np.nan
    assert landform(surface, 5.0, wind, (False, False)).name == "undetermined"


@pytest.mark.parametrize("preset", ["barchans", "transverse", "star"])
def test_a_simulated_bed_is_young_at_first_and_later_not(preset):
    simulation = Simulation(load(preset, rows=96, columns=96, seed=2))
    classes = {}
    for step in (20, 400):
        simulation.advance(step - simulation.steps_done)
        bed = simulation.elevation, simulation.lattice.cell_size, simulation.wind_direction
        classes[step] = landform(*bed, simulation.lattice.periodic).name
    assert classes[20] == "young"
    assert classes[400] != "young"
    assert preset != "transverse" or classes[400] == "transverse"


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
