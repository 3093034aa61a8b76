"""Single grains followed for pictures."""

import pytest

import barchan
from barchan.analysis.grain_paths import hops_of
from barchan.grains.trajectories import follow
from barchan.simulation import Simulation
from barchan.streams import Stream
from barchan.wind.segment import Segment

SMALL = {
    "barchan": 5,
    "lattice": {"rows": 16, "columns": 32, "cell_size": 0.01, "slab_height": 0.15e-3},
    "sand": {"kind": "flat", "mean": 20},
    "model": {"name": "wang_hu"},
    "run": {"steps": 20, "seed": 3},
}


def test_paths_start_on_the_bed_and_go_downwind():
    simulation = Simulation(barchan.load(SMALL))
    wind = Segment(0, 1, 0, simulation.lattice.cells, 180.0)
    for path in follow(simulation.model, simulation.bed, wind, Stream(1, "paths"), 5):
        assert path[0, 2] == pytest.approx(20 * 0.15e-3)
        assert path[-1, 1] > path[0, 1]
        assert path[-1, 0] == pytest.approx(path[0, 0], abs=1e-6)
        lengths, heights, angles = hops_of(path).T
        assert (lengths > 0).all()
        assert (heights > 0).all()
        assert (angles < 90).all()


def test_below_the_threshold_no_path_starts():
    simulation = Simulation(barchan.load(SMALL, model__wind_speed=5.0))
    wind = Segment(0, 1, 0, simulation.lattice.cells, 270.0)
    assert follow(simulation.model, simulation.bed, wind, Stream(1, "paths"), 1) == []
