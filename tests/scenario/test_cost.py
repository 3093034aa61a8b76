"""The expected time of a run, worked out by hand from polls and rates."""

import pytest

from barchan import load
from barchan.scenario.cost import expected_seconds, expected_work, spoken_estimate


def test_a_step_polls_as_many_cells_as_the_field_has() -> None:
    scenario = load("barchans", lattice__rows=100, lattice__columns=200, run__steps=30)
    assert expected_work(scenario) == 30 * 100 * 200
    assert expected_seconds(scenario) == pytest.approx(30 * 100 * 200 / 2e7)


def test_a_run_without_steps_takes_no_time() -> None:
    assert expected_seconds(load("barchans", run__steps=0)) == 0.0


def test_winds_that_blow_for_half_of_the_time_ask_for_half_of_the_polls() -> None:
    """A calm polls nothing: half of the steps at the reference speed, half at 0 m/s, alternating."""
    regimes = [{"direction": 270.0, "speed": v, "unit": "m/s", "steps": 1} for v in (10.0, 0.0)]
    wind = {"kind": "regimes", "regimes": regimes}
    both = load("barchans", clock={"reference_speed": 10.0}, wind=wind, run__steps=1000)
    assert expected_work(both) == pytest.approx(500 * both.lattice.cells, rel=0.1)


def test_slabs_that_come_in_across_an_edge_are_work() -> None:
    """100 cells of the west edge with 8 slabs each, a poll each beside those of the field."""
    influx = {"kind": "slabs", "slabs_per_step": 8.0}
    open_field = {"lattice__rows": 100, "lattice__columns": 200, "lattice__boundary_x": "open"}
    scenario = load("transverse", **open_field, influx=influx, run__steps=30)
    assert expected_work(scenario) == 30 * (100 * 200 + 100 * 8)


def test_ripples_of_the_benchmark_take_its_number_of_updates() -> None:
    """docs/benchmarks.md: 256 × 256 cells, 73 s at 77 million updates a second."""
    scenario = load("ripples", lattice__rows=256)
    assert expected_work(scenario) == pytest.approx(73 * 77e6, rel=0.3)


def test_grains_that_fly_one_after_the_other_take_longer() -> None:
    """Measured: 100 updates and 95 µs of a core for each of 10,000 trajectories of a step."""
    assert expected_seconds(load("first-grains")) == pytest.approx(100 * 10_000 * 95e-6, rel=0.5)


def test_grains_below_the_threshold_are_no_work() -> None:
    assert expected_work(load("szabo-10", model__wind_speed=1.0)) == 0.0


@pytest.mark.parametrize(
    ("seconds", "words"),
    [
        (0.2, "under a second"),
        (1.2, "about 1 second"),
        (52.4, "about 50 seconds"),
        (58.0, "about 1 minute"),
        (90.0, "about 2 minutes"),
        (7300.0, "about 2 hours"),
        (86400 * 3.2, "about 3 days"),
    ],
)
def test_times_are_told_in_one_figure(seconds: float, words: str) -> None:
    assert spoken_estimate(seconds) == words


def test_the_estimate_of_storms_without_a_seed_is_the_same_each_time():
    assert len({expected_seconds(load("snow-season")) for _ in range(3)}) == 1
