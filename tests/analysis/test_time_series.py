"""The measures of a run, frame by frame."""

import math

import numpy as np
import pytest

from barchan.analysis import time_series
from barchan.analysis.declared_measures import MEASURES, PER_YEAR
from barchan.analysis.time_series import last_measures, measure_series, measured_frames
from barchan.entry import simulate
from barchan.measures import crest_orientation, dominant_spacing, migration, streamwise_slopes
from barchan.models import models
from tests.tiny import RIDGES, tiny

SCENARIO = tiny(lattice__cell_size=3.0, lattice__boundary_y="open", **RIDGES)


@pytest.fixture(scope="module")
def dataset():
    """The frames of a run with ridges across the wind."""
    return simulate(SCENARIO)


@pytest.fixture(scope="module")
def measured(dataset):
    """Their measures."""
    return measure_series(dataset, SCENARIO)


def test_every_measure_is_declared_with_a_title_and_a_unit(measured):
    assert list(measured.data_vars) == [measure.name for measure in MEASURES]
    for measure in MEASURES:
        attributes = measured[measure.name].attrs
        assert (attributes["long_name"], attributes["unit"]) == (measure.title, measure.unit)
        assert set(attributes["doubtful"]) <= {0, 5, 10, 15, 20}


def test_measures_stand_at_the_steps_of_the_frames(measured):
    assert measured["step"].values.tolist() == [0, 5, 10, 15, 20]


def test_heights_and_volume_are_those_of_the_sand(dataset, measured):
    sand = dataset["sand"].values
    np.testing.assert_array_equal(measured["highest_stack"], sand.max(axis=(1, 2)))
    np.testing.assert_allclose(measured["highest"], sand.max(axis=(1, 2)) * 1.0)
    np.testing.assert_allclose(measured["bare_fraction"], (sand == 0).mean(axis=(1, 2)))
    np.testing.assert_allclose(measured["volume"], sand.sum(axis=(1, 2)) * 1.0 * 9.0)


def test_volume_and_what_left_are_constant_together(dataset, measured):
    slabs = (measured["volume"] / 9.0 + dataset["left"]).values
    np.testing.assert_allclose(slabs, slabs[0], rtol=1e-12)


def test_shape_measures_are_those_of_each_surface(dataset, measured):
    for number, surface in enumerate(dataset["elevation"].values):
        joined = (False, True)
        orientation = crest_orientation(surface, 3.0, joined)
        normal = orientation.azimuth + 90.0
        across = normal if normal % 360.0 >= 180.0 else normal + 180.0
        if not orientation.coherence >= 0.2:
            across = 270.0
        slopes = streamwise_slopes(surface, 3.0, across, joined)
        expected = {
            "spacing": dominant_spacing(surface, 3.0, across, joined),
            "crest_azimuth": orientation.azimuth,
            "straightness": orientation.coherence,
            "windward_slope": slopes.windward,
            "lee_slope": slopes.lee,
        }
        for name, value in expected.items():
            assert float(measured[name][number]) == pytest.approx(value, nan_ok=True)


def test_speed_is_from_up_to_three_frames_before_and_in_metres_too(dataset, measured):
    assert math.isnan(measured["speed"][0])
    for number in range(1, 5):
        used = slice(max(0, number - 3), number + 1)
        surfaces = list(dataset["elevation"].values[used])
        moved = migration(dataset["step"].values[used], surfaces, (False, True))
        assert float(measured["speed_cells"][number]) == pytest.approx(moved.x)
        assert float(measured["speed"][number]) == pytest.approx(3.0 * moved.x)


def test_flux_is_of_the_travel_between_frames(dataset, measured):
    assert math.isnan(measured["flux"][0])
    travel = np.hypot(np.diff(dataset["travel_x"].values), np.diff(dataset["travel_y"].values))
    np.testing.assert_allclose(measured["flux"][1:], travel / (16 * 96) * 1.0 * 3.0 / 5)
    assert (measured["flux"][1:] > 0).all()


def test_the_last_measures_are_the_end_of_the_series(dataset, measured):
    last = last_measures(dataset, SCENARIO)
    for name, value in last.items():
        assert value == pytest.approx(float(measured[name][-1]), nan_ok=True)


def test_the_measures_of_a_single_frame_have_no_speed_and_no_flux():
    scenario = tiny(run__steps=0)
    last = last_measures(simulate(scenario), scenario)
    assert last["highest_stack"] > 0
    assert math.isnan(last["speed"])
    assert math.isnan(last["flux"])


@pytest.mark.parametrize("first", range(5))
def test_measuring_may_begin_at_any_frame(dataset, measured, first):
    found = [frame.speed for frame in measured_frames(dataset, SCENARIO, first)]
    np.testing.assert_allclose(found, measured["speed_cells"][first:])


@pytest.mark.parametrize(("boundary_x", "boundary_y"), [("open", "periodic"), ("periodic", "open")])
def test_rows_are_joined_south_to_north_and_columns_west_to_east(boundary_x, boundary_y):
    scenario = tiny(lattice__boundary_x=boundary_x, lattice__boundary_y=boundary_y)
    assert scenario.lattice.periodic == (boundary_y == "periodic", boundary_x == "periodic")


@pytest.mark.parametrize("direction", [0.0, 90.0, 180.0, 225.0])
def test_flux_is_positive_downwind_whatever_the_wind(direction):
    scenario = tiny(wind__direction=direction)
    assert last_measures(simulate(scenario), scenario)["flux"] > 0


@pytest.mark.parametrize(
    "changes",
    [
        {"sand": {"kind": "flat", "mean": 4}, "run__steps": 0},
        {"sand": {"kind": "flat", "mean": 0}},
        {"lattice__rows": 1},
        {"lattice__rows": 2, "lattice__boundary_y": "open"},
        {"lattice__columns": 8, "wind__direction": 33.0},
    ],
    ids=["flat", "bare", "one row", "two open rows", "oblique"],
)
def test_small_and_featureless_fields_can_be_measured(changes):
    scenario = tiny(**changes)
    measured = measure_series(simulate(scenario), scenario)
    assert np.isfinite(measured["volume"]).all()


@pytest.mark.parametrize("name", list(models()))
def test_measures_of_the_model_stand_beside_those_of_every_run(name):
    scenario = tiny(model={"name": name})
    run = simulate(scenario)
    own = [measure.name for measure in models()[name].measures]
    measured = measure_series(run, scenario)
    timed = PER_YEAR if scenario.step_seconds else ()
    assert list(measured.data_vars) == [*(measure.name for measure in (*MEASURES, *timed)), *own]
    assert len(set(measured.data_vars)) == len(measured.data_vars)
    last = last_measures(run, scenario)
    for measure in own:
        assert np.isfinite(measured[measure]).all()
        assert last[measure] == float(measured[measure][-1])


def test_plants_are_measured_by_their_mean_and_a_reference_by_its_height():
    plants = {"kind": "islands", "grass": 0.5, "mesquite": -0.25}
    scenario = tiny(model={"name": "nield_baas", "vegetation": plants})
    run = simulate(scenario)
    measured = measure_series(run, scenario)
    for name in ("grass", "mesquite", "shrub"):
        np.testing.assert_allclose(measured[f"mean_{name}"], run[name].mean(("y", "x")))
    scenario = tiny(model={"name": "momiji"})
    run = simulate(scenario)
    reference = measure_series(run, scenario)["reference_height"]
    assert reference.attrs["unit"] == "m"
    np.testing.assert_allclose(reference, run["elevation"].mean(("y", "x")))


def test_the_stress_is_highest_on_relief():
    scenario = tiny(model={"name": "pelletier"}, sand={"kind": "flat", "mean": 9})
    stress = measure_series(simulate(scenario), scenario)["highest_stress"].values
    assert stress[0] == pytest.approx(1.0)
    assert (stress[1:] > 1.0).all()


def test_a_frame_is_modelled_once_for_all_measures_of_its_model(monkeypatch):
    """Seven measures of plants, each of which needs the model: each frame is modelled once."""
    asked = []
    found = time_series.as_modelled
    monkeypatch.setattr(time_series, "as_modelled", lambda *given: asked.append(1) or found(*given))
    scenario = tiny(model={"name": "nield_baas"})
    run = simulate(scenario)
    measure_series(run, scenario)
    assert len(asked) == run.sizes["step"]
