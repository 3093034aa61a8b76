"""Snow after Werner's rules: it hardens day by day, and the day on which it is immobile is known before.

The days come from the stated curve by hand: from day 0 to 98 it rises by 0.2335 - 0.08 = 0.1535 g/cm³, of
which snow at T needs 0.32 × 0.1535 / s(T), with s(T) = 0.32 + 0.68 (T + 20)/20.
"""

import numpy as np
import pytest

import barchan
from barchan.errors import ScenarioError
from barchan.models.snow_werner import SnowWerner
from barchan.simulation import SetParameter, Simulation
from tests.tiny import tiny

WARMING = {"temperature": {"first": -20.0, "last": 0.0, "steps": 100}}


def snow(steps=160, hardening=None, **changes):
    model = {"name": "snow_werner", "hop_length": 3.0, "hardening": hardening or {}}
    return tiny(**{"model": model, "run__steps": steps, **changes})


def predicted(scenario):
    return scenario.forecast()["predicted to be immobile"]


@pytest.mark.parametrize(
    ("temperature", "day"), [(-20.0, 98), (-15.0, 45), (-10.0, 29), (-5.0, 20), (0.0, 16)]
)
def test_snow_at_a_constant_temperature_is_immobile_on_the_day_of_the_curve(temperature, day):
    scenario = snow(wind__temperature=temperature)
    assert predicted(scenario) == f"on day {day}"
    simulation = Simulation(scenario)
    simulation.advance(160)
    assert (simulation.steps_done, simulation.finished) == (day, f"immobile on day {day}")


WEATHERS = {
    "warming to the thesis's day 51": {"weather": WARMING},
    "an S-shaped course": {
        "weather": {
            "temperature": {
                "first": -18.0,
                "last": -2.0,
                "steps": 60,
                "ramp": {"kind": "bezier", "time_1": 0.4, "value_1": 0.0, "time_2": 0.6, "value_2": 1.0},
            }
        }
    },
    "weeks of frost and thaw": {
        "wind": {
            "kind": "regimes",
            "regimes": [
                {"direction": 270.0, "steps": 7, "temperature": -19.0},
                {"direction": 250.0, "steps": 3, "temperature": -9.0, "final_temperature": 0.0},
            ],
        }
    },
    "two winds a day": {
        "wind": {
            "kind": "regimes",
            "regimes": [
                {"direction": 270.0, "seconds": 40_000.0, "temperature": -20.0},
                {"direction": 180.0, "seconds": 46_400.0, "temperature": -6.5},
            ],
        }
    },
    "winds that rise within days": {
        "wind": {
            "kind": "regimes",
            "regimes": [
                {
                    "direction": 270.0,
                    "seconds": 123_456.0,
                    "speed": 2.0,
                    "final_speed": 9.0,
                    "temperature": -17.0,
                    "final_temperature": -3.0,
                },
            ],
        }
    },
}


@pytest.mark.parametrize("increment", ["curve", "density"])
@pytest.mark.parametrize("weather", WEATHERS.values(), ids=WEATHERS)
def test_the_run_ends_on_the_predicted_day_in_any_weather(weather, increment):
    scenario = snow(hardening={"increment": increment}, **weather)
    simulation = Simulation(scenario)
    simulation.advance(160)
    assert f"on day {simulation.steps_done}" == predicted(scenario)
    assert simulation.finished == f"immobile on day {simulation.steps_done}"


def test_a_temperature_that_rises_evenly_for_100_days_ends_the_run_on_day_51_as_the_thesis_says():
    assert predicted(snow(weather=WARMING)) == "on day 51"


def test_both_readings_are_immobile_on_day_98_at_minus_20():
    """The constant is fixed there for either; warm snow packs faster by its density.

    At 0 °C snow is 1.5 times as dense as the curve, from 120 against 80 on; it needs about
    70 (2.92^0.32 - 1) = 28.6 kg/m³, which is 1.5 times the curve's rise of 3.5 a day after 5.5 days.
    """
    days = {
        (increment, temperature): predicted(
            snow(hardening={"increment": increment}, wind__temperature=temperature)
        )
        for increment in ("curve", "density")
        for temperature in (-20.0, 0.0)
    }
    assert days["curve", -20.0] == days["density", -20.0] == "on day 98"
    assert days["density", 0.0] == "on day 6"


def test_the_chance_to_give_a_slab_falls_with_the_resistance():
    """Every poll of a deep flat bed without shadow finds snow: moved / polls = 1 - R, here of day 10.

    At 0 °C the curve rises by 3.5 kg/m³ a day for ten days, of the 0.32 × 153.5 kg/m³ it takes.
    """
    model = {"name": "snow_werner", "shadow_angle": 89.0, "p_s": 1.0, "repose_angle": 89.0}
    simulation = Simulation(
        tiny(
            model=model,
            sand={"kind": "flat", "mean": 20},
            lattice={"rows": 64, "columns": 64},
            wind__temperature=0.0,
        )
    )
    simulation.advance(10)
    resistance = 35.0 / (0.32 * 153.5)
    np.testing.assert_allclose(simulation.bed.arrays["resistance"], resistance, rtol=1e-12)
    tally = simulation.advance(1)
    assert tally.moved / tally.polls == pytest.approx(1 - resistance, abs=4 * 0.5 / tally.polls**0.5)


def test_nothing_moves_once_snow_is_immobile():
    simulation = Simulation(snow(wind__temperature=0.0))
    simulation.advance(16)
    before = simulation.bed.sand.copy()
    simulation.apply(SetParameter(key="model.hop_length", value=5.0))
    assert simulation.advance(5).moved == 0
    np.testing.assert_array_equal(simulation.bed.sand, before)
    assert simulation.finished == "immobile on day 16"


def test_every_number_of_a_state_is_finite_before_the_first_day_too():
    state = Simulation(tiny(model={"name": "snow_werner"})).state()
    assert all(np.isfinite(array).all() for array in state.arrays.values() if array.dtype.kind == "f")


def test_the_density_of_snow_goes_on_after_a_stop_with_the_same_bits():
    scenario = snow(hardening={"increment": "density"}, weather=WARMING)
    whole, begun = Simulation(scenario), Simulation(scenario)
    whole.advance(160)
    for steps in (1, 6, 13):
        begun.advance(steps)
    resumed = Simulation.from_state(begun.state())
    resumed.advance(140)
    assert resumed.finished == whole.finished
    assert resumed.model.state() == whole.model.state()
    for name, field in whole.bed.arrays.items():
        np.testing.assert_array_equal(field, resumed.bed.arrays[name])


def test_a_temperature_changed_during_a_run_counts_from_then_on():
    """49.12 kg/m³ are needed: 5 days give 0.32 × 3.5 each, 5 give 3.5, 10 give 2.5, then 1.75 a day."""
    simulation = Simulation(snow())
    simulation.advance(5)
    simulation.apply(SetParameter(key="model.hardening.temperature", value=0.0))
    simulation.advance(100)
    assert simulation.finished == "immobile on day 21"


def test_snow_that_never_packs_enough_is_predicted_to_stay_mobile():
    """Light snow of a first day at -15 °C gains by its density 6/7 of what the constant was fixed on."""
    curve = [{"day": 0.0, "density": 80.0}, {"day": 9.0, "density": 205.0}]
    hardening = {"increment": "density", "packed_snow": curve, "locks_after": 9}
    winds = [{"direction": 270.0, "steps": n, "temperature": t} for n, t in ((1, -15.0), (500, -20.0))]
    scenario = snow(20, hardening, wind={"kind": "regimes", "regimes": winds, "repeat": False})
    assert predicted(scenario) == "never: packed_snow gets no denser after day 9"
    simulation = Simulation(scenario)
    simulation.advance(20)
    assert simulation.finished is None
    assert simulation.bed.arrays["resistance"].max() < 1


def test_a_day_is_a_step_and_the_curves_are_data():
    scenario = snow()
    assert scenario.step_seconds == 86_400
    fresh, packed = SnowWerner.curves(scenario.model)
    assert (fresh.remark, packed.remark) == ("assumed", "assumed")
    assert packed.y[-1] == 265.0


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        (
            {"wind__temperature": 1.0},
            r"wind\.temperature: comes to 1 °C; allowed with .*: temperatures from -20 to 0",
        ),
        (
            {"weather": {"temperature": {"first": -21.0, "last": 0.0, "steps": 9}}},
            r"weather\.temperature: comes to -21 °C; allowed",
        ),
        (
            {"clock": {}},
            r"clock: is given, but the steps of Snow .* last 86400 s by themselves; leave it out",
        ),
        (
            {"wind": {"kind": "steady", "speed": 9.0, "unit": "m/s"}},
            r"wind\.unit: is m/s; speeds in m/s do not tell how far slabs of Snow .* hop; state a speed in",
        ),
        (
            {"wind": {"kind": "record"}},
            r"wind\.kind: is a record, whose winds in m/s do not tell how far slabs",
        ),
        (
            {"hardening": {"locks_after": 200}},
            r"model\.hardening\.locks_after: is 200, but the pack of packed_snow gets no denser on that day",
        ),
        (
            {
                "hardening": {
                    "locks_after": 9,
                    "packed_snow": [{"day": 0.0, "density": 90.0}, {"day": 9.0, "density": 90.0 + 1e-12}],
                }
            },
            r"model\.hardening\.locks_after: is 9, but by then snow at -20 °C is no denser than at first",
        ),
        (
            {
                "hardening": {
                    "fresh_snow": [
                        {"temperature": -5.0, "density": 5e-324},
                        {"temperature": 0.0, "density": 1.0},
                    ]
                }
            },
            r"model\.hardening\.fresh_snow\[0\]\.density: is 5e-324; allowed: number ≥ 1",
        ),
        (
            {"hardening": {"packed_snow": [{"day": 5.0, "density": 90.0}, {"day": 4.0, "density": 95.0}]}},
            r"model\.hardening\.packed_snow\[1\]\.day: is 4\.0 after 5\.0; allowed: days that increase",
        ),
    ],
)
def test_what_cannot_be_is_refused_with_its_key(changes, said):
    with pytest.raises(ScenarioError, match=said):
        snow(**changes)


def test_ripples_of_table_6_7_end_on_day_98():
    assert predicted(barchan.load("snow-ripples-98")) == "on day 98"
    assert predicted(barchan.load("snow-barchans-51")) == "on day 51"
