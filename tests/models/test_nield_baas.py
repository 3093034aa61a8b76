"""Plants that hold sand and grow with the year's balance."""

import numpy as np
import pytest

import barchan
from barchan.models.nield_baas import NieldBaas
from barchan.plants.layouts import SPECIES
from barchan.scenario import validate
from barchan.simulation import SetParameter, Simulation
from barchan.wind.clock import YEAR
from tests.tiny import COLUMNS, ROWS, tiny

STILL = {"curve": [{"balance": -1.0, "change": 0.0}, {"balance": 1.0, "change": 0.0}]}
FIXED = {"lowest": -9.0, "highest": 9.0, **STILL}


def planted(plants=None, **changes):
    model = {"name": "nield_baas", "vegetation": plants or {"kind": "uniform"}, **changes}
    return tiny(model=model, sand={"kind": "flat", "mean": 10}, run__steps=400)


def test_without_plants_slabs_move_as_without_a_species():
    bare = Simulation(planted(steps_per_year=1000))
    bare.advance(20)
    same = {"hop_length": 1.0, "polling": "non_repeated", "repose_angle": 30.0, "lee_erosion": False}
    werner = Simulation(
        tiny(model={"name": "werner", "repose_test": "after", **same}, sand={"kind": "flat", "mean": 10})
    )
    werner.advance(20)
    assert bare.tally.moved == pytest.approx(werner.tally.moved, rel=0.05)


def test_full_cover_stops_all_transport():
    simulation = Simulation(planted({"kind": "uniform", "grass": 1.0, "shrub": 0.5}))
    simulation.advance(79)
    assert simulation.tally.moved == 0


@pytest.mark.parametrize("cover", [0.25, 0.5, 0.8])
def test_plants_lower_the_chance_to_erode_by_their_effectiveness(cover):
    simulation = Simulation(
        planted(
            {"kind": "uniform", "grass": cover}, steps_per_year=1000, shadow_angle=89.0, p_s=1.0, p_ns=1.0
        )
    )
    simulation.advance(20)
    polls = simulation.tally.polls
    assert simulation.tally.moved / polls == pytest.approx(1 - cover, abs=4 * 0.5 / polls**0.5)


def test_plants_raise_the_chance_to_settle():
    """p_d = p + rho (1 - p): the mean number of hops is one over it."""
    simulation = Simulation(
        planted(
            {"kind": "uniform", "grass": 0.5},
            steps_per_year=1000,
            shadow_angle=89.0,
            p_s=0.6,
            repose_angle=80.0,
        )
    )
    simulation.advance(20)
    hops = simulation.tally.travel_x / simulation.tally.moved
    assert hops == pytest.approx(1 / (0.6 + 0.5 * 0.4), rel=0.05)


def test_plants_grow_once_a_year_by_the_years_balance():
    simulation = Simulation(planted(steps_per_year=10))
    simulation.advance(9)
    assert not any(simulation.bed.arrays[name].any() for name in SPECIES)
    before = np.full(simulation.bed.sand.shape, 10)
    simulation.advance(1)
    balance = (simulation.bed.sand - before) * simulation.lattice.thickness
    np.testing.assert_array_equal(simulation.bed.arrays["balance"], balance)
    for name in SPECIES:
        kind = getattr(simulation.model.parameters, name)
        expected = np.clip(kind.growth(balance), kind.lowest, kind.highest)
        np.testing.assert_array_equal(simulation.bed.arrays[name], expected)


def test_sand_that_dying_plants_held_slides():
    steep = {"kind": "islands", "islands": [{"west": 0.0, "east": 0.5}], "grass": 0.5}
    deadly = {
        "lowest": 0.0,
        "highest": 1.0,
        "curve": [{"balance": -9.0, "change": -1.0}, {"balance": 9.0, "change": -1.0}],
    }
    simulation = Simulation(
        planted(
            steep, steps_per_year=5, grass=deadly, mesquite=FIXED, shrub=FIXED, stabilised_repose_angle=60.0
        )
    )
    simulation.bed.sand[:, 3] += 3
    simulation.bed.arrays["year_start"][...] = simulation.bed.sand
    simulation.ledger.initial = simulation.bed.units
    simulation.advance(5)
    limit = simulation.model.slope_limits()["bare"][0]
    assert np.abs(np.diff(simulation.bed.sand, axis=1)).max() <= limit


def test_firm_cells_stand_steeper():
    limits = Simulation(planted()).model.slope_limits()
    assert limits["stabilised"][0] > limits["bare"][0]


def test_the_year_survives_an_interruption():
    whole = Simulation(planted(steps_per_year=7))
    whole.advance(20)
    parts = Simulation(planted(steps_per_year=7))
    for steps in (3, 5, 6, 6):
        parts.advance(steps)
        parts = Simulation.from_state(parts.state())
    for name in ("sand", *SPECIES, "balance"):
        np.testing.assert_array_equal(whole.bed.arrays[name], parts.bed.arrays[name])


def test_plants_can_be_set_to_hold_less_during_a_run():
    simulation = Simulation(planted({"kind": "uniform", "grass": 0.5}))
    simulation.apply(SetParameter(key="model.stabilised_repose_angle", value=30.0))
    assert simulation.model.slope_limits()["stabilised"] == simulation.model.slope_limits()["bare"]


def test_curves_are_those_of_the_parameters_and_say_what_is_assumed():
    curves = NieldBaas.curves(NieldBaas.Parameters())
    assert [curve.title for curve in curves] == list(SPECIES)
    assert [curve.remark for curve in curves] == ["", "assumed", ""]
    assert curves[0].x == (-1.4, 0.1, 0.45, 0.85, 1.4)


def test_frames_carry_the_plants():
    dataset = barchan.simulate(planted(steps_per_year=5).model_copy(update={"run": tiny().run}))
    assert {"grass", "mesquite", "shrub", "balance"} <= set(dataset.variables)
    assert "year_start" not in dataset


def heaped(**changes):
    """Plants on a bed that first has to come to rest."""
    model = {"name": "nield_baas", "vegetation": {"kind": "uniform", "grass": 0.5}, **changes}
    sand = {"kind": "cone", "height": 6.0, "radius": 5.0, "mean": 3}
    return Simulation(tiny(model=model, sand=sand, lattice__slab_aspect=0.1))


def test_sand_slides_where_plants_are_set_to_hold_it_no_more():
    simulation = heaped()
    before = simulation.bed.sand.copy()
    simulation.apply(SetParameter(key="model.stabilised_cover", value=0.9))
    assert (simulation.bed.sand != before).any()
    assert simulation.model.relax(simulation.bed) == 0


def test_the_slide_before_the_first_step_is_no_part_of_the_first_year():
    simulation = heaped(erosion_chance=0.0, steps_per_year=3)
    simulation.advance(3)
    assert simulation.tally.moved == 0
    assert not simulation.bed.arrays["balance"].any()


def test_a_run_goes_on_without_the_file_that_its_plants_came_from(tmp_path):
    path = tmp_path / "plants.npy"
    np.save(path, np.full((ROWS, COLUMNS), 0.5))
    simulation = Simulation(planted({"kind": "file", "path": str(path), "grass": 0.4}))
    state = simulation.state()
    path.unlink()
    assert (Simulation.from_state(state).bed.arrays["grass"] == 0.2).all()


def test_by_the_clock_plants_grow_at_the_end_of_each_calendar_year():
    """Years of 7.3 steps end within the steps 8, 15, 22, 30, 37."""
    scenario = planted(hop_length=3.0).data()
    timed = validate({**scenario, "clock": {"step_seconds": YEAR / 7.3}}, "test")
    simulation = Simulation(timed)
    grown, before = [], simulation.bed.arrays["year_start"].copy()
    for step in range(1, 38):
        simulation.advance(1)
        now = simulation.bed.arrays["year_start"]
        if (now != before).any():
            grown.append(step)
        before = now.copy()
    assert grown == [8, 15, 22, 30, 37]


def test_years_go_on_in_a_calm():
    scenario = planted(steps_per_year=4).data()
    wind = {
        "kind": "regimes",
        "regimes": [
            {"direction": 270.0, "steps": 2},
            {"direction": 270.0, "steps": 6, "speed": 0.0},
        ],
    }
    simulation = Simulation(validate({**scenario, "wind": wind}, "test"))
    simulation.advance(4)
    assert (simulation.bed.arrays["balance"] != 0.0).any()
    simulation.advance(4)
    assert (simulation.bed.arrays["balance"] == 0.0).all()
