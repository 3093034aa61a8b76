"""Maps and sections of any field."""

import io

import numpy as np
import pytest

from barchan.analysis.fields import field_names, field_of
from barchan.entry import simulate
from barchan.figures.fields import field_map, limits_of
from barchan.figures.sections import profile
from barchan.models import models
from tests.tiny import COLUMNS, ROWS, tiny


def drawn(figure):
    file = io.BytesIO()
    figure.savefig(file, format="png", dpi=40)
    return file.getvalue().startswith(b"\x89PNG")


@pytest.mark.parametrize("direction", [270.0, pytest.param(217.0, marks=pytest.mark.extended)])
def test_every_field_of_every_model_can_be_drawn(direction):
    """Every one is made; of those that several models have one is drawn; sections show two of each model."""
    seen = set()
    for name in models():
        scenario = tiny(model={"name": name}, wind__direction=direction)
        frame = simulate(scenario).isel(step=-1)
        fields = {name: field_of(frame, scenario, name) for name in field_names(frame, scenario)}
        for field in (fields[name] for name in fields if name not in seen):
            assert drawn(field_map(field, frame, scenario))
        for field in [*fields.values()][:: len(fields) - 1]:
            assert drawn(profile(frame, scenario, field=field))
        seen |= set(fields)


def test_fields_of_every_lattice_can_be_drawn(field):
    scenario, dataset = field
    frame = dataset.isel(step=-1)
    for name in ("slope", "shadow", "sand"):
        values = field_of(frame, scenario, name)
        assert drawn(field_map(values, frame, scenario, colours="grey", smoothing=1.0))
        assert drawn(profile(frame, scenario, field=values, smoothing=1.0))


def dunes(**changes):
    scenario = tiny(model={"name": "momiji"}, **changes)
    return simulate(scenario).isel(step=-1), scenario


def test_a_colour_bar_tells_what_is_drawn_and_its_unit():
    frame, scenario = dunes()
    labels = {
        name: field_map(field_of(frame, scenario, name), frame, scenario).axes[1].get_ylabel()
        for name in ("hop", "shadow")
    }
    assert labels == {"hop": "hop length (cells)", "shadow": "in shadow of the wind"}


def test_colours_lie_evenly_about_the_value_of_a_flat_bed():
    frame, scenario = dunes()
    low, high = field_map(field_of(frame, scenario, "hop"), frame, scenario).axes[1].get_ylim()
    assert (low + high) / 2 == pytest.approx(5.0)


def test_colour_scales_leave_out_no_more_than_a_few_cells():
    values = np.arange(1000.0)
    values[-1] = 1e9
    assert limits_of(values, None) == pytest.approx((5, 994), abs=1)
    assert limits_of(values, 300.0) == pytest.approx((-394, 994), abs=1)
    low, high = limits_of(np.ones(9), None)
    assert low < 1 < high


def test_limits_can_be_fixed():
    frame, scenario = dunes()
    assert field_map(field_of(frame, scenario, "hop"), frame, scenario, limits=(0.0, 8.0)).axes[
        1
    ].get_ylim() == (0, 8)


def test_a_field_lies_on_its_map_as_on_the_bed(painted):
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    sand = np.zeros((ROWS, COLUMNS), int)
    sand[10:15, 2:7] = 1
    frame, scenario = painted(sand)
    figure = field_map(field_of(frame, scenario, "sand"), frame, scenario, limits=(0.0, 1.0))
    FigureCanvasAgg(figure).draw()
    (image,) = figure.axes[0].images
    shown = np.asarray(image.get_array())
    assert image.origin == "lower"
    assert shown[12, 4].mean() < 0.4 < shown[3, 4].mean()


def test_a_section_shows_its_field_below_over_the_same_distance():
    frame, scenario = dunes()
    above, below = profile(frame, scenario, at=0.5, field=field_of(frame, scenario, "hop")).axes
    assert above.get_xlim() == below.get_xlim()
    assert below.get_ylabel() == "hop length (cells)"
    assert (above.get_xlabel(), below.get_xlabel()) == ("", "distance downwind (m)")


def test_the_pale_curve_is_the_field_cell_by_cell():
    frame, scenario = dunes()
    hop = field_of(frame, scenario, "hop")
    _, below = profile(frame, scenario, at=0.0, field=hop).axes
    (cells,) = (line for line in below.lines if line.get_label() == "single cells")
    np.testing.assert_allclose(cells.get_ydata(), hop.values[0])
    assert any(set(line.get_ydata()) == {5.0} for line in below.lines)


def test_a_curve_of_what_is_zero_in_shadow_is_that_of_the_cells_in_the_wind(painted):
    """Ridges of one slab on a flat: each shelters one cell, and all others have the same hop."""
    sand = np.full((ROWS, COLUMNS), 3)
    sand[:, ::6] = 4
    frame, scenario = painted(sand, model={"name": "momiji", "speedup_linear": 0.0, "speedup_quadratic": 0.0})
    hop = field_of(frame, scenario, "hop")
    assert set(hop.values.flat) == {0.0, 5.0}
    _, below = profile(frame, scenario, at=0.5, field=hop).axes
    (curve,) = (line for line in below.lines if "in the wind" in line.get_label())
    np.testing.assert_allclose(curve.get_ydata(), 5.0)


def test_a_curve_has_a_gap_where_most_cells_stand_in_shadow(painted):
    sand = np.full((ROWS, COLUMNS), 1)
    sand[:, 4:6] = 12
    frame, scenario = painted(sand, model={"name": "momiji"}, lattice__boundary_x="open")
    _, below = profile(frame, scenario, at=0.5, field=field_of(frame, scenario, "hop")).axes
    (curve,) = (line for line in below.lines if "in the wind" in line.get_label())
    assert np.isnan(curve.get_ydata()[8:16]).all()
    assert np.isfinite(curve.get_ydata()[:5]).all()


def test_the_colours_of_stress_do_not_begin_below_zero():
    scenario = tiny(model={"name": "pelletier"}, sand={"kind": "random", "mean": 9})
    frame = simulate(scenario).isel(step=-1)
    stress = field_of(frame, scenario, "stress")
    low, high = limits_of(stress.values, 1.0)
    assert low < 0.0
    bar = field_map(stress, frame, scenario).axes[1]
    assert bar.get_ylim() == (0.0, pytest.approx(high))
    colours = bar.collections[-1].get_cmap()
    whole = field_map(stress, frame, scenario, limits=(low, high)).axes[1].collections[-1].get_cmap()
    assert colours((1.0 - 0.0) / high) == pytest.approx(whole(0.5), abs=0.03)


def test_a_field_of_yes_and_no_has_two_colours(painted):
    sand = np.full((ROWS, COLUMNS), 1)
    sand[:, 4:6] = 12
    frame, scenario = painted(sand)
    bar = field_map(field_of(frame, scenario, "shadow"), frame, scenario).axes[1]
    assert [label.get_text() for label in bar.get_yticklabels()] == ["no", "yes"]
    (blocks,) = (c for c in bar.collections if c.get_array() is not None)
    assert blocks.get_array().size == 2


@pytest.mark.parametrize("name", ["slope", "depth", "sand"])
def test_the_scale_of_a_bare_field_begins_at_nothing(painted, name):
    frame, scenario = painted(0)
    low, high = field_map(field_of(frame, scenario, name), frame, scenario).axes[1].get_ylim()
    assert low == 0.0 < high
