"""Slopes that face the wind and slopes that turn from it."""

import math

import numpy as np
import pytest

from barchan.measures import slip_face_angle, streamwise_slopes
from tests.measures.waves import COLUMNS, ROWS, random_surface, ridges, sine, wavelength, wind_along

HEIGHT = 3.0


def degrees(slope):
    return math.degrees(math.atan(slope))


@pytest.mark.parametrize(("cell", "turned"), [(1.0, False), (2.5, False), (1.0, True)])
def test_straight_flanks_have_the_slopes_they_are_built_with(cell, turned):
    """Twelve cells rise by a, four fall by b; across crest and trough the slope is (a - b) / 2."""
    profile = np.concatenate([np.arange(12) / 12, np.arange(4, 0, -1) / 4])
    field = np.tile(HEIGHT * np.tile(profile, 5), (6, 1))
    a, b = HEIGHT / 12 / cell, HEIGHT / 4 / cell
    lee = (3 * b**2 + 2 * ((b - a) / 2) ** 2) / (3 * b + 2 * (b - a) / 2)
    slopes = streamwise_slopes(field.T if turned else field, cell, 180.0 if turned else 270.0, width=0.0)
    assert slopes.windward == pytest.approx(degrees(a))
    assert slopes.lee == pytest.approx(degrees(lee))


@pytest.mark.parametrize("wave", [(2, 0), (0, 2), (2, 1), (-2, 1), (1, -2)])
def test_straight_flanks_at_any_angle_differ_only_beside_crest_and_trough(wave):
    """Differences over two cells mix the flanks within a cell's diagonal of a kink, and nowhere else."""
    shape = (2 * ROWS, 2 * COLUMNS)
    length = wavelength(*wave, shape)
    field = HEIGHT * ridges(*wave, 0.75, shape)
    slopes = streamwise_slopes(field, 1.0, wind_along(*wave, shape), width=0.0)
    for measured, share in ((slopes.windward, 0.75), (slopes.lee, 0.25)):
        flank = share * length
        mixed = 2 * math.sqrt(2) / flank
        assert degrees(HEIGHT / flank * (1 - mixed)) <= measured <= degrees(HEIGHT / flank) + 1e-9


@pytest.mark.parametrize("wave", [(7, 0), (0, 5), (5, 3), (3, -2)])
@pytest.mark.parametrize("width", [0.0, 1.0, 2.0])
def test_both_sides_of_a_sine_have_pi_quarters_of_its_steepest_slope(wave, width):
    """Weighted by itself a cosine's mean over a half wave is the mean of cos² over that of cos."""
    kx, ky = 2 * math.pi * wave[0] / COLUMNS, 2 * math.pi * wave[1] / ROWS
    steepest = (kx * math.sin(kx) + ky * math.sin(ky)) / math.hypot(kx, ky)
    damped = gaussian_response(kx, width) * gaussian_response(ky, width)
    expected = degrees(math.pi / 4 * HEIGHT * steepest * damped)
    slopes = streamwise_slopes(HEIGHT * sine(*wave), 1.0, wind_along(*wave), width=width)
    assert slopes.windward == pytest.approx(expected, rel=0.005)
    assert slopes.lee == pytest.approx(expected, rel=0.005)


def gaussian_response(wavenumber, width):
    """What is left of a wave after a Gaussian of four standard deviations to each side."""
    if width == 0:
        return 1.0
    reach = np.arange(-4 * int(width), 4 * int(width) + 1)
    weights = np.exp(-(reach**2) / (2 * width**2))
    return float((weights * np.cos(wavenumber * reach)).sum() / weights.sum())


def test_windward_and_lee_change_places_when_the_wind_turns_round():
    field = HEIGHT * ridges(4, 2)
    one = streamwise_slopes(field, 1.0, 250.0)
    other = streamwise_slopes(field, 1.0, 70.0)
    assert one.windward == pytest.approx(other.lee)
    assert one.lee == pytest.approx(other.windward)


@pytest.mark.parametrize("turns", [1, 2, 3])
def test_slopes_turn_with_field_and_wind(turns):
    surface = random_surface(9)
    before = streamwise_slopes(surface, 1.0, 200.0)
    after = streamwise_slopes(np.rot90(surface, turns, axes=(1, 0)), 1.0, (200.0 - 90 * turns) % 360)
    assert after.windward == pytest.approx(before.windward)
    assert after.lee == pytest.approx(before.lee)


def test_flat_ground_between_ridges_does_not_count():
    ridge = np.concatenate([np.zeros(40), np.arange(12) / 12, np.arange(4, 0, -1) / 4, np.zeros(24)])
    slopes = streamwise_slopes(np.tile(HEIGHT * ridge, (6, 1)), 1.0, 270.0, width=0.0)
    a = HEIGHT / 12
    windward = (11 * a**2 + (a / 2) ** 2) / (11 * a + a / 2)
    assert slopes.windward == pytest.approx(degrees(windward))


@pytest.mark.parametrize("tilt", [(0.2, 0.0), (-0.1, 0.3)])
def test_waves_on_a_tilted_plane_have_the_slopes_of_the_waves(tilt):
    """Ten waves of 16 cells and amplitude 1 have the slopes sin(pi / 8) cos(k pi / 8) between cells.

    The sum of the squares of the positive cosines is 4, that of the cosines the cotangent of pi / 16.
    """
    east, north = np.meshgrid(np.arange(160), np.arange(96))
    waves = np.sin(2 * np.pi * east / 16)
    tilted = waves + tilt[0] * east + tilt[1] * north
    slopes = streamwise_slopes(tilted, 1.0, 270.0, (False, False), width=0.0)
    expected = degrees(4 * math.tan(math.pi / 16) * math.sin(math.pi / 8))
    assert slopes.windward == pytest.approx(expected, rel=0.005)
    assert slopes.lee == pytest.approx(expected, rel=0.005)


def test_a_plane_alone_has_no_bedforms():
    field = np.tile(0.2 * np.arange(COLUMNS), (ROWS, 1))
    slopes = streamwise_slopes(field, 1.0, 270.0, (False, False), width=0.0)
    assert math.isnan(slopes.windward) or slopes.windward < 1e-6
    assert math.isnan(slopes.lee) or slopes.lee < 1e-6


@pytest.mark.parametrize("level", [0.0, 3.0, 1 / 3])
@pytest.mark.parametrize("periodic", [(True, True), (False, False)])
def test_a_flat_bed_has_no_slopes(level, periodic):
    slopes = streamwise_slopes(np.full((ROWS, COLUMNS), level), 1.0, 270.0, periodic)
    assert math.isnan(slopes.windward)
    assert math.isnan(slopes.lee)


@pytest.mark.parametrize(("width", "angle"), [(1.0, 3.1), (2.0, 0.9)])
def test_what_smoothing_leaves_of_single_slabs_is_slope_too(width, angle):
    slabs = np.random.default_rng(1).integers(0, 3, (256, 256))
    slopes = streamwise_slopes(slabs / 3, 1.0, 270.0, width=width)
    assert slopes.windward == pytest.approx(angle, abs=0.1)
    assert slopes.lee == pytest.approx(angle, abs=0.1)


@pytest.mark.parametrize(("cell", "turned"), [(1.0, False), (2.5, True)])
@pytest.mark.parametrize("angle", [20.0, 33.0, 35.0])
def test_slip_faces_have_the_angle_they_are_built_with(angle, cell, turned):
    """Windward sides of 8 degrees, faces of 12 cells, and a level floor as wide as half the dune."""
    height = 12 * math.tan(math.radians(angle))
    rise = math.ceil(height / math.tan(math.radians(8.0)))
    dune = np.concatenate([np.arange(rise) / rise, np.arange(12, 0, -1) / 12, np.zeros(rise // 2)])
    field = np.tile(cell * height * dune, (6, 2))
    direction = 180.0 if turned else 270.0
    measured = slip_face_angle(field.T if turned else field, cell, direction)
    assert measured == pytest.approx(angle, abs=0.1)


def test_slip_faces_dip_to_the_horizontal_whatever_the_ground_under_them():
    """On ground that falls by 5 degrees a face that rises 28 degrees over it dips by their tangents' sum."""
    profile = (
        np.concatenate([np.arange(40) / 40, np.arange(12, 0, -1) / 12]) * 12 * math.tan(math.radians(28))
    )
    east = np.arange(4 * profile.size)
    surface = np.tile(np.tile(profile, 4) - math.tan(math.radians(5)) * east, (5, 1))
    expected = degrees(math.tan(math.radians(28)) + math.tan(math.radians(5)))
    assert slip_face_angle(surface, 1.0, 270.0, (False, False)) == pytest.approx(expected, abs=0.1)


def test_roughness_of_level_floors_hardly_lowers_slip_faces():
    dunes = np.tile(np.concatenate([np.arange(48) / 48, np.arange(16, 0, -1) / 16]) * 10.0, (64, 2))
    rough = dunes + np.random.default_rng(2).normal(0.0, 0.02, dunes.shape)
    assert slip_face_angle(rough, 1.0, 270.0) == pytest.approx(degrees(10 / 16), abs=0.7)


@pytest.mark.parametrize("measure", [streamwise_slopes, slip_face_angle])
def test_cells_that_are_unknown_have_no_slopes(measure):
    field = HEIGHT * ridges(4, 0)
    wall = field.copy()
    wall[10:20] = 100.0
    holed = np.where(wall == 100.0, np.nan, field)
    whole, measured = (measure(surface, 1.0, 270.0, width=0.0) for surface in (field, holed))
    assert np.allclose(
        [*vars(measured).values()] if measure is streamwise_slopes else measured,
        [*vars(whole).values()] if measure is streamwise_slopes else whole,
    )


def test_a_flat_bed_has_no_slip_faces():
    assert math.isnan(slip_face_angle(np.full((ROWS, COLUMNS), 2.0), 1.0, 270.0))
