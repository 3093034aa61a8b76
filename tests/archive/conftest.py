"""Runs on disk that tests of the archive share."""

import shutil

import pytest
import xarray as xr

from barchan.archive import open_run, run
from barchan.simulation import Simulation
from tests.tiny import tiny


@pytest.fixture(scope="session")
def whole(tmp_path_factory):
    """The folder of a tiny run that nothing interrupted; not to be changed."""
    return run(Simulation(tiny()), tmp_path_factory.mktemp("whole") / "run").path


@pytest.fixture
def fresh(whole, tmp_path):
    """The folder of a tiny run of the test's own."""
    return shutil.copytree(whole, tmp_path / "run")


@pytest.fixture(scope="session")
def same_frames():
    """Assert that two folders hold the same frames, to the bit and to the attribute."""

    def compare(one, other):
        with open_run(one) as first, open_run(other) as second:
            xr.testing.assert_identical(first.load(), second.load())

    return compare


@pytest.fixture(scope="session")
def begins_like():
    """Assert that the frames of one folder are the first ones of another's."""

    def compare(part, all_):
        with open_run(part) as first, open_run(all_) as second:
            part_of_all = second.isel(step=slice(first.sizes["step"])).load()
            part_of_all.attrs["stopped"] = first.attrs["stopped"]
            xr.testing.assert_identical(first.load(), part_of_all)

    return compare
