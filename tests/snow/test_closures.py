"""Each closure of snow by itself: abrasion, creep, wet snow, corners, thresholds, gusts, depths in metres."""

import numpy as np
import pytest

import barchan
from barchan.errors import ScenarioError
from barchan.simulation import Simulation
from barchan.snow.conditions import Conditions, layer_tables
from tests.snow.scenes import SWITCHED_OFF, snow

STILL = {"grows": False}
"""Bonding that does not grow."""


def mounded(amount=40, at=(10, 18, 16, 30), **model):
    """A plateau of snow, ``amount`` quanta high, on 10 quanta."""
    simulation = snow(10, **model)
    change = np.zeros(simulation.lattice.shape, np.int64)
    south, north, west, east = at
    change[south:north, west:east] = amount
    simulation.bed.lay(change)
    simulation.model.relax(simulation.bed, change != 0)
    return simulation


def conditions(wind=10.0, temperature=-10.0, **model):
    return Conditions(snow(**model).model.parameters, wind, temperature)


def test_creep_follows_impacts_and_slope():
    """s p_s cell / (2 L) Q creeps down a slope of one where s pushes go with a slope of one along an axis."""
    creep = conditions(creep={"gain": 0.7}).creep(0.1)
    pushes_per_slope = creep.per_height * 0.1 / 1e-6
    assert pushes_per_slope * 0.6 * 0.1 / (2 * 0.1) == pytest.approx(0.7)
    weaker, stronger = (conditions(wind=wind).creep(0.1) for wind in (8.0, 15.0))
    assert weaker == stronger
    assert conditions(creep={"gain": 0.0}).creep(0.1) is None


def test_creep_by_the_threshold_grows_towards_it():
    def chance(wind):
        return conditions(wind=wind, creep={"law": "threshold"}).creep(0.1).chance / 2**32

    assert chance(8.0) == pytest.approx(0.8)
    assert 0.1 < chance(15.0) < chance(12.0) < 0.5


def test_more_creep_leaves_a_smoother_bed():
    def roughness(gain):
        simulation = snow(60, bonding=STILL, creep={"gain": gain})
        simulation.advance(60)
        return simulation.elevation.std()

    assert roughness(4.0) < 0.6 * roughness(0.2)


def test_wet_snow_stands_less_steep_than_dry_drift():
    """A plateau of loose snow slides to 25 degrees above 0 °C and to 38 below: steps of cell tan(angle)."""

    def steepest(temperature):
        simulation = mounded(temperature=temperature, wind={"speed": 10.0, "temperature": temperature})
        return np.abs(np.diff(simulation.elevation, axis=1)).max()

    dry, wet = steepest(-10.0), steepest(2.0)
    assert wet <= 0.1 * np.tan(np.radians(25.0)) + 1e-6 < dry <= 0.1 * np.tan(np.radians(38.0)) + 1e-6


def test_snow_slides_to_corners_only_where_they_count_as_neighbours():
    """With corners no diagonal is steeper than the angle of repose over its length, cell √2."""

    def steepest_diagonal(neighbourhood):
        surface = mounded(80, neighbourhood=neighbourhood).elevation
        return max(
            np.abs(surface[1:, 1:] - surface[:-1, :-1]).max(),
            np.abs(surface[1:, :-1] - surface[:-1, 1:]).max(),
        )

    limit = 0.1 * np.sqrt(2.0) * np.tan(np.radians(38.0)) + 1e-6
    assert steepest_diagonal("moore") <= limit < steepest_diagonal("von_neumann")


def test_more_quanta_on_a_cell_than_a_layer_counts_are_refused():
    beneath = [{"mass": 1e5, "density": 900.0}] * 3
    with pytest.raises(ScenarioError, match="stacks of up to 1500010 quanta with older layers"):
        snow(10, quantum=0.2, beneath=beneath)


@pytest.mark.parametrize("law", ["li_pomeroy", "snowtran", "mar"])
def test_every_threshold_carries_the_saturated_flux_over_fresh_drift(law):
    """A chance to give that is p0 on flat, fresh drift while drift is in the air, whatever the threshold."""
    closures = {**SWITCHED_OFF, "threshold": {"law": law}, "drift": {"density": 350.0}}
    simulation = snow(400, {"speed": 16.0}, **closures, reference_wind=16.0, quantum=0.1, hop=0.3)
    simulation.advance(20)
    before = simulation.tally.travel_x
    simulation.advance(100)
    travelled = (simulation.tally.travel_x - before) * 0.1
    flux = travelled * 0.1 / (simulation.lattice.cells * 100 * simulation.scenario.step_seconds)
    saturated = Conditions(simulation.model.parameters, 16.0, -10.0).flux
    assert flux == pytest.approx(saturated, rel=0.02)


def test_old_snow_gives_by_chance_under_li_and_pomeroy():
    """A day at -10 °C has the median 10.95 m/s and the spread 2.98 m/s; by bonds it withstands 13 m/s."""
    aged = {"start_age": 24.0, "start_density": 350.0, "abrasion": {"rate": 0.0}}
    assert snow(**aged, threshold={"law": "li_pomeroy"}).advance(30).moved > 0
    assert snow(**aged).advance(30).moved == 0


def test_gusts_about_a_mean_below_the_threshold_move_snow():
    """6 m/s with gusts of 40 %: a quarter of moments exceed 7.6 m/s."""
    gusty = {"speed": 6.0, "gusts": {"intensity": 0.4, "correlation_time": 1.0}}
    assert snow(wind={"speed": 6.0}).advance(100).moved == 0
    assert snow(wind=gusty).advance(100).moved > 0


def test_depths_in_metres_are_counted_in_quanta_of_the_starts_density(tmp_path):
    """0.4 m of 250 kg/m³ are 100 kg/m²: 50 quanta of 2 kg/m²; so is a level 0.4 m above old snow."""
    depths = np.full((32, 48), 0.4)
    np.save(tmp_path / "depths.npy", depths)
    data = {
        "barchan": 5,
        "lattice": {"rows": 32, "columns": 48, "cell_size": 0.1},
        "model": {"name": "snow", "quantum": 2.0, "start_density": 250.0},
        "wind": {"kind": "steady", "speed": 10.0, "unit": "m/s"},
        "run": {"steps": 3, "seed": 1},
    }
    from_file = {"kind": "file", "path": str(tmp_path / "depths.npy"), "unit": "m"}
    bed = barchan.load({**data, "sand": from_file}).first_bed()
    np.testing.assert_array_equal(bed.arrays["snow"], 50)
    beneath = [{"mass": 40.0, "density": 400.0}]
    level = {**data, "sand": {"kind": "level", "level": 0.5}}
    level["model"] = {**data["model"], "beneath": beneath}
    simulation = Simulation(barchan.load(level))
    np.testing.assert_allclose(simulation.elevation, 0.5, atol=1e-6)


def test_heights_of_light_quanta_do_not_drift():
    """100 kg/m² of 0.1 kg/m² quanta at 347 kg/m³ stand 288.2 mm high, not 300."""
    simulation = snow(1000, {"speed": 0.0}, quantum=0.1, start_density=347.0)
    np.testing.assert_allclose(simulation.elevation, 100.0 / 347.0, rtol=2e-3)


def test_the_weakest_snow_wears_at_a_rate_that_is_a_number():
    """By density alone the lightest snow withstands 10⁻⁹⁸ Pa, less than a float of 32 bits can divide by."""
    now = conditions(wind=12.0, threshold={"law": "mar"})
    tables = layer_tables(now, True, 1.0, 0.1)
    assert np.isfinite(tables.wears).all()
    assert tables.wears.max() > 1.0
