"""Settings of all tests."""

import os

import pytest
from hypothesis import settings

import barchan.kernels  # noqa: F401  # states where compiled kernels are kept, before a test imports numba
from barchan.kernels.core.compile_notice import collection_rests

os.environ.setdefault("NUMBA_NUM_THREADS", "2")
settings.register_profile("default", deadline=None, derandomize=True)
settings.load_profile("default")


def pytest_collection_modifyitems(items):
    """Random scenarios come first: at the end all processors but one would wait for them."""
    items.sort(key=lambda item: "random_runs" not in item.nodeid)


@pytest.fixture(scope="session", autouse=True)
def quick_compilation():
    """Most of the time of all tests goes into compiling."""
    with collection_rests():
        yield
