"""Sand of several sizes: kept exactly by class, sorted by flight and splash, too heavy ones creep."""

import numpy as np
import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st

import barchan
from barchan.errors import ScenarioError
from barchan.grains.sized_sand import coarse_crests, split, surface_diameter
from barchan.grains.sizes import lognormal
from barchan.kernels.core import threads as thread_pool
from barchan.simulation import SetParameter, Simulation, Stroke
from tests.grains.keys import nested

FINE, COARSE, HEAVY = 0.15e-3, 0.4e-3, 1e-3
TWO = [{"diameter": FINE, "share": 0.7}, {"diameter": COARSE, "share": 0.3}]
CREEPING = [{"diameter": FINE, "share": 0.8}, {"diameter": HEAVY, "share": 0.2}]
THREE = [*TWO[:1], {"diameter": COARSE, "share": 0.2}, {"diameter": HEAVY, "share": 0.1}]

SMALL = {
    "barchan": 5,
    "lattice": {"rows": 12, "columns": 48, "cell_size": 0.005, "slab_height": FINE / 16},
    "sand": {"kind": "flat", "mean": 300},
    "model": {
        "name": "ripples",
        "iterations_per_step": 20,
        "wind_speed": 13.0,
        "feedback": {"momentum_weight": 5e-3},
    },
    "run": {"steps": 1000, "seed": 3},
}


def sorted_sand(sizes=TWO, **changes):
    return Simulation(
        barchan.load({**SMALL, "model": {**SMALL["model"], "sizes": {"classes": sizes}}}, **changes)
    )


def in_the_air(simulation):
    model = simulation.model
    held = np.bincount(
        model.pool.size_class[model.pool.counters[0] > 0], minlength=len(model.sized_sand.classes)
    )
    return held * model.parameters.carried


def all_parcels(simulation):
    """Parcels of each size on the bed, in the air and gone."""
    sizes = simulation.model.sized_sand
    return sizes.on_bed(simulation.bed) + in_the_air(simulation) + sizes.left


def check_bed(simulation):
    sizes, arrays = simulation.model.sized_sand, simulation.bed.arrays
    layer = np.stack([arrays[field.name] for field in sizes.surface])
    below = np.stack([arrays[field.name] for field in sizes.substrate])
    assert min(layer.min(), below.min()) >= 0
    np.testing.assert_array_equal(layer.sum(0) + below.sum(0), simulation.bed.sand)
    np.testing.assert_array_equal(layer.sum(0), np.minimum(simulation.bed.sand, sizes.capacity))


@pytest.mark.extended
@settings(max_examples=12, deadline=None, phases=[Phase.explicit, Phase.generate])
@given(
    st.sampled_from([TWO, CREEPING, THREE]),
    st.sampled_from(["periodic", "open"]),
    st.sampled_from(["stack", "patch"]),
    st.sampled_from(["steepest", "filter"]),
    st.floats(0.0, 360.0),
    st.integers(-400, 400),
)
def test_parcels_of_each_size_are_conserved(sizes, boundary, footprint, collapse, direction, amount):
    simulation = sorted_sand(
        sizes,
        lattice__boundary_x=boundary,
        lattice__boundary_y=boundary,
        model__footprint=footprint,
        model__collapse=collapse,
        wind__direction=direction,
    )
    before = all_parcels(simulation)
    assert before.sum() == simulation.ledger.initial
    simulation.advance(8)
    simulation.apply(Stroke(x=0.1, y=0.03, radius=0.02, amount=amount))
    simulation.advance(8)
    check_bed(simulation)
    np.testing.assert_array_equal(all_parcels(simulation), before)
    gone = simulation.ledger.left - simulation.ledger.entered
    assert simulation.model.sized_sand.left.sum() == gone
    assert in_the_air(simulation).sum() == simulation.ledger.airborne > 0


def test_the_start_has_the_shares_of_the_scenario_but_for_whole_parcels():
    simulation = sorted_sand(THREE)
    check_bed(simulation)
    shares = simulation.model.sized_sand.on_bed(simulation.bed) / simulation.bed.units
    np.testing.assert_allclose(shares, [0.7, 0.2, 0.1], atol=1e-3)


def test_whole_parcels_are_right_in_the_mean():
    part = (np.arange(1000) + 0.5) / 1000
    fine, middle, coarse = split(np.full(1000, 7, np.int32), np.array([0.5, 0.93, 1.0]), part)
    np.testing.assert_allclose([fine.mean(), middle.mean(), coarse.mean()], [3.5, 3.01, 0.49], atol=2e-3)
    assert (fine + middle + coarse == 7).all()


@pytest.mark.extended
def test_a_resumed_run_of_several_sizes_goes_on_with_the_same_bits():
    whole = sorted_sand(THREE)
    whole.advance(15)
    again = Simulation.from_state(whole.state())
    stroke = Stroke(x=0.1, y=0.03, radius=0.02, amount=-100)
    for one in (whole, again):
        one.advance(5)
        one.apply(stroke)
        one.apply(SetParameter(key="model.repose_angle", value=30.0))
        one.advance(10)
    for name, values in whole.bed.arrays.items():
        np.testing.assert_array_equal(values, again.bed.arrays[name])
    for name, value in whole.model.state().items():
        np.testing.assert_array_equal(value, again.model.state()[name])


def test_bits_of_several_sizes_do_not_depend_on_the_number_of_threads(monkeypatch):
    found = []
    for threads in (1, 3):
        monkeypatch.setattr(thread_pool, "LEAST", 128)
        monkeypatch.setattr(thread_pool, "thread_count", lambda threads=threads: threads)
        simulation = sorted_sand(THREE, lattice__rows=40, model__entrainment__probability=0.1)
        simulation.advance(25)
        assert simulation.model.pool.in_use > 384
        found.append(simulation.state().arrays)
    for name, values in found[0].items():
        for other in found[1:]:
            np.testing.assert_array_equal(values, other[name])


def test_bits_of_several_sizes_do_not_depend_on_how_a_run_is_cut():
    whole, pieces = sorted_sand(), sorted_sand()
    whole.advance(12)
    for steps in (1, 5, 2, 4):
        pieces.advance(steps)
    np.testing.assert_array_equal(whole.bed.arrays["surface_2"], pieces.bed.arrays["surface_2"])


def test_grains_of_one_class_are_those_of_uniform_sand():
    uniform = Simulation(barchan.load(SMALL))
    one = sorted_sand([{"diameter": FINE, "share": 1.0}])
    for simulation in (uniform, one):
        simulation.advance(40)
    assert one.model.pool.flying == pytest.approx(uniform.model.pool.flying, rel=0.15)
    assert one.tally.moved == pytest.approx(uniform.tally.moved, rel=0.15)


def test_what_is_too_heavy_to_fly_creeps_downwind_and_never_flies():
    simulation = sorted_sand(CREEPING)
    wind = simulation.forcing.wind_of(0)
    assert simulation.model.parameters.too_heavy(simulation.model.setting(wind).ustar).tolist() == [
        False,
        True,
    ]
    x = np.arange(48)
    middle = np.abs(x - 24) <= 2
    for name in ("surface", "substrate"):
        fine, heavy = (simulation.bed.arrays[f"{name}_{kind}"] for kind in (1, 2))
        fine += np.where(middle, 0, heavy)
        heavy *= middle
    place = x @ simulation.bed.arrays["surface_2"].sum(0) / simulation.bed.arrays["surface_2"].sum()
    for _ in range(4):
        simulation.advance(10)
        assert in_the_air(simulation)[1] == 0
    now = simulation.bed.arrays["surface_2"].sum(0) + simulation.bed.arrays["substrate_2"].sum(0)
    assert x @ now / now.sum() > place + 0.01


def test_without_its_momentum_nothing_creeps():
    rules = {"model__creep__momentum": 0.0, "model__splash__ejecta_momentum": 0.0}
    simulation = sorted_sand(CREEPING, model__repose_angle=89.0, **rules)
    before = simulation.model.sized_sand.on_bed(simulation.bed)[1]
    heavy = simulation.bed.arrays["surface_2"] + simulation.bed.arrays["substrate_2"]
    simulation.advance(20)
    assert before == simulation.model.sized_sand.on_bed(simulation.bed)[1]
    np.testing.assert_array_equal(
        heavy, simulation.bed.arrays["surface_2"] + simulation.bed.arrays["substrate_2"]
    )


def test_the_mean_diameter_of_a_surface_is_that_of_its_grains():
    simulation = sorted_sand()
    (field,) = (one for one in type(simulation.model).derived if one.unit == "m")
    diameter = field.compute(simulation.model, simulation.bed, simulation.forcing.wind_of(0))
    assert diameter.mean() == pytest.approx(0.7 * FINE + 0.3 * COARSE, rel=0.02)
    assert coarse_crests(simulation.model, simulation.bed) == pytest.approx(1.0, abs=0.02)
    simulation.bed.arrays["surface_1"][...] = 0
    assert surface_diameter(simulation.model, simulation.bed).max() == pytest.approx(COARSE)


@pytest.mark.parametrize(
    ("sizes", "said"),
    [
        ([TWO[0]], "sizes.classes: have shares that sum to 0.7; allowed: a sum of 1"),
        (
            TWO[::-1],
            "sizes.classes[1].diameter: is 0.00015 m after 0.0004 m; allowed: diameters that increase",
        ),
        ([{"diameter": FINE, "share": 0.5}] * 2, "diameters that increase"),
        ([{"diameter": 0.0, "share": 1.0}], "sizes.classes[0].diameter"),
        (
            [{"diameter": FINE, "share": -1.0}, {"diameter": COARSE, "share": 2.0}],
            "sizes.classes[0].share",
        ),
        ([{"diameter": FINE}], "sizes.classes[0].share"),
        ([{"diameter": FINE, "share": 0.2}] * 5, "4"),
        (0.3, "sizes.classes"),
    ],
)
def test_what_is_wrong_with_sizes_is_named(sizes, said):
    with pytest.raises(ScenarioError) as caught:
        sorted_sand(sizes)
    assert said in str(caught.value)


spreads = st.floats(1.0, 3.0, exclude_min=True)


@given(st.floats(0.05e-3, 5e-3), spreads, st.sampled_from([2, 3, 4]))
def test_classes_of_a_spread_hold_equal_shares_about_the_median(median, spread, count):
    classes = lognormal(median, spread, count)
    assert sum(one.share for one in classes) == pytest.approx(1.0, abs=1e-12)
    diameters = np.array([one.diameter for one in classes])
    assert np.exp(np.log(diameters).mean()) == pytest.approx(median)
    np.testing.assert_allclose(diameters * diameters[::-1], median**2)
    assert (np.diff(diameters) >= 0).all()


@given(spreads, spreads, st.sampled_from([2, 3, 4]))
def test_the_wider_the_spread_the_farther_apart_its_classes(one, other, count):
    narrow, wide = (lognormal(1e-3, spread, count) for spread in sorted((one, other)))
    assert wide[0].diameter <= narrow[0].diameter
    assert wide[-1].diameter >= narrow[-1].diameter


@pytest.mark.parametrize("count", [2, 3, 4])
def test_the_class_of_a_spread_is_the_mean_of_its_part_of_the_distribution(count):
    drawn = np.sort(np.random.default_rng(1).normal(size=400_000)) * np.log(1.5)
    parts = np.exp([part.mean() for part in np.array_split(drawn, count)])
    found = [one.diameter for one in lognormal(1.0, 1.5, count)]
    np.testing.assert_allclose(found, parts, rtol=3e-3)


def test_spread_sand_flies_as_its_classes_would():
    stated = [one.model_dump() for one in lognormal(FINE, 1.4, 3)]
    runs = sorted_sand(stated), sorted_sand([], model__sizes__spread=1.4, model__grain_diameter=FINE)
    for one in runs:
        one.advance(10)
    assert runs[1].ledger.airborne > 0
    for name, values in runs[0].bed.arrays.items():
        np.testing.assert_array_equal(values, runs[1].bed.arrays[name])
    again = Simulation.from_state(runs[1].state())
    for one in (runs[1], again):
        one.advance(5)
    np.testing.assert_array_equal(again.bed.arrays["surface_3"], runs[1].bed.arrays["surface_3"])
    assert len(again.model.facts()["settling speed"].split(",")) == 3


@pytest.mark.parametrize(
    ("rules", "said"),
    [
        (
            nested(sizes__classes=TWO, sizes__spread=1.5),
            "model.sizes.spread: is 1.5, and classes are given too; leave one of them out",
        ),
        (
            nested(sizes__spread=3.0, grain_diameter=0.1e-3),
            "model.sizes.spread: is 3, which makes grains of 3.02e-05 to 0.000331 m about grain_diameter",
        ),
        (nested(sizes__spread=1.0), "model.sizes.spread"),
        (nested(sizes__spread=3.1), "≤ 3"),
        (nested(sizes__spread=1.5, sizes__spread_classes=5), "≤ 4"),
        (nested(sizes__spread_classes=1), "≥ 2"),
    ],
)
def test_what_is_wrong_with_a_spread_is_named(rules, said):
    with pytest.raises(ScenarioError) as caught:
        barchan.load({**SMALL, "model": {**SMALL["model"], **rules}})
    assert said in str(caught.value)


def test_a_time_step_is_held_against_the_finest_grains():
    sizes = [{"diameter": 0.05e-3, "share": 0.5}, {"diameter": 5e-3, "share": 0.5}]
    with pytest.raises(ScenarioError, match="drag works"):
        sorted_sand(sizes, model__time_step=0.02, lattice__cell_size=1.0, lattice__slab_height=1e-3)
