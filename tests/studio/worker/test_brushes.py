"""Strengths that brushes begin with."""

import numpy as np
import pytest

from barchan.simulation import Simulation
from barchan.studio.worker.brushes import brushes
from tests.studio.conftest import small


@pytest.mark.parametrize(("relief", "slabs"), [(0.0, 6), (16.0, 24)])
def test_rock_is_high_enough_to_be_seen_among_the_forms(tmp_path, relief, slabs):
    """Cells of 1 m, slabs of a third of it: 2 m of rock on level ground, half of a relief of 16 m."""
    np.save(tmp_path / "ground.npy", np.full((32, 48), relief) * (np.arange(48) > 20))
    ground = {"kind": "file", "path": str(tmp_path / "ground.npy")}
    simulation = Simulation(small(ground=ground, sand={"kind": "flat", "mean": 3}))
    (rock,) = (brush for brush in brushes(simulation) if brush["title"] == "rock")
    assert rock["usual"] == slabs
