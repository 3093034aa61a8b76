"""Frames as a dataset are the same from memory as from disk."""

import json

import numpy as np
import pytest
import xarray as xr

from barchan.archive import dataset_of, open_run, run
from barchan.entry import load, simulate
from barchan.simulation import SetWind, Simulation
from barchan.wind import Steady
from tests.tiny import VARIANTS, tiny


@pytest.mark.parametrize("changes", VARIANTS.values(), ids=list(VARIANTS))
def test_a_run_in_memory_equals_the_run_on_disk(tmp_path, changes):
    in_memory = simulate(tiny(**changes))
    run(Simulation(tiny(**changes)), tmp_path / "run")
    with open_run(tmp_path / "run") as on_disk:
        xr.testing.assert_identical(in_memory, on_disk.load())
        for name, variable in in_memory.variables.items():
            assert variable.dtype == on_disk[name].dtype


def test_frames_tell_where_the_wind_came_from_at_their_step():
    simulation = Simulation(tiny())
    frames = [simulation.frame()]
    simulation.advance(5)
    simulation.apply(SetWind(wind=Steady(direction=33.0)))
    frames.append(simulation.frame())
    assert dataset_of(simulation, frames)["wind_direction"].values.tolist() == [270.0, 33.0]


def test_a_dataset_holds_its_scenario_with_the_seed_that_was_drawn():
    dataset = simulate(tiny(run__seed=None))
    scenario = load(json.loads(dataset.attrs["scenario"]))
    assert scenario.run.seed is not None
    xr.testing.assert_identical(simulate(scenario), dataset)


def test_elevation_is_ground_and_slabs_in_metres():
    dataset = simulate(tiny(lattice__cell_size=6.0, ground__level=-5.0))
    np.testing.assert_array_equal(dataset["elevation"], dataset["sand"] * 2.0 - 5.0)
    assert dataset["elevation"].attrs["units"] == "m"


def test_every_variable_says_what_it_is_and_in_which_unit():
    for variable in simulate(tiny()).variables.values():
        assert variable.attrs["long_name"]
        assert variable.attrs["units"]


def test_the_reason_of_an_early_end_is_told():
    dataset = simulate(tiny(sand={"kind": "flat", "mean": 0}, run__until={"idle_steps": 3}))
    assert dataset.attrs["stopped"] == "nothing moved for 3 steps"
    assert dataset["step"].values.tolist() == [0, 3]


def test_counters_close_the_ledger_in_every_frame():
    dataset = simulate(tiny(lattice__boundary_x="open", run__steps=60))
    total = dataset["sand"].sum(("y", "x")) + dataset["left"] - dataset["entered"] + dataset["airborne"]
    assert set(total.values.tolist()) == {int(dataset["sand"][0].sum())}
    assert int(dataset["left"][-1]) > 0


def test_a_dataset_can_be_written_and_read_by_others(tmp_path):
    dataset = simulate(tiny())
    dataset.to_zarr(tmp_path / "copy.zarr", zarr_format=3, consolidated=False)
    with xr.open_zarr(tmp_path / "copy.zarr", consolidated=False) as copy:
        xr.testing.assert_equal(copy.load(), dataset)


def test_readers_of_netcdf_know_frames_as_moments_of_one_surface(tmp_path):
    """ParaView's reader takes the axis T for time; else frames lie one above the other."""
    run(Simulation(tiny()), tmp_path / "run")
    for dataset in (simulate(tiny()), open_run(tmp_path / "run")):
        assert dataset["step"].attrs["axis"] == "T"
