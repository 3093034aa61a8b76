"""Sections along the wind, from the upwind to the downwind edge, with the shadows the wind casts."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from matplotlib.backends.backend_agg import FigureCanvasAgg

from barchan.archive import dataset_of
from barchan.bed import Bed
from barchan.directions import downwind
from barchan.entry import simulate
from barchan.figures.section_lines import section_along_wind, shadow_line
from barchan.figures.sections import profile
from barchan.figures.space_time import space_time
from barchan.models import models
from barchan.simulation import SetParameter, Simulation
from tests.tiny import COLUMNS, RIDGES, ROWS, tiny

directions = st.floats(0, 360, exclude_max=True)
places = st.floats(0, 1)

EASTWARDS, NORTHWARDS = list(range(COLUMNS)), list(range(ROWS))


@pytest.mark.parametrize(
    ("direction", "at", "rows", "columns"),
    [
        (270.0, 0.0, [0] * COLUMNS, EASTWARDS),
        (270.0, 1.0, [15] * COLUMNS, EASTWARDS),
        (180.0, 0.0, NORTHWARDS, [23] * ROWS),
        (180.0, 1.0, NORTHWARDS, [0] * ROWS),
        (90.0, 0.0, [15] * COLUMNS, EASTWARDS[::-1]),
        (90.0, 1.0, [0] * COLUMNS, EASTWARDS[::-1]),
        (0.0, 0.0, NORTHWARDS[::-1], [0] * ROWS),
        (0.0, 1.0, NORTHWARDS[::-1], [23] * ROWS),
    ],
)
def test_a_section_along_an_axis_is_a_row_or_column_from_the_upwind_edge(direction, at, rows, columns):
    section = section_along_wind(tiny(lattice__cell_size=2.0), direction, at)
    assert section.rows.tolist() == rows
    assert section.cols.tolist() == columns
    np.testing.assert_allclose(section.distance, 2.0 * np.arange(len(rows)))
    assert section.joined


@pytest.mark.parametrize(("direction", "joined"), [(270.0, False), (90.0, False), (0.0, True), (180.0, True)])
def test_a_section_closes_on_itself_only_across_joined_edges(direction, joined):
    assert section_along_wind(tiny(lattice__boundary_x="open"), direction, 0.5).joined == joined


@settings(max_examples=200)
@given(directions, places)
def test_a_section_runs_downwind_through_the_field_cell_by_cell(direction, at):
    section = section_along_wind(tiny(), direction, at)
    assert ((section.rows >= 0) & (section.rows < ROWS)).all()
    assert ((section.cols >= 0) & (section.cols < COLUMNS)).all()
    assert section.distance[0] == 0.0
    assert (np.diff(section.distance) > 0).all()
    steps = np.stack([np.diff(section.rows), np.diff(section.cols)])
    assert (np.abs(steps).max(axis=0) == 1).all() if steps.size else True


@settings(max_examples=100)
@given(directions, places)
def test_an_oblique_section_stays_within_a_cell_of_its_line(direction, at):
    section = section_along_wind(tiny(), direction, at)
    x, y = downwind(direction)
    beside = x * (section.rows - (ROWS - 1) / 2) - y * (section.cols - (COLUMNS - 1) / 2)
    width = abs(x) * (ROWS - 1) + abs(y) * (COLUMNS - 1)
    assert np.abs(beside - (at - 0.5) * width).max() <= math.sqrt(0.5) + 1e-6


@settings(max_examples=100)
@given(directions, places)
def test_a_section_reaches_from_edge_to_edge(direction, at):
    """One more step up or down the wind leads out of the field."""
    section = section_along_wind(tiny(), direction, at)
    x, y = downwind(direction)
    for end, sign in ((0, -1), (-1, 1)):
        row, col = section.rows[end] + sign * 1.5 * y, section.cols[end] + sign * 1.5 * x
        assert not (0 <= row <= ROWS - 1 and 0 <= col <= COLUMNS - 1)


def highest_line(distance, surface, i, slope, start, length):
    """The highest of the lines that fall over point ``i`` from all points upwind, one by one."""
    lines = [
        surface[j] - slope * (distance[i] - distance[j] - start + turn)
        for turn in ([0.0, length] if length else [0.0])
        for j in range(len(surface))
        if distance[j] - turn < distance[i]
    ]
    return max(lines, default=-math.inf)


@settings(max_examples=60)
@given(
    st.lists(st.integers(0, 12), min_size=24, max_size=24),
    st.sampled_from([270.0, 90.0]),
    st.sampled_from(["periodic", "open"]),
    st.floats(1, 80),
    st.sampled_from([0.0, 0.5]),
)
def test_the_shadow_line_is_the_highest_line_that_falls_from_anything_upwind(
    stacks, direction, boundary, angle, start
):
    scenario = tiny(lattice__cell_size=2.0, lattice__boundary_x=boundary)
    section = section_along_wind(scenario, direction, 0.5)
    surface = np.array(stacks, float)
    length = 48.0 if boundary == "periodic" else 0.0
    line = shadow_line(section, surface, angle, 2.0, start)
    slope = math.tan(math.radians(angle))
    expected = [
        highest_line(section.distance, surface, i, slope, start * 2.0, length) for i in range(len(stacks))
    ]
    np.testing.assert_allclose(line, expected, rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("direction", [270.0, 180.0, 90.0, 0.0])
@pytest.mark.parametrize("shadow_from", ["centre", "edge", "place"])
@pytest.mark.parametrize("boundary", ["periodic", "open"])
def test_shadows_in_a_section_are_the_models_shadows(direction, shadow_from, boundary):
    scenario = tiny(
        wind__direction=direction,
        lattice__boundary_x=boundary,
        lattice__boundary_y=boundary,
        model__shadow_from=shadow_from,
    )
    sand = np.random.default_rng(2).integers(0, 6, (ROWS, COLUMNS)).astype(np.int32)
    bed = Bed(scenario.lattice, np.zeros((ROWS, COLUMNS)), sand)
    zone = models()["werner"](scenario.model, scenario.lattice).shadow_zone(bed, direction)
    assert zone.any()
    for at in (0.0, 0.4, 1.0):
        section = section_along_wind(scenario, direction, at)
        surface = bed.elevation[section.rows, section.cols]
        line = shadow_line(section, surface, 15.0, 1.0, 0.0 if shadow_from == "centre" else 0.5)
        np.testing.assert_array_equal(line > surface, zone[section.rows, section.cols])


@settings(max_examples=25)
@given(directions, st.integers(0, ROWS - 1), st.integers(0, COLUMNS - 1))
def test_the_profile_goes_through_the_highest_stack(one_stack, direction, row, col):
    frame, scenario = one_stack(row, col, direction)
    axes = profile(frame, scenario).axes[0]
    highest = max(patch.get_path().vertices[:, 1].max() for patch in axes.patches)
    assert highest == pytest.approx(9 / 3)


@pytest.fixture(scope="session")
def one_stack():
    """Make a frame with a single stack, under any wind."""
    scenario = tiny(run__steps=0)
    level = simulate(scenario).isel(step=-1)

    def make(row, col, direction):
        frame = level.copy(deep=True)
        frame["sand"][...] = 0
        frame["sand"][row, col] = 9
        frame["elevation"][...] = frame["sand"] / 3
        frame["wind_direction"] = frame["wind_direction"] * 0 + direction
        return frame, scenario

    return make


@pytest.mark.parametrize("direction", [270.0, 90.0])
def test_a_profile_shows_the_surface_from_the_upwind_edge(painted, direction):
    heap = np.zeros((ROWS, COLUMNS), int)
    heap[8, 4] = 6
    frame, scenario = painted(heap, direction)
    axes = profile(frame, scenario).axes[0]
    places = [p for p in patch_of(axes, "sand").get_path().vertices if p[1] == pytest.approx(2.0)]
    centre = np.mean([p[0] for p in places])
    assert centre == pytest.approx(4.0 if direction == 270.0 else 19.0)
    assert axes.get_xlabel() == "distance downwind (m)"


def test_space_and_time_shows_every_frame_at_its_step():
    scenario = tiny()
    dataset = simulate(scenario)
    figure = space_time(dataset, scenario, at=0.0)
    (mesh,) = figure.axes[0].collections
    np.testing.assert_array_equal(np.asarray(mesh.get_array()), dataset["elevation"].values[:, 0, :])
    assert mesh.get_coordinates()[:, 0, 1].tolist() == [-2.5, 2.5, 7.5, 12.5, 17.5, 22.5]


@pytest.mark.parametrize("at", [-0.5, 2.0])
def test_a_place_beside_the_field_is_refused(at):
    with pytest.raises(ValueError, match="0 to 1"):
        section_along_wind(tiny(), 270.0, at)


def test_shadows_in_a_section_follow_the_angle_in_force_at_the_frame():
    simulation = Simulation(tiny(**RIDGES, run__steps=10))
    simulation.advance(5)
    simulation.apply(SetParameter(key="model.shadow_angle", value=5.0))
    frame = dataset_of(simulation, list(simulation)).isel(step=-1)
    changed = simulation.scenario.model_copy(update={"model": simulation.model.parameters})
    shadows = [
        shadow_of(profile(shown, scenario))
        for shown, scenario in ((frame, simulation.scenario), (frame.drop_attrs(), changed))
    ]
    np.testing.assert_array_equal(*shadows)
    assert len(shadow_of(profile(frame.drop_attrs(), simulation.scenario))) < len(shadows[0])


def shadow_of(figure):
    """The corners of the shadow zones in a picture of a section."""
    return patch_of(figure.axes[0], "shadow zone").get_path().vertices


def patch_of(axes, name):
    """What a section draws under a name of its legend."""
    (found,) = (patch for patch in axes.patches if patch.get_label() == name)
    return found


def test_a_section_of_bare_rock_has_no_sand(painted):
    axes = profile(*painted(0), at=0.5).axes[0]
    assert len(axes.patches) == 1  # the ground
    assert axes.get_legend() is None
    assert axes.get_ylim()[1] > 0


def test_sand_is_drawn_only_where_it_lies_as_wide_as_its_cells(painted):
    heap = np.zeros((ROWS, COLUMNS), int)
    heap[8, 4:7] = 6
    axes = profile(*painted(heap), at=0.5).axes[0]
    corners = patch_of(axes, "sand").get_path().vertices
    assert (corners[:, 0].min(), corners[:, 0].max()) == (3.5, 6.5)


def test_a_section_says_where_it_lies_and_its_exaggeration(painted):
    """Row 4 of cells of 10 m has its middle at 45 m; a degree of height is drawn as long as it is said."""
    frame, scenario = painted(4, lattice__cell_size=10.0)
    figure = profile(frame, scenario, at=4 / 15)
    axes = figure.axes[0]
    first, second = axes.get_title("left").splitlines()
    assert first == "Tiny, changed: lattice.cell_size 10, step 0, seed 7"
    place, factor = second.split(", vertical exaggeration ")
    assert place == "along y = 45 m"
    FigureCanvasAgg(figure).draw()
    (x0, y0), (x1, y1) = axes.transData.transform([(0.0, 0.0), (1.0, 1.0)])
    assert (y1 - y0) / (x1 - x0) == pytest.approx(float(factor), rel=1e-3)


@pytest.mark.parametrize(("direction", "place"), [(180.0, "along x = 12.5 m"), (270.0, "along y = 8.5 m")])
def test_the_middle_section_lies_in_the_middle(direction, place):
    assert section_along_wind(tiny(), direction, 0.5).place == place


def test_a_section_of_one_cell_has_its_true_width(painted):
    axes = profile(*painted(3, lattice__rows=1, direction=0.0), at=0.5).axes[0]
    corners = patch_of(axes, "sand").get_path().vertices[:, 0]
    assert (corners.min(), corners.max()) == (-0.5, 0.5)
    assert axes.get_aspect() >= 1.0
    assert axes.get_xlim()[0] < -0.5


def test_of_deep_sand_a_section_shows_the_upper_part(painted):
    """Sand of 30 m with ridges of 1 m: as much again is shown below them, and an eighth."""
    sand = np.full((ROWS, COLUMNS), 90)
    sand[:, ::6] = 93
    low, high = profile(*painted(sand), at=0.5).axes[0].get_ylim()
    assert 28.5 < low < 29.0
    assert 31.0 < high < 31.5


def test_a_single_frame_fills_a_band_of_space_and_time():
    scenario = tiny()
    axes = space_time(simulate(scenario).isel(step=[-1]), scenario, at=0.0).axes[0]
    assert axes.get_ylim() == (19.5, 20.5)
    assert [label.get_text() for label in axes.get_yticklabels()] == ["20"]


def test_time_is_that_of_the_clock_where_there_is_one():
    scenario = tiny()
    dataset = simulate(scenario)
    clocked = dataset.assign_coords(time=("step", dataset["step"].values * 43_200.0))
    axes = space_time(clocked, scenario, at=0.0).axes[0]
    assert axes.get_ylabel() == "time (days)"
    (mesh,) = axes.collections
    np.testing.assert_allclose(mesh.get_coordinates()[:, 0, 1], [-1.25, 1.25, 3.75, 6.25, 8.75, 11.25])


def test_a_long_title_does_not_run_into_the_words_for_the_wind():
    scenario = tiny(
        title="A form like a dune on which a title of a paper stands in its full length, and more"
    )
    dataset = simulate(scenario)
    for figure in (space_time(dataset, scenario), profile(dataset.isel(step=-1), scenario)):
        figure.draw_without_rendering()
        axes = figure.axes[0]
        (wind,) = axes.texts
        assert axes.title.get_text() == ""
        assert axes._left_title.get_window_extent().x1 < wind.get_window_extent().x0
