"""Temperature and snowfall that change: over a run, or while a wind blows."""

import pytest

from barchan.errors import ScenarioError
from barchan.simulation import Simulation
from barchan.wind import Forcing, Regime, Regimes, Steady, StepClock, WeatherCourse
from barchan.wind.ramps import Bezier
from barchan.wind.weather_course import SnowfallCourse, TemperatureCourse
from tests.tiny import tiny
from tests.wind.blown import segments

WEST = Steady(kind="steady", direction=270.0)
S_SHAPED = {"kind": "bezier", "time_1": 0.5, "value_1": 0.0, "time_2": 0.5, "value_2": 1.0}


def over_run(step, steps, wind=WEST, clock=None, **courses):
    """Segments of some steps under a wind, with the weather of the run."""
    forcing = Forcing(wind, clock or StepClock(1), 100, None, WeatherCourse(**courses))
    return [segment for together in forcing.segments(step, steps) for segment in together]


def temperatures(found):
    """The temperature of each step."""
    return [segment.weather.temperature for segment in found for _ in range(segment.steps)]


def test_a_temperature_rises_on_a_straight_line_from_the_start_to_the_stated_time_and_stays():
    warming = TemperatureCourse(first=-20.0, last=0.0, steps=10)
    assert temperatures(over_run(0, 12, temperature=warming)) == pytest.approx(
        [-19, -17, -15, -13, -11, -9, -7, -5, -3, -1, 0, 0]
    )


def test_a_temperature_follows_a_bezier_curve():
    """The symmetric curve is half done at half the time, and flat at both ends: 3u² - 2u³ of its own time."""
    course = Bezier(**S_SHAPED)
    found = temperatures(
        over_run(0, 100, temperature=TemperatureCourse(first=-20.0, last=0.0, steps=100, ramp=course))
    )
    assert (found[49] + found[50]) / 2 == pytest.approx(-10.0)
    assert found[0] - -20.0 < 0.01
    u = 0.25  # time 1.5 u - 1.5 u² + u³ = 0.296875, value 3 u² - 2 u³ = 0.15625
    before, after = found[29], found[30]
    share = (0.296875 * 100 - 29.5) / 1.0
    assert before + share * (after - before) == pytest.approx(-20.0 + 20.0 * (3 * u**2 - 2 * u**3), abs=0.01)


def test_a_slow_change_is_made_in_pieces_that_differ_by_a_tenth_of_a_kelvin():
    warming = TemperatureCourse(first=-10.0, last=-8.0, steps=10_000)
    found = over_run(0, 10_000, temperature=warming)
    assert [segment.steps for segment in found] == [500] * 20
    assert [segment.weather.temperature for segment in found] == pytest.approx(
        [-9.95 + 0.1 * k for k in range(20)]
    )


def test_pieces_do_not_depend_on_how_a_run_is_advanced():
    falling = SnowfallCourse(first=0.0, last=1e-3, steps=777)
    whole = temperatures_and_snowfall(over_run(0, 800, snowfall=falling))
    for cut in (1, 7, 130, 776):
        pieces = [*over_run(0, cut, snowfall=falling), *over_run(cut, 800 - cut, snowfall=falling)]
        assert temperatures_and_snowfall(pieces) == whole


def temperatures_and_snowfall(found):
    return [segment.weather for segment in found for _ in range(segment.steps)]


def test_a_change_in_seconds_lasts_as_many_steps_as_the_clock_says():
    warming = TemperatureCourse(first=-20.0, last=0.0, seconds=36_000.0)
    found = temperatures(over_run(0, 11, clock=StepClock(1, 3600.0), temperature=warming))
    assert found == pytest.approx([*range(-19, 0, 2), 0])


def test_what_a_wind_states_counts_more_than_the_weather_of_the_run():
    cold = Steady(kind="steady", direction=270.0, temperature=-30.0)
    found = over_run(
        0, 3, cold, temperature=TemperatureCourse(first=-1.0), snowfall=SnowfallCourse(first=1e-4)
    )
    assert {(s.weather.temperature, s.weather.snowfall) for s in found} == {(-30.0, 1e-4)}


def test_a_regime_takes_its_temperature_from_a_first_to_a_last_value_each_time_it_blows():
    winds = Regimes(
        kind="regimes",
        regimes=[
            Regime(direction=270.0, steps=4, temperature=-8.0, final_temperature=0.0),
            Regime(direction=0.0, steps=2, temperature=-3.0),
        ],
    )
    cycle = [-7, -5, -3, -1, -3, -3]
    assert temperatures(segments(winds, 0, 12)) == pytest.approx(cycle * 2)
    assert temperatures([*segments(winds, 0, 5), *segments(winds, 5, 7)]) == pytest.approx(cycle * 2)


def test_snow_falls_ever_harder_during_a_regime_and_then_as_it_ended():
    storm = Regime(direction=270.0, steps=4, snowfall=0.0, final_snowfall=8e-4)
    winds = Regimes(kind="regimes", regimes=[storm], repeat=False)
    found = [segment.weather.snowfall for segment in segments(winds, 0, 6) for _ in range(segment.steps)]
    assert found == pytest.approx([1e-4, 3e-4, 5e-4, 7e-4, 8e-4, 8e-4])


def test_a_regime_that_begins_within_a_step_has_its_own_temperature_there():
    winds = Regimes(
        kind="regimes",
        regimes=[
            Regime(direction=270.0, seconds=150.0, temperature=-10.0, final_temperature=-7.0),
            Regime(direction=0.0, seconds=150.0, temperature=-1.0),
        ],
    )
    found = segments(winds, 0, 3, step_seconds=100.0)
    assert [(s.share, s.weather.temperature) for s in found] == [
        (1.0, pytest.approx(-9.0)),
        (0.5, pytest.approx(-7.5)),
        (0.5, -1.0),
        (1.0, -1.0),
    ]


def test_the_weather_of_a_run_reaches_its_segments():
    weather = {"temperature": {"first": -20.0, "last": -10.0, "steps": 5}, "snowfall": {"first": 2e-4}}
    simulation = Simulation(tiny(weather=weather))
    simulation.advance(5)
    now = simulation.last_segment.weather
    assert (now.temperature, now.snowfall) == (pytest.approx(-11.0), 2e-4)


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        (
            {"weather": {"temperature": {"first": -5.0, "last": 0.0}}},
            r"weather\.temperature: last is given, and neither steps nor seconds is given",
        ),
        (
            {"weather": {"temperature": {"first": -5.0, "steps": 7}}},
            r"weather\.temperature: steps is given without last",
        ),
        (
            {"weather": {"snowfall": {"first": 0.0, "last": 1e-3, "seconds": 60.0}}},
            r"weather\.snowfall\.seconds: is 60 s, which needs a clock; give the scenario a clock",
        ),
        ({"weather": {"snowfall": {"first": -1e-3}}}, r"weather\.snowfall\.first: is -0\.001; allowed"),
        ({"weather": {"temperature": {"first": 70.0}}}, r"weather\.temperature\.first: is 70\.0?; allowed"),
        (
            {
                "wind": {
                    "kind": "regimes",
                    "regimes": [{"direction": 0.0, "steps": 3, "final_temperature": -5.0}],
                }
            },
            r"wind\.regimes\[0\]: final_temperature -5\.0 is given without temperature; give both",
        ),
    ],
)
def test_what_cannot_be_is_refused_with_its_key(changes, said):
    with pytest.raises(ScenarioError, match=said):
        tiny(**changes)
