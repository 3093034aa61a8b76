"""Runs and frames that tests of pictures share."""

import pytest
import xarray as xr

from barchan.entry import simulate
from tests.tiny import tiny

FIELDS = {
    "not square": {},
    "flat": {"sand": {"kind": "flat", "mean": 4}, "run__steps": 0},
    "bare": {"sand": {"kind": "flat", "mean": 0}},
    "one row": {"lattice__rows": 1},
    "oblique wind": {"wind__direction": 217.0},
    "over a hill": {"ground": {"kind": "bump", "height": 3.0, "radius": 6.0}},
    "large cells": {"lattice__cell_size": 25.0, "lattice__boundary_x": "open"},
}
"""Changes to the tiny scenario that make fields which are drawn differently."""


@pytest.fixture(scope="session", params=FIELDS.values(), ids=list(FIELDS))
def field(request):
    """A scenario and its frames."""
    scenario = tiny(**request.param)
    return scenario, simulate(scenario)


@pytest.fixture
def painted():
    """Make a frame of given sand on level ground, and its scenario."""

    def paint(sand, direction=270.0, **changes):
        scenario = tiny(wind__direction=direction, **changes)
        frame = simulate(tiny(wind__direction=direction, run__steps=0, **changes)).isel(step=-1)
        frame["sand"][...] = sand
        frame["elevation"][...] = frame["ground"] + frame["sand"] * scenario.lattice.thickness
        assert isinstance(frame, xr.Dataset)
        return frame, scenario

    return paint
