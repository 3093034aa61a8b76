"""What stands in front hides what lies behind."""

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from barchan.errors import BarchanError
from barchan.figures.oblique import oblique_view, seen_obliquely

ROWS, COLS = 40, 3
SHADES = np.repeat(np.linspace(0.0, 0.9, ROWS), COLS).reshape(ROWS, COLS)[..., None].repeat(3, axis=2)
"""Each row has a grey of its own, dark in the south."""


def rows_seen(surface, angle):
    """Which rows of the surface the first column of a picture shows, from below."""
    picture = seen_obliquely(surface, SHADES, angle)[::-1, 0, 0]
    return np.rint(picture[picture < 1] / 0.9 * (ROWS - 1)).astype(int)


def test_from_straight_above_every_row_is_seen_once_and_north_is_up():
    wall = np.zeros((ROWS, COLS))
    wall[20] = 10.0
    assert list(rows_seen(wall, 90.0)) == list(range(ROWS))


@pytest.mark.parametrize("angle", [20.0, 35.0, 60.0])
def test_level_ground_is_foreshortened_by_the_sine_of_the_angle(angle):
    seen = rows_seen(np.zeros((ROWS, COLS)), angle)
    assert len(seen) == round(ROWS * np.sin(np.radians(angle)))
    assert (np.diff(seen) > 0).all()


@pytest.mark.parametrize("angle", [20.0, 35.0, 60.0])
def test_a_wall_hides_the_ground_behind_as_far_as_its_height_over_the_tangent(angle):
    height = 6.0
    wall = np.zeros((ROWS, COLS))
    wall[10] = height
    seen = rows_seen(wall, angle)
    first = seen[seen > 10].min()
    pixel = 1 / np.sin(np.radians(angle))
    assert first - 10 == pytest.approx(height / np.tan(np.radians(angle)) + 1, abs=1.5 * pixel)
    tall = np.sum(seen == 10)
    assert tall == pytest.approx(height * np.cos(np.radians(angle)) + np.sin(np.radians(angle)), abs=1.5)


@pytest.mark.parametrize("angle", [0.0, 91.0, float("nan")])
def test_other_angles_are_refused(angle):
    with pytest.raises(BarchanError, match="allowed: 5 to 90"):
        seen_obliquely(np.zeros((ROWS, COLS)), SHADES, angle)


def test_every_kind_of_field_is_drawn(field):
    scenario, frames = field
    figure = oblique_view(frames.isel(step=-1), scenario)
    FigureCanvasAgg(figure).draw()
    assert figure.axes[0].images
