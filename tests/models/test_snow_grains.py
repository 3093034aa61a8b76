"""Snow grains: deposits bond by a timer, and bonded snow is another surface."""

import numpy as np
import pytest

import barchan
from barchan.errors import ScenarioError
from barchan.grains.bonded_snow import BondedSnow, bonded_share, loose_parcels
from barchan.grains.sintering import Sintering
from barchan.kernels.grains.state import Bonds
from barchan.simulation import Simulation

SMALL = {
    "barchan": 5,
    "lattice": {"rows": 16, "columns": 64, "cell_size": 0.005, "slab_height": 0.2e-3 / 16},
    "sand": {"kind": "flat", "mean": 800},
    "model": {
        "name": "snow_grains",
        "wind_speed": 12.0,
        "iterations_per_step": 20,
        "feedback": {"momentum_weight": 0.02},
        "sintering": {"bonding_time": 10.0},
    },
    "run": {"steps": 1000, "seed": 3},
}
"""Steps of half a second: 20 iterations of 0.5 ms of grains that take a 50th of their momentum."""


def run(steps, **changes):
    simulation = Simulation(barchan.load(SMALL, **changes))
    simulation.advance(steps)
    return simulation


def under(name, without, **changes):
    """Twelve steps of another model with the same snow, ``without`` the keys that it does not know."""
    data = barchan.load(SMALL, **changes).model_dump(mode="json")
    model = {k: v for k, v in data["model"].items() if k not in (*without, "sintering", "impacts")}
    simulation = Simulation(barchan.load({**data, "model": {**model, "name": name}}))
    simulation.advance(12)
    return simulation


def assert_same_bits(one, other):
    assert one.ledger.airborne > 100
    assert np.array_equal(one.bed.sand, other.bed.sand)
    assert np.array_equal(one.model.pool.motion, other.model.pool.motion)
    assert one.ledger == other.ledger


@pytest.mark.parametrize("sintering", [{"grows": False}, {"bonding_time": 1e6}])
def test_snow_that_never_bonds_is_the_ripple_models_sand(sintering):
    assert_same_bits(run(12, model__sintering=sintering), under("ripples", ["bounce"]))


def test_snow_that_only_bounces_and_never_bonds_is_the_sand_of_wang_and_hu():
    bouncing = {"model__impacts": "bounce", "model__entrainment__probability": 1.0}
    sand = under("wang_hu", ["splash", "creep", "feedback", "relief_flow"], **bouncing)
    assert_same_bits(run(12, model__sintering={"grows": False}, **bouncing), sand)


def test_loose_snow_has_the_threshold_that_was_measured():
    """0.18 √((917 / 1.3 - 1) · 9.81 m/s² · 0.2 mm) = 0.212 m/s (Bagnold); other sizes as by Shao & Lu."""
    snow = run(0).model.parameters
    assert snow.threshold() == pytest.approx(0.212, abs=0.002)
    by_law = run(0, model__threshold_velocity=None).model.parameters
    assert by_law.threshold() == pytest.approx(0.177, abs=0.001)
    assert snow.threshold(1e-3) / snow.threshold() == pytest.approx(
        by_law.threshold(1e-3) / by_law.threshold()
    )


def test_loose_and_bonded_snow_are_all_snow():
    simulation = run(0, lattice__boundary_x="open")
    stages = 0
    for _ in range(9):
        simulation.advance(5)
        bed = simulation.bed
        loose = sum(bed.arrays[f"loose_{age}"] for age in (1, 2, 3, 4))
        assert np.array_equal(loose + bed.arrays["bonded"], bed.sand)
        assert min(bed.arrays[name].min() for name in ("loose_1", "loose_4", "bonded")) >= 0
        stages += bed.arrays["bonded"].any()
    assert 3 <= stages < 9
    assert simulation.ledger.left > 0
    assert bed.units + simulation.ledger.airborne + simulation.ledger.left == 800 * bed.lattice.cells


def test_every_parcel_bonds_between_three_quarters_of_the_bonding_time_and_all_of_it():
    """Ten seconds in steps of half a second; a parcel comes to rest before each step of a quarter."""
    for first in range(1, 6):
        snow = BondedSnow(Sintering(bonding_time=10.0))
        bonds, steps = Bonds(np.zeros((1, 4), np.int32), False, 0.05, 0.7), 0
        for _ in range(first - 1):
            snow.pass_time(0.5, None, bonds)
        bonds.loose[0, 0] = 1
        while bonds.loose.any():
            snow.pass_time(0.5, None, bonds)
            steps += 1
        assert 7.5 < steps * 0.5 <= 10.0
        assert steps * 0.5 == 10.0 - 0.5 * (first - 1)


def test_cold_snow_bonds_slower():
    """exp[41 000 / 8.314 (1 / 263.15 - 1 / 253.15)] = 0.477, so 24 hours become 50.3 at -20 °C."""
    snow = Sintering()
    assert snow.full_time / snow.rate() == pytest.approx(86_400.0)
    assert snow.full_time / snow.rate(-20.0) / 3600.0 == pytest.approx(50.3, abs=0.1)
    assert Sintering(temperature=-20.0).rate() == snow.rate(-20.0)
    assert Sintering(bonding_time=600.0, temperature=-20.0).rate() == 1.0


def test_the_temperature_of_the_wind_decides_where_it_states_one():
    counts = []
    for temperature in (-10.0, -20.0):
        snow = BondedSnow(Sintering())
        bonds = Bonds(np.array([[7, 0, 0, 0]], np.int32), False, 0.05, 0.7)
        for _ in range(13):
            snow.pass_time(2 * 3600.0, temperature, bonds)
        counts.append(int(bonds.loose.sum()))
    assert counts == [0, 7]


def test_hard_snow_below_its_threshold_stays_as_it_is():
    still = run(8, model__sintering__start_bonded=True, model__sintering__hardness=0.0)
    assert still.ledger.airborne == 0
    assert (still.bed.sand == 800).all()
    assert bonded_share(still.bed).min() == 1.0


def test_impacts_and_strong_winds_take_bonded_snow():
    strong = run(8, model__sintering__start_bonded=True, model__sintering__bonded_threshold=1.0)
    assert strong.ledger.airborne > 0
    assert loose_parcels(strong.bed).sum() > 0


def test_bonded_slopes_stand_and_loose_snow_slides_off_them():
    simulation = run(0, model__sintering__start_bonded=True)
    bed, model = simulation.bed, simulation.model
    bed.sand[:, 30:34] += 2000
    bed.arrays["bonded"][...] = bed.sand
    before = bed.sand.copy()
    assert model.relax(bed) == 0
    assert np.array_equal(bed.sand, before)
    bed.sand[:, 33] += 500
    assert model.relax(bed) > 0
    assert bed.sand.sum() == before.sum() + 500 * 16
    assert (bed.sand >= before).all()
    assert np.array_equal(bed.arrays["bonded"], before)
    assert np.array_equal(loose_parcels(bed), bed.sand - before)


def test_sections_show_what_has_bonded_below_what_has_not():
    simulation = run(24)
    layers = simulation.model.strata[0].compute(simulation.model, simulation.bed)
    assert [float(value.max()) for _, value in layers] == [1.0, 0.875, 0.625, 0.375, 0.125]
    depth = sum(thickness for thickness, _ in layers)
    np.testing.assert_allclose(depth, simulation.bed.depth)


def test_a_run_goes_on_where_it_was_cut():
    whole, first = run(30), run(17)
    second = Simulation.from_state(first.state())
    second.advance(13)
    assert np.array_equal(whole.bed.arrays["loose_2"], second.bed.arrays["loose_2"])
    assert whole.model.bonded_snow.timer == second.model.bonded_snow.timer
    assert np.array_equal(whole.bed.sand, second.bed.sand)


def test_trajectories_without_time_cannot_bond():
    with pytest.raises(ScenarioError, match=r"model.sintering: .*no duration"):
        barchan.load(SMALL, model__clock="step")


def test_a_bonding_time_within_a_step_is_remarked():
    model = run(0, model__sintering__bonding_time=0.4).model
    assert any("locks at once" in text for text in model.remarks(None, 270.0))
    assert run(0).model.remarks(None, 270.0) == []
