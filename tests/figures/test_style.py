"""Colours, and smoothing for display."""

import numpy as np
import pytest

from barchan.figures.style import colour_map, extent, heading, new_figure, smooth, title
from tests.tiny import tiny

HEIGHTS = np.linspace(0, 1, 101)


def lightness(colours):
    """The relative luminance of a colour map over heights."""
    return colour_map(colours)(HEIGHTS)[:, :3] @ (0.2126, 0.7152, 0.0722)


@pytest.mark.parametrize("colours", ["natural", "perceptual", "grey"])
def test_lightness_changes_one_way_with_height(colours):
    steps = np.diff(lightness(colours))
    assert (steps > -1e-3).all() or (steps < 1e-3).all()
    assert abs(lightness(colours)[-1] - lightness(colours)[0]) > 0.3


def test_red_is_the_highest_and_green_the_lowest():
    low, _, high = colour_map("red-green")([0.0, 0.5, 1.0])
    assert high[0] > 2 * high[1]
    assert low[1] > 2 * low[0]


def test_grey_is_grey():
    colours = colour_map("grey")(HEIGHTS)
    np.testing.assert_array_equal(colours[:, 0], colours[:, 1])
    np.testing.assert_array_equal(colours[:, 0], colours[:, 2])


def test_a_map_reaches_from_edge_to_edge():
    assert extent(tiny(lattice__cell_size=2.0)) == (0.0, 48.0, 0.0, 32.0)


def test_no_smoothing_leaves_a_surface_as_it_is():
    surface = np.random.default_rng(1).integers(0, 9, (16, 24))
    np.testing.assert_array_equal(smooth(surface, 0.0, tiny()), surface)


def test_smoothing_keeps_the_mean_of_a_joined_field():
    surface = np.random.default_rng(1).integers(0, 9, (16, 24))
    assert smooth(surface, 2.0, tiny()).mean() == pytest.approx(surface.mean())


def test_smoothing_does_not_cross_an_open_edge():
    surface = np.zeros((16, 24))
    surface[:, 0] = 1.0
    assert smooth(surface, 1.0, tiny())[8, -1] > 0.1
    assert smooth(surface, 1.0, tiny(lattice__boundary_x="open"))[8, -1] == 0.0


@pytest.mark.parametrize(("given", "shown"), [("Tiny", "Tiny, step 5, seed 7"), ("", "Run, step 5, seed 7")])
def test_a_picture_is_called_after_its_scenario(given, shown):
    assert title(tiny().model_copy(update={"title": given}), 5) == shown


def test_sand_is_lighter_upwards():
    assert (np.diff(lightness("natural")) > 0).all()


def test_a_long_title_is_broken_into_lines():
    figure = new_figure(3.0, 3.0)
    heading(figure, "words " * 20)
    assert all(len(line) <= 38 for line in figure.get_suptitle().splitlines())
