"""The bed as a run finds it."""

import pytest

from barchan.errors import ScenarioError
from barchan.ground.start import first_bed
from barchan.ground.surface import FileGround
from barchan.ground.waves import RippledSand
from barchan.simulation import Simulation
from tests.tiny import tiny


def test_what_is_wrong_with_ground_and_sand_is_told_at_once():
    scenario = tiny()
    with pytest.raises(ScenarioError) as caught:
        first_bed(scenario.lattice, FileGround(path="none.npy"), RippledSand(wavelength=900.0), 1)
    assert [problem.key for problem in caught.value.problems] == ["ground.path", "sand.wavelength"]


def test_the_same_seed_makes_the_same_bed_and_another_seed_another_ground():
    uneven = {"ground": {"kind": "uneven", "size": 2.0}}
    one, same, other = (Simulation(tiny(**uneven, run__seed=seed)).bed for seed in (1, 1, 2))
    assert (one.ground == same.ground).all()
    assert (one.sand == same.sand).all()
    assert (one.ground != other.ground).any()


@pytest.mark.parametrize("kind", ["random", "dropped", "noise"])
def test_uneven_ground_shifts_nothing_of_the_first_sand(kind):
    sand = {"sand": {"kind": kind, "mean": 3}}
    gentle = {"ground": {"kind": "uneven", "height": 0.0}}
    level, uneven = (Simulation(tiny(**sand, **ground)).bed for ground in ({}, gentle))
    assert (level.sand == uneven.sand).all()
