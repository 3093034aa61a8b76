"""Refusals and remarks of grain models, collapse and clocks."""

import numpy as np
import pytest

import barchan
from barchan.analysis.grain_paths import broken_at_edges
from barchan.errors import ScenarioError
from barchan.models import model
from barchan.simulation import Simulation
from barchan.wind.segment import Segment

SMALL = {
    "barchan": 5,
    "lattice": {"rows": 16, "columns": 32, "cell_size": 0.01, "slab_height": 0.15e-3},
    "sand": {"kind": "flat", "mean": 20},
    "model": {"name": "wang_hu"},
    "run": {"steps": 20, "seed": 3},
}


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"model__time_step": 0.01}, "pass over a cell"),
        ({"model__time_step": 0.09, "lattice__cell_size": 1.0, "lattice__slab_height": 1e-3}, "drag works"),
        ({"sand__mean": 0}, "no grain can be lifted"),
        ({"model__grain_diameter": 0.0}, "2e-05"),
        ({"model__grain_diameter": 1.0}, "0.005"),
        ({"model__grain_density": 100.0, "model__air_density": 90.0}, "grains that fall"),
        ({"model__bounce__normal_damping": 1.5}, "≤ 1"),
        ({"model__entrainment__min_lift_speed": 3.0}, "below min_lift_speed"),
        ({"model__footprint": "patch", "lattice__rows": 2}, "3 stacks wide, on a field of 2 × 32"),
    ],
)
def test_what_keeps_grains_from_flying_is_named(changes, said):
    with pytest.raises(ScenarioError) as caught:
        Simulation(barchan.load(SMALL, **changes))
    assert said in str(caught.value)


def test_the_published_grain_count_of_a_parcel_follows_from_porosity():
    facts = Simulation(barchan.load(SMALL)).model.facts()
    grains = 0.01**2 * 0.15e-3 * 0.6 / (np.pi / 6 * 0.15e-3**3)
    assert f"{grains:.4g} grains" in facts["a grain in the air"]
    facts = Simulation(barchan.load(SMALL, model__footprint="patch")).model.facts()
    assert f"{16 * grains:.4g} grains" in facts["a grain in the air"]


def test_a_thick_parcel_is_remarked_on():
    remarks = barchan.load(SMALL, lattice__slab_height=1e-3).remarks()
    assert any("6.67 grain diameters" in remark for remark in remarks)


def test_the_filter_keeps_the_sand_and_lowers_peaks():
    simulation = Simulation(barchan.load(SMALL, model__collapse="filter", model__filter_scale=50.0))
    simulation.bed.sand[8, 16] += 200
    simulation.ledger.entered += 200
    simulation.advance(3)
    assert simulation.bed.sand[8, 16] < 150
    assert simulation.bed.units + simulation.ledger.airborne == 16 * 32 * 20 + 200


@pytest.mark.parametrize("along", [(1, 0), (0, 1), (1, 1)])
def test_the_filter_smooths_a_sawtooth_away(along):
    simulation = Simulation(barchan.load(SMALL, model__collapse="filter", model__filter_scale=50.0))
    rows, cols = np.indices((16, 32))
    simulation.bed.sand[...] = 2000 + 1000 * (-1) ** (rows * along[0] + cols * along[1])
    before = simulation.bed.units
    ground = simulation.model.ground_of(simulation.bed, 270.0)
    for _ in range(8):
        ground.relax(0)
    assert np.ptp(simulation.bed.sand) < 300
    assert simulation.bed.units == before


def test_a_step_of_trajectories_ends_with_no_grain_in_the_air():
    simulation = Simulation(barchan.load(SMALL, model__clock="step"))
    tally = simulation.advance(2)
    assert 0 < tally.moved <= 2 * 16 * 32
    assert simulation.ledger.airborne == 0
    assert simulation.model.step_seconds is None
    assert Simulation(barchan.load(SMALL, model__iterations_per_step=7)).model.step_seconds == 7e-3


def test_a_path_breaks_where_it_crosses_an_edge():
    path = np.zeros((5, 7))
    path[:, 0] = [0.1, 0.2, 0.35, 0.45, 0.65]
    line = broken_at_edges(path, 0.3, 1.0)
    assert np.isnan(line[:, 0]).sum() == 2
    np.testing.assert_allclose(line[~np.isnan(line[:, 0]), 0], [0.1, 0.2, 0.05, 0.15, 0.05])


def test_a_wind_in_metres_per_second_overrides_the_models_own():
    wang_hu = model("wang_hu")
    flight = wang_hu(wang_hu.Parameters(), barchan.load(SMALL).lattice)
    assert flight.moves()
    assert not flight.moves(Segment(0, 1, 0, 512, 270.0, speed=5.0))
