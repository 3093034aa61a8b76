"""``run.barchan`` gives from a dataset what the functions give from a run."""

import numpy as np
import pytest
import xarray as xr

import barchan
from barchan.errors import BarchanError
from tests.export.scenes import CELL, asymmetric, slabs


@pytest.fixture(scope="module")
def run():
    assert barchan.simulate
    return asymmetric()


def test_the_scenario_comes_back_with_its_seed(run):
    assert run.barchan.scenario.run.seed == 7
    assert run.isel(step=0).barchan.scenario.lattice.cell_size == CELL


def test_derived_fields_are_those_of_the_chosen_frame(run):
    first, last = run.barchan.field("depth", 0), run.barchan.field("depth")
    np.testing.assert_allclose(last - first, 2 * CELL / 3)
    with pytest.raises(BarchanError, match="step 3 was not saved"):
        run.barchan.field("depth", 3)


def test_measures_are_over_all_frames(run):
    assert run.barchan.measures()["highest_stack"].values.tolist() == [slabs(s).max() for s in (0, 5, 10)]


def test_maps_are_drawn_of_surface_and_fields(run):
    assert run.barchan.plot().axes
    assert run.barchan.plot("slope", step=0).axes


def test_an_export_from_the_dataset_is_written(run, tmp_path):
    files = run.barchan.export(tmp_path / "dunes.r32", step=0)
    assert [file.name for file in files] == ["dunes.r32", "dunes.r32.json"]


def test_another_dataset_is_no_run():
    with pytest.raises(BarchanError, match="no run"):
        xr.Dataset().barchan.measures()
