"""What holds for every kind of ground."""

from typing import get_args

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from barchan.errors import ScenarioError
from barchan.ground.surface import FileGround, Ground
from barchan.ground.terrain import HIGHEST
from barchan.lattice import Lattice
from barchan.scenario import load_scenario
from barchan.streams import Stream
from tests.scenario.strategies import group
from tests.tiny import data

KINDS = [kind for kind in get_args(get_args(Ground)[0]) if kind is not FileGround]
LATTICES = [
    Lattice(rows=12, columns=17, cell_size=3.0),
    Lattice(rows=1, columns=9, boundary_x="open"),
    Lattice(rows=9, columns=8, cell_size=100.0, boundary_y="open"),
]


def stream(seed=4):
    return Stream(seed, "ground")


@settings(suppress_health_check=[HealthCheck.too_slow])
@given(st.sampled_from(KINDS).flatmap(lambda kind: st.tuples(st.just(kind), group(kind))), st.data())
def test_every_ground_covers_the_lattice_within_the_allowed_range(drawn, choose):
    kind, values = drawn
    lattice = choose.draw(st.sampled_from(LATTICES))
    ground = kind.model_validate(values)
    elevation = ground.elevation(lattice, stream())
    assert elevation.shape == lattice.shape
    assert elevation.dtype == np.float64
    assert np.isfinite(elevation).all()
    assert np.abs(elevation).max() <= HIGHEST
    assert ground.bare(lattice).shape == lattice.shape
    assert ground.georeference() is None


@pytest.mark.parametrize("kind", KINDS)
def test_the_same_seed_makes_the_same_ground(kind):
    first = kind().elevation(LATTICES[0], stream())
    np.testing.assert_array_equal(first, kind().elevation(LATTICES[0], stream()))


@pytest.mark.parametrize("kind", [kind for kind in KINDS if "height" in kind.model_fields])
def test_ground_higher_than_allowed_is_one_clear_error(kind):
    tag = kind.model_fields["kind"].default
    with pytest.raises(ScenarioError) as caught:
        load_scenario({**data(), "ground": {"kind": tag, "height": 2e4}})
    (problem,) = caught.value.problems
    assert problem.key == "ground.height"
    assert problem.message.startswith("is 20000.0; allowed: number ≥ ")
    assert problem.message.endswith("≤ 10000.0")
