"""Joined edges over ground that does not go on there."""

import numpy as np
import pytest

from barchan.ground.edges import unmatched_edges
from barchan.lattice import Lattice
from barchan.scenario import load_scenario, preset_names
from tests.tiny import data

SLOPE = np.broadcast_to(0.1 * np.arange(40.0), (20, 40))
WAVE = np.broadcast_to(4 * np.sin(2 * np.pi * np.arange(40) / 20), (20, 40))


def remarks(ground, **edges):
    return unmatched_edges(ground, Lattice(rows=20, columns=40, **edges))


def test_a_slope_between_joined_edges_is_remarked_with_its_drop():
    """39 steps of 0.1 m from west to east."""
    (remark,) = remarks(SLOPE)
    assert remark.startswith("the west and east edges are joined, but the ground does not match there")
    assert "breaks off by up to 3.9 m" in remark
    assert "open boundary_x" in remark


def test_each_pair_of_edges_is_looked_at_by_itself():
    both = SLOPE + 0.1 * np.arange(20.0)[:, None]
    assert len(remarks(both)) == 2
    (remark,) = remarks(both, boundary_x="open")
    assert remark.startswith("the south and north edges")


@pytest.mark.parametrize(
    "ground", [WAVE, np.zeros((20, 40)), np.random.default_rng(1).normal(size=(20, 40)) * 9]
)
def test_ground_that_goes_on_is_not_remarked(ground):
    assert remarks(ground) == []


def test_open_edges_need_no_match():
    assert remarks(SLOPE, boundary_x="open") == []


def test_a_drop_of_less_than_a_slab_is_not_seen_by_sand():
    assert remarks(SLOPE * 0.05) == []


def test_a_scenario_remarks_on_its_ground():
    ramp = {"kind": "ramp", "height": 10.0}
    assert any("breaks off" in r for r in load_scenario({**data(), "ground": ramp}).remarks())
    assert not any("breaks off" in r for r in load_scenario(data()).remarks())


@pytest.mark.parametrize("name", preset_names())
def test_no_preset_breaks_off(name):
    assert not any("breaks off" in remark for remark in load_scenario(name).seeded().remarks())
