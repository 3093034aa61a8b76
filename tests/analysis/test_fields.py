"""Fields of a frame by name: kept, derived by the model, or plain."""

import numpy as np
import pytest

from barchan.analysis.fields import field_names, field_of
from barchan.archive import dataset_of, open_run, run
from barchan.entry import simulate
from barchan.errors import BarchanError
from barchan.models import models
from barchan.simulation import SetParameter, SetWind, Simulation
from tests.tiny import COLUMNS, ROWS, tiny

EVERY_MODEL = pytest.mark.parametrize("name", list(models()))


def last(**changes):
    """The last frame of a tiny run, and its scenario."""
    scenario = tiny(**changes)
    return simulate(scenario).isel(step=-1), scenario


@pytest.mark.parametrize(
    ("name", "direction"),
    [
        *((name, 270.0) for name in models()),
        # what a field is made of is the same under any wind, but each kernel is another one
        *(
            pytest.param(name, 33.0, marks=[pytest.mark.extended] if name != "werner" else [])
            for name in models()
        ),
    ],
)
def test_every_field_has_a_finite_value_a_unit_and_a_meaning_everywhere(name, direction):
    frame, scenario = last(model={"name": name}, wind__direction=direction)
    names = field_names(frame, scenario)
    assert names == sorted(set(names))
    (layer,) = scenario.layers
    assert {"elevation", "ground", layer.name, "slope", "depth"} <= set(names)
    for field in (field_of(frame, scenario, name) for name in names):
        assert field.shape == (ROWS, COLUMNS)
        assert np.isfinite(field.values).all()
        assert field.attrs["unit"]
        assert field.attrs["long_name"]


@EVERY_MODEL
def test_looking_at_a_frame_leaves_it_as_it_is(name):
    frame, scenario = last(model={"name": name})
    before = frame.copy(deep=True)
    for field in field_names(frame, scenario):
        field_of(frame, scenario, field)
    assert frame.identical(before)


@EVERY_MODEL
def test_what_is_derived_from_a_level_bed_is_its_centre(name):
    frame, scenario = last(model={"name": name}, sand={"kind": "flat", "mean": 4}, run__steps=0)
    centred = [
        f for n in field_names(frame, scenario) if "centre" in (f := field_of(frame, scenario, n)).attrs
    ]
    assert len(centred) >= any(field.centred for field in models()[name].derived)
    for field in centred:
        np.testing.assert_allclose(field.values, field.attrs["centre"], atol=1e-12)


def test_the_slope_of_a_straight_flank_is_its_angle():
    frame, scenario = last(lattice__slab_aspect=0.5, run__steps=0)
    frame["sand"][...] = np.minimum(np.arange(COLUMNS), 12)
    slope = field_of(frame, scenario, "slope")
    assert slope.attrs["unit"] == "degrees"
    np.testing.assert_allclose(slope.values[:, 1:12], np.degrees(np.arctan(0.5)))
    np.testing.assert_allclose(slope.values[:, 13:23], 0.0)


def test_sand_is_as_deep_as_its_slabs_are_thick():
    hill = {"kind": "bump", "height": 3.0, "radius": 6.0}
    frame, scenario = last(lattice__cell_size=3.0, ground=hill, run__steps=0)
    frame["sand"][...] = 4
    np.testing.assert_allclose(field_of(frame, scenario, "depth").values, 4.0)


def test_the_shadow_is_the_one_that_the_model_steps_by():
    frame, scenario = last()
    simulation = Simulation(scenario)
    simulation.advance(scenario.run.steps)
    expected = simulation.model.shadow_zone(simulation.bed, 270.0)
    np.testing.assert_array_equal(field_of(frame, scenario, "shadow").values, expected)


def test_effectiveness_is_the_sum_of_all_plants():
    frame, scenario = last(
        model={"name": "nield_baas", "vegetation": {"kind": "blowouts", "grass": 0.5, "shrub": 0.2}}
    )
    total = sum(frame[name].values for name in ("grass", "mesquite", "shrub"))
    np.testing.assert_allclose(field_of(frame, scenario, "effectiveness").values, total)


def test_the_hop_follows_a_speed_that_the_wind_states():
    frame, scenario = last(model={"name": "momiji"}, wind__speed=9.0)
    assert field_of(frame, scenario, "hop").attrs["centre"] == 9.0
    assert field_of(frame, scenario, "speedup").attrs["centre"] == 1.0


def test_a_frame_is_seen_under_its_own_wind():
    scenario = tiny()
    frame = simulate(scenario).isel(step=-1)
    frame["wind_direction"] = frame["wind_direction"] * 0 + 90.0
    turned = simulate(tiny(wind__direction=90.0, run__steps=0)).isel(step=-1)
    for name in ("sand", "elevation"):
        turned[name][...] = frame[name].values
    np.testing.assert_array_equal(
        field_of(frame, scenario, "shadow").values,
        field_of(turned, tiny(wind__direction=90.0), "shadow").values,
    )


def test_an_unknown_field_is_answered_with_those_there_are():
    frame, scenario = last(model={"name": "momiji"})
    with pytest.raises(BarchanError) as error:
        field_of(frame, scenario, "hopp")
    assert str(error.value) == (
        "no field 'hopp'; this run has depth, elevation, flux, ground, hop, sand, shadow, slope, speedup; "
        "did you mean 'hop'?"
    )


@pytest.mark.parametrize("name", ["moved", "year_start", "wind_direction"])
def test_what_is_no_field_of_a_frame_is_no_field(name):
    frame, scenario = last(model={"name": "nield_baas"})
    with pytest.raises(BarchanError, match=f"no field '{name}'"):
        field_of(frame, scenario, name)


def changed_run():
    """A run of ten steps whose hop, shadow angle and wind change after the fifth."""
    simulation = Simulation(tiny(model={"name": "momiji"}, run__steps=10))
    frames = []
    for frame in simulation:
        frames.append(frame)
        if frame.step == 5:
            simulation.apply(SetParameter(key="model.hop_length", value=2.0))
            simulation.apply(SetParameter(key="model.shadow_angle", value=5.0))
    return dataset_of(simulation, frames), simulation.scenario


def test_what_is_derived_follows_the_parameters_in_force_at_the_frame():
    dataset, scenario = changed_run()
    assert dataset["step"].values.tolist() == [0, 5, 10]
    hops = [field_of(dataset.isel(step=at), scenario, "hop").attrs["centre"] for at in range(3)]
    assert hops == [5.0, 5.0, 2.0]
    now = tiny(model={"name": "momiji", "hop_length": 2.0, "shadow_angle": 5.0})
    last = dataset.isel(step=-1)
    plain = last.drop_attrs()
    for name in ("shadow", "hop"):
        np.testing.assert_array_equal(
            field_of(last, scenario, name).values, field_of(plain, now, name).values
        )


def test_what_is_derived_follows_the_speed_of_a_wind_that_was_set(tmp_path):
    simulation = Simulation(tiny(model={"name": "momiji"}, run__steps=10))
    simulation.advance(5)
    simulation.apply(SetWind(wind={"direction": 200.0, "speed": 7.0}))
    run(simulation, tmp_path / "windy")
    with open_run(tmp_path / "windy") as dataset:
        first, last = (dataset.isel(step=at).load() for at in (0, -1))
        assert field_of(first, simulation.scenario, "hop").attrs["centre"] == 5.0
        assert field_of(last, simulation.scenario, "hop").attrs["centre"] == 7.0
