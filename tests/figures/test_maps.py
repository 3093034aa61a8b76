"""Maps lie as maps do: north up, east to the right, lit from the north-west."""

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import Normalize
from matplotlib.contour import QuadContourSet

from barchan.directions import downwind
from barchan.errors import BarchanError
from barchan.figures.bare import BARE
from barchan.figures.contours import contour_map, round_interval
from barchan.figures.maps import relief_map, shaded
from barchan.figures.style import colour_map
from tests.tiny import COLUMNS, ROWS

CORNERS = {"south-west": (2, 3), "south-east": (2, 20), "north-west": (13, 3), "north-east": (13, 20)}


def pixel(figure, x, y):
    """The colour of a drawn map at a place (m)."""
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    picture = np.asarray(canvas.buffer_rgba())
    right, up = figure.axes[0].transData.transform((x, y))
    return picture[picture.shape[0] - 1 - int(up), int(right), :3] / 255


def greyness(colour):
    """How far a colour is from grey."""
    return float(np.ptp(colour))


def patch(row, col):
    """Sand about one place on bare ground."""
    sand = np.zeros((ROWS, COLUMNS), int)
    sand[row - 2 : row + 3, col - 2 : col + 3] = 5
    return sand


@pytest.mark.parametrize("draw", [relief_map, contour_map])
@pytest.mark.parametrize("corner", CORNERS.values(), ids=list(CORNERS))
def test_a_patch_of_sand_is_drawn_in_its_corner(painted, draw, corner):
    frame, scenario = painted(patch(*corner), lattice__cell_size=10.0)
    figure = draw(frame, scenario)
    colours = {
        place: pixel(figure, (col + 0.5) * 10.0, (row + 0.5) * 10.0) for place, (row, col) in CORNERS.items()
    }
    (place,) = (name for name, where in CORNERS.items() if where == corner)
    found = colours.pop(place)
    bare = list(colours.values())
    assert all(np.allclose(colour, bare[0], atol=0.02) for colour in bare)
    assert np.abs(found - bare[0]).max() > 0.1


def test_bare_ground_is_grey_and_sand_is_not(painted):
    frame, scenario = painted(patch(8, 12))
    colours = shaded(frame, scenario, norm=Normalize(0, 2))
    np.testing.assert_allclose(colours[1, 1], BARE, atol=1e-6)
    assert greyness(colours[8, 12]) > 0.2
    unmarked = shaded(frame, scenario, norm=Normalize(0, 2), show_bare=False)
    assert greyness(unmarked[1, 1]) > 0.2


def test_slopes_that_face_north_west_are_bright_and_those_that_face_south_east_dark(painted):
    row, col = np.mgrid[0:ROWS, 0:COLUMNS]
    cone = np.maximum(0, 12 - 2 * np.maximum(abs(row - 8), abs(col - 12)))
    frame, scenario = painted(cone + 1)
    light = shaded(frame, scenario, norm=Normalize(-1000, 1000), colours="grey").mean(axis=-1)
    assert light[11, 9] > light[1, 1] > light[5, 15]
    assert light[11, 9] > light[11, 15]
    assert light[11, 9] > light[5, 9]


def test_level_ground_has_the_colours_of_the_scale(painted):
    frame, scenario = painted(3)
    colours = shaded(frame, scenario, norm=Normalize(0, 2), colours="grey")
    np.testing.assert_allclose(
        colours, np.broadcast_to(colour_map("grey")(0.5)[:3], colours.shape), atol=0.01
    )


@pytest.mark.parametrize("draw", [relief_map, contour_map])
def test_a_map_measures_the_field_in_metres(painted, draw):
    frame, scenario = painted(patch(8, 12), lattice__cell_size=10.0)
    figure = draw(frame, scenario)
    axes = figure.axes[0]
    assert axes.get_xlim() == (0.0, 240.0)
    assert axes.get_ylim() == (0.0, 160.0)
    assert axes.get_xlabel() == "x (m)"
    assert figure.get_suptitle() == "Tiny, changed: lattice.cell_size 10, step 0, seed 7"


@pytest.mark.parametrize("draw", [relief_map, contour_map])
@pytest.mark.parametrize(("limits", "expected"), [(None, (0.0, 5 / 3)), ((-1.0, 4.0), (-1.0, 4.0))])
def test_the_colour_scale_follows_the_surface_unless_it_is_fixed(painted, draw, limits, expected):
    frame, scenario = painted(patch(8, 12))
    given = {} if draw is relief_map else {"smoothing": 0.0}
    scale = draw(frame, scenario, limits=limits, **given).axes[1]
    assert scale.get_ylim() == pytest.approx(expected)
    assert scale.get_ylabel().startswith("elevation (m)")


def levels_of(figure):
    (contours,) = (c for c in figure.axes[0].collections if isinstance(c, QuadContourSet))
    return contours.levels


def hill_of(painted):
    row, col = np.mgrid[0:ROWS, 0:COLUMNS]
    return painted(np.maximum(0, 9 - np.hypot(row - 5, col - 17)).astype(int))


@pytest.mark.parametrize("interval", [0.2, 0.5, 1.0])
def test_contours_stand_at_multiples_of_their_interval(painted, interval):
    frame, scenario = hill_of(painted)
    levels = levels_of(contour_map(frame, scenario, interval=interval, smoothing=0.0))
    count = int(np.floor(3.0 / interval + 1e-9)) + 1
    np.testing.assert_allclose(levels, np.arange(count) * interval, atol=1e-12)


@pytest.mark.parametrize("count", [1, 4, 10])
def test_there_are_as_many_contours_as_asked_for(painted, count):
    frame, scenario = hill_of(painted)
    levels = levels_of(contour_map(frame, scenario, count=count))
    assert len(levels) == count
    assert np.ptp(np.diff(levels)) < 1e-9 if count > 1 else True


def test_contours_run_through_the_centres_of_cells_of_their_height(painted):
    frame, scenario = painted(np.tile(np.arange(COLUMNS), (ROWS, 1)), lattice__cell_size=3.0)
    figure = contour_map(frame, scenario, interval=5.0, smoothing=0.0)
    (contours,) = (c for c in figure.axes[0].collections if isinstance(c, QuadContourSet))
    paths = contours.get_paths()
    drawn = [(level, path.vertices[:, 0]) for level, path in zip(contours.levels, paths, strict=True)]
    places = [np.full(len(x), (level + 0.5) * 3.0) for level, x in drawn]
    np.testing.assert_allclose(np.concatenate([x for _, x in drawn]), np.concatenate(places), atol=1e-6)
    assert sum(len(x) > 1 for _, x in drawn) >= 4


def arrow(figure):
    """The wind's arrow as it is drawn in pixels, right and up."""
    FigureCanvasAgg(figure).draw()
    (found,) = (text for text in figure.axes[0].texts if getattr(text, "arrow_patch", None) is not None)
    tail, _, tip = found.arrow_patch.get_path().vertices[:3]
    return tip - tail


@pytest.mark.parametrize("direction", [270.0, 180.0, 90.0, 0.0])
def test_the_arrow_points_where_the_wind_blows(painted, direction):
    along = arrow(relief_map(*painted(3, direction)))
    np.testing.assert_allclose(along / np.hypot(*along), downwind(direction), atol=0.01)


@pytest.mark.parametrize("direction", [225.0, 300.0, 20.0])
def test_the_arrow_points_where_an_oblique_wind_blows(painted, direction):
    along = arrow(relief_map(*painted(3, direction)))
    np.testing.assert_allclose(along / np.hypot(*along), downwind(direction), atol=0.02)


@pytest.mark.parametrize("rows", [1, 16])
def test_the_arrow_is_equally_long_whatever_the_wind(painted, rows):
    west, north = (arrow(relief_map(*painted(3, d, lattice__rows=rows))) for d in (270.0, 0.0))
    assert np.hypot(*north) == pytest.approx(np.hypot(*west), rel=0.05)


def test_the_arrow_is_of_the_frames_wind_not_of_the_first(painted):
    frame, scenario = painted(3)
    frame["wind_direction"] = frame["wind_direction"] * 0 + 90.0
    assert arrow(relief_map(frame, scenario))[0] < 0


def test_more_contours_than_can_be_drawn_are_refused(painted):
    with pytest.raises(BarchanError, match=r"contours every 1e-06 m .* allowed here: an interval of"):
        contour_map(*painted(3), interval=1e-6)


@pytest.mark.parametrize(
    ("span", "interval"), [(10.0, 1.0), (0.03, 0.005), (250.0, 20.0), (3.0, 0.5), (1.7, 0.2)]
)
def test_contours_lie_a_round_interval_apart(span, interval):
    assert round_interval(span) == pytest.approx(interval)


def test_contours_carry_their_elevations_and_the_bar_names_the_interval(painted):
    """A plane from 0 to 23/3 m: contours every metre."""
    frame, scenario = painted(np.tile(np.arange(COLUMNS), (ROWS, 1)))
    figure = contour_map(frame, scenario, smoothing=0.0)
    np.testing.assert_allclose(levels_of(figure), np.arange(8.0))
    labels = {text.get_text() for text in figure.axes[0].texts} - {"", "wind"}
    assert labels <= {"0", "1", "2", "3", "4", "5", "6", "7"}
    assert len(labels) >= 4
    assert figure.axes[1].get_ylabel().endswith("contours every 1 m")


LONG = "The title of a run that somebody wrote with much care and at some length"
SHAPES = {"tall": (256, 16), "low": (16, 256), "one row": (1, 64), "as high as wide": (64, 64)}


@pytest.mark.parametrize("shape", SHAPES.values(), ids=list(SHAPES))
def test_nothing_is_printed_over_anything_else(painted, shape):
    rows, columns = shape
    frame, scenario = painted(3, lattice__rows=rows, lattice__columns=columns)
    figure = relief_map(frame, scenario.model_copy(update={"title": LONG}))
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    axes, bar = figure.axes
    texts = [axes.xaxis.label, axes.yaxis.label, bar.xaxis.label, bar.yaxis.label, figure._suptitle]
    texts += [text for text in axes.texts if text.get_text() == "wind"]
    texts += [label for axis in (axes.xaxis, axes.yaxis, long_axis(bar)) for label in marks(axis)]
    boxes = {(k, t.get_text()): t.get_window_extent() for k, t in enumerate(texts) if t.get_text()}
    names = list(boxes)
    over = [(a, b) for k, a in enumerate(names) for b in names[:k] if boxes[a].overlaps(boxes[b])]
    assert over == []
    page = figure.bbox.padded(1.0)
    outside = [n for n, box in boxes.items() if not (page.contains(*box.min) and page.contains(*box.max))]
    assert outside == []


def long_axis(bar):
    """The axis of a colour bar that carries its scale."""
    return bar.yaxis if bar.yaxis.label.get_text() else bar.xaxis


def marks(axis):
    """The labels of an axis's marks that lie on it and are shown."""
    low, high = sorted(axis.get_view_interval())
    ticks = [tick for tick in axis.get_major_ticks() if low <= tick.get_loc() <= high]
    return [label for tick in ticks for label in (tick.label1, tick.label2) if label.get_visible()]


@pytest.mark.parametrize(
    ("shape", "labels"),
    [
        ((1, 64), ("x (m), y is not to scale", "y (m)")),
        ((256, 16), ("x (m)", "y (m), x is not to scale")),
        ((16, 64), ("x (m)", "y (m)")),
    ],
)
def test_a_map_says_where_it_is_not_to_scale(painted, shape, labels):
    axes = relief_map(*painted(3, lattice__rows=shape[0], lattice__columns=shape[1])).axes[0]
    assert (axes.get_xlabel(), axes.get_ylabel()) == labels
