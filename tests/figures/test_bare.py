"""Where no sand lies one sees the ground: grey, and rocks and stems in colours of their own."""

import numpy as np
import pytest
from matplotlib.colors import Normalize

from barchan.figures.bare import BARE, STANDING, standing_cells
from barchan.figures.maps import shaded, surface_range
from barchan.figures.sections import profile
from tests.tiny import COLUMNS, ROWS

GROUNDS = {
    "rock": {
        "kind": "three_rocks",
        "height": 0.0,
        "rocks": [{"west": 0.25, "east": 0.5, "south": 0.25, "north": 0.75}],
    },
    "stem": {"kind": "cylinders", "cylinders": [{"x": 0.4, "y": 0.5, "radius": 3.0, "height": 0.0}]},
}


@pytest.mark.parametrize("name", GROUNDS)
def test_what_stands_on_the_ground_has_a_colour_of_its_own(painted, name):
    frame, scenario = painted(0, ground=GROUNDS[name])
    colours = shaded(frame, scenario, norm=Normalize(0, 1))
    standing = standing_cells(scenario)
    assert standing[8, 9]
    np.testing.assert_allclose(
        colours[standing], np.broadcast_to(STANDING[name], colours[standing].shape), atol=1e-6
    )
    np.testing.assert_allclose(colours[~standing], np.broadcast_to(BARE, colours[~standing].shape), atol=1e-6)


@pytest.mark.parametrize("name", GROUNDS)
def test_a_section_names_what_stands_on_the_ground(painted, name):
    frame, scenario = painted(0, ground=GROUNDS[name])
    legend = profile(frame, scenario, at=0.5).axes[0].get_legend()
    assert [text.get_text() for text in legend.get_texts()] == [name]


def test_smoothed_single_bare_cells_thin_the_colour_of_sand(painted):
    """Smoothed over 0.8 cells a bare cell keeps 1 / (2π 0.64) = 0.249 of itself, on a lattice about."""
    sand = np.full((ROWS, COLUMNS), 3)
    sand[8, 12] = 0
    frame, scenario = painted(sand)
    colours = shaded(frame, scenario, norm=Normalize(-1e3, 1e3), smoothing=0.8)
    exact = shaded(frame, scenario, norm=Normalize(-1e3, 1e3))
    np.testing.assert_allclose(shade_free(exact[8, 12]), shade_free(np.array(BARE)), atol=0.02)
    assert np.ptp(colours[8, 12]) > 0.2


def shade_free(colour):
    """A colour's hue and chroma, without its brightness."""
    return colour / colour.max()


def test_the_colours_of_sand_span_the_sand_alone(painted):
    """A rock of 9 m on which no sand lies does not take part in the scale."""
    ground = {**GROUNDS["rock"], "height": 9.0}
    sand = np.full((ROWS, COLUMNS), 3)
    sand[:, :2] = 6
    frame, scenario = painted(sand, ground=ground)
    sand[frame["ground"].values > 0] = 0
    frame, scenario = painted(sand, ground=ground)
    assert surface_range(frame, scenario) == pytest.approx((1.0, 2.0))
    assert surface_range(frame, scenario, show_bare=False) == pytest.approx((1.0, 9.0))


@pytest.mark.parametrize(("slabs", "expected"), [(3, (0.0, 1.0)), (0, (0.0, 1 / 3))])
def test_the_scale_of_a_level_bed_does_not_begin_below_the_ground(painted, slabs, expected):
    assert surface_range(*painted(slabs)) == pytest.approx(expected)
