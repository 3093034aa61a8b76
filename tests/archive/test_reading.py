"""Reading runs: with plain xarray or with ours, also while they are being written."""

import numpy as np
import pytest
import xarray as xr
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from barchan.archive import Archive, open_run, run, run_info
from barchan.entry import load
from barchan.errors import ArchiveError, ScenarioError
from barchan.simulation import Simulation
from tests.tiny import tiny

SHAPE = (5, 16, 24)

HILL = {"ground": {"kind": "bump", "height": 3.0, "radius": 6.0}, "lattice__cell_size": 2.0}


def forwards_or_not_empty(part, size):
    """Whether xarray can take a slice from a disk: it fails on empty ones that run backwards."""
    return (part.step or 1) > 0 or len(range(*part.indices(size))) > 0


places = [st.integers(-n, n - 1) for n in SHAPE]
slices = [
    st.builds(
        slice, *([st.none() | st.integers(-n - 2, n + 2)] * 2), st.sampled_from([None, 1, 2, 3, -1, -2])
    ).filter(lambda part, n=n: forwards_or_not_empty(part, n))
    for n in SHAPE
]
lists = [st.lists(place, min_size=1, max_size=4) for place in places]
basic = st.tuples(*(place | part for place, part in zip(places, slices, strict=True)))
orthogonal = st.tuples(
    *(one | part | several for one, part, several in zip(places, slices, lists, strict=True))
)
pointwise = st.integers(1, 5).flatmap(
    lambda n: st.tuples(*(st.lists(place, min_size=n, max_size=n) for place in places))
)


@pytest.fixture(scope="module")
def hilly(tmp_path_factory):
    """The folder of a run over a hill, and all its elevations worked out from its frames."""
    simulation = Simulation(tiny(**HILL))
    frames = list(simulation)
    ground = np.stack([frame.fields["ground"] for frame in frames])
    sand = np.stack([frame.fields["sand"] for frame in frames])
    folder = run(Simulation(tiny(**HILL)), tmp_path_factory.mktemp("hilly") / "run").path
    return folder, ground + sand * (2.0 / 3.0)


@pytest.fixture(scope="module")
def elevation(hilly):
    """The elevation of the run over a hill, as it is read, and what it must be."""
    folder, expected = hilly
    with open_run(folder) as dataset:
        yield dataset["elevation"], expected


def test_plain_xarray_opens_the_frames_in_slabs_and_metres(hilly):
    folder, _ = hilly
    with xr.open_zarr(folder / "frames.zarr") as dataset:
        assert dataset["sand"].dims == dataset["ground"].dims == ("step", "y", "x")
        assert dataset["sand"].shape == SHAPE
        assert np.issubdtype(dataset["sand"].dtype, np.integer)
        assert dataset["ground"].dtype == np.float64
        assert dataset["ground"].attrs["units"] == "m"
        np.testing.assert_array_equal(dataset["ground"][3], Simulation(tiny(**HILL)).bed.ground)
        assert dataset["x"].values.tolist() == [1.0 + 2.0 * k for k in range(24)]
        assert dataset["y"].values.tolist() == [1.0 + 2.0 * k for k in range(16)]
        assert dataset["x"].attrs["units"] == dataset["y"].attrs["units"] == "m"
        assert dataset["step"].values.tolist() == [0, 5, 10, 15, 20]


def test_the_frames_tell_where_they_come_from(whole):
    with xr.open_zarr(whole / "frames.zarr") as dataset:
        assert dataset.attrs["Conventions"].startswith("CF-")
        assert dataset.attrs["source"].startswith("Barchan ")
        assert dataset.attrs["title"] == "Tiny"
        assert dataset.attrs["scenario"] == tiny().text()


def test_frames_on_disk_are_the_frames_of_the_simulation(whole):
    with open_run(whole) as dataset:
        for number, frame in enumerate(Simulation(tiny())):
            read = dataset.isel(step=number)
            np.testing.assert_array_equal(read["sand"], frame.fields["sand"])
            assert int(read["moved"]) == frame.tally.moved
            assert float(read["travel_x"]) == frame.tally.travel_x


def test_elevation_is_ground_and_sand_together(elevation):
    read, expected = elevation
    np.testing.assert_array_equal(read.values, expected)
    assert read.attrs["units"] == "m"


@settings(max_examples=60)
@given(key=basic)
def test_elevation_of_any_block_is_that_part_of_the_whole(elevation, key):
    read, expected = elevation
    np.testing.assert_array_equal(read[key].values, expected[key])


@settings(max_examples=60)
@given(key=orthogonal)
def test_elevation_of_chosen_steps_rows_and_columns_is_that_part_of_the_whole(elevation, key):
    read, expected = elevation
    for axis, chosen in reversed(list(enumerate(key))):
        expected = expected[(slice(None),) * axis + (chosen,)]
    np.testing.assert_array_equal(read[key].values, expected)


@settings(max_examples=30)
@given(key=pointwise)
def test_elevation_at_single_points_is_that_part_of_the_whole(elevation, key):
    read, expected = elevation
    points = tuple(xr.DataArray(list(axis), dims="point") for axis in key)
    np.testing.assert_array_equal(read[points].values, expected[key])


@settings(max_examples=30)
@given(first=basic, then=st.tuples(slices[0], slices[1]))
def test_parts_of_parts_of_elevation_are_parts_of_the_whole(elevation, first, then):
    read, expected = elevation
    part = expected[first]
    key = then[: part.ndim]
    assume(part[key].size)
    np.testing.assert_array_equal(read[first][key].values, part[key])


def test_elevation_is_read_for_the_frames_that_are_asked_for_and_no_others(fresh):
    damaged = fresh / "frames.zarr" / "sand" / "c" / "1" / "0" / "0"
    damaged.write_bytes(b"not a chunk")
    with open_run(fresh) as dataset:
        assert np.isfinite(dataset["elevation"][2].values).all()
        with pytest.raises(Exception, match=r".+"):
            dataset["elevation"][1].load()


def test_a_frame_can_be_found_by_its_step_and_its_place(elevation):
    read, expected = elevation
    assert float(read.sel(step=10, x=7.0, y=5.0)) == expected[2, 2, 3]


def test_a_run_can_be_read_while_it_is_being_written(tmp_path, begins_like):
    whole = run(Simulation(tiny()), tmp_path / "whole").path
    seen = []

    def read(simulation):
        begins_like(tmp_path / "run", whole)
        with xr.open_zarr(tmp_path / "run" / "frames.zarr") as dataset:
            assert dataset["step"].values.tolist() == list(range(0, simulation.steps_done, 5))
            assert (dataset["sand"].sum(("y", "x")) == simulation.ledger.initial).all()
            seen.append(dataset.sizes["step"])

    run(Simulation(tiny()), tmp_path / "run", progress=read)
    assert set(seen) == {1, 2, 3, 4}


def test_a_reader_keeps_its_view_while_frames_are_added(tmp_path):
    datasets = []

    def open_once(simulation):
        if simulation.steps_done == 10:
            datasets.append(open_run(tmp_path / "run"))

    run(Simulation(tiny()), tmp_path / "run", progress=open_once)
    with datasets[0] as dataset:
        assert dataset["step"].values.tolist() == [0, 5]
        assert dataset["elevation"].shape == (2, 16, 24)
        assert (dataset["sand"].sum(("y", "x")) == Simulation(tiny()).bed.units).all()


def test_a_folder_without_a_run_is_a_clear_error(tmp_path):
    for read in (open_run, run_info):
        with pytest.raises(ArchiveError, match=rf"{tmp_path}: not a run \(it has no scenario.json\)"):
            read(tmp_path)


def test_a_run_without_frames_is_a_clear_error(tmp_path):
    Archive.create(tmp_path / "run", Simulation(tiny())).close()
    with pytest.raises(ArchiveError, match=f"{tmp_path / 'run'}: no frames were saved"):
        open_run(tmp_path / "run")
    known = run_info(tmp_path / "run")
    assert (known.frames, known.last_step, known.checkpoint, known.stopped) == (0, 0, 0, None)


def test_what_there_is_to_know_of_a_run(whole):
    known = run_info(whole)
    assert known.path == whole
    assert known.scenario == tiny()
    assert (known.frames, known.last_step, known.checkpoint) == (5, 20, 20)
    assert known.bytes == sum(path.stat().st_size for path in whole.rglob("*") if path.is_file())


def test_the_scenario_of_a_run_is_loaded_from_its_folder(whole):
    assert load(whole) == tiny()
    assert load(str(whole), run__steps=3).run.steps == 3


def test_a_folder_without_a_scenario_is_not_loaded(tmp_path):
    with pytest.raises(ScenarioError):
        load(tmp_path)


def test_a_folder_that_is_no_run_does_not_hide_a_preset(monkeypatch, tmp_path):
    (tmp_path / "barchans").mkdir()
    monkeypatch.chdir(tmp_path)
    assert load("barchans").title == "Barchans"
