"""The bed as a run finds it."""

import numpy as np
import pytest

from barchan.errors import ScenarioError
from barchan.ground.sand import FileSand
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


def test_sand_and_ground_from_files_must_begin_at_the_same_corner(tmp_path):
    def grid(name, west, south):
        head = f"ncols 24\nnrows 16\nxllcorner {west}\nyllcorner {south}\ncellsize 1\n"
        rows = "\n".join(" ".join(str(2 + (r + c) % 3) for c in range(24)) for r in range(16))
        (tmp_path / name).write_text(head + rows)
        return str(tmp_path / name)

    ground = FileGround(path=grid("ground.asc", 500_000, 4_000_000))
    lattice = tiny().lattice
    here = FileSand(path=grid("here.asc", 500_000.2, 4_000_000))
    assert first_bed(lattice, ground, here, 1).sand.max() == 4
    there = FileSand(path=grid("there.asc", 500_350, 3_999_990))
    with pytest.raises(
        ScenarioError, match=r"sand\.path: .* begins 350 m east and -10 m north of the ground"
    ):
        first_bed(lattice, ground, there, 1)
    np.save(tmp_path / "plain.npy", np.ones(lattice.shape))
    assert first_bed(lattice, ground, FileSand(path=str(tmp_path / "plain.npy")), 1).sand.max() == 1
