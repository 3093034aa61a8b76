"""A wind that keeps its mean."""

import numpy as np
import pytest
from pydantic import ValidationError

from barchan.wind import Segment, Steady
from barchan.wind.gusts import Gusts
from tests.wind.blown import forcing, segments


def test_a_steady_wind_is_one_segment_that_polls_every_cell_once_a_step():
    assert segments(Steady(direction=90.0, speed=3.0), 40, 7) == [Segment(40, 7, 0, 100, 90.0, 3.0)]


def test_a_wind_without_a_speed_leaves_the_hop_length_to_the_model():
    (segment,) = segments(Steady(), 0, 1)
    assert segment.hop_length is None
    assert segment.seconds is None


def test_a_calm_passes_time_without_polls():
    (segment,) = segments(Steady(speed=0.0), 0, 9, step_seconds=60.0)
    assert (segment.polls, segment.seconds) == (0, 540.0)


def test_a_speed_in_metres_per_second_changes_the_polls_and_not_the_hops():
    (segment,) = segments(Steady(speed=9.0, unit="m/s"), 0, 4, strength=lambda speeds: speeds / 36.0)
    assert (segment.polls, segment.hop_length, segment.speed) == (25, None, 9.0)


def test_polls_that_are_no_whole_number_are_right_in_the_long_run():
    wind = Steady(speed=1.0, unit="m/s")
    found = segments(wind, 17, 4000, strength=lambda speeds: speeds * 0.00314159)
    polls = [s.polls for s in found for _ in range(s.steps)]
    assert set(polls) == {0, 1}
    assert sum(polls) == pytest.approx(0.314159 * 4000, abs=3)


def test_a_spread_deviates_normally_and_anew_at_each_step():
    wind = Steady(direction=355.0, spread=10.0)
    deviations = [(s.direction - 355.0 + 180) % 360 - 180 for s in segments(wind, 0, 4000)]
    assert np.mean(deviations) == pytest.approx(0.0, abs=3 * 10 / 4000**0.5)
    assert np.std(deviations) == pytest.approx(10.0, rel=0.05)
    assert abs(np.corrcoef(deviations[1:], deviations[:-1])[0, 1]) < 0.05
    assert forcing(wind).wind_of(3).direction == 355.0


def test_deviations_belong_to_steps_and_not_to_calls():
    wind = Steady(spread=20.0)
    assert segments(wind, 0, 9) == segments(wind, 0, 4) + segments(wind, 4, 5)
    assert segments(wind, 0, 9) != segments(wind, 0, 9, seed=2)


def test_gusts_move_more_sand_than_their_mean_where_the_flux_bends_upwards():
    calm, gusty = (
        Steady(speed=8.0, unit="m/s", gusts=Gusts(intensity=i, correlation_time=1.0)) for i in (0.0, 0.3)
    )
    polls = [
        sum(
            s.polls * s.steps for s in segments(w, 0, 200, step_seconds=60.0, strength=lambda u: (u / 8) ** 3)
        )
        for w in (calm, gusty)
    ]
    assert polls[0] == 20_000
    assert polls[1] / polls[0] == pytest.approx(1 + 3 * 0.3**2, rel=0.03)


@pytest.mark.parametrize("direction", [-1.0, 360.0, float("nan"), "west"])
def test_a_direction_lies_within_a_turn(direction):
    with pytest.raises(ValidationError):
        Steady(direction=direction)


@pytest.mark.parametrize(
    ("wind", "said"),
    [
        ({"unit": "m/s"}, "unit is m/s, but no speed is given"),
        ({"speed": 3.0, "gusts": Gusts()}, "gusts are given, but the speed is not"),
    ],
)
def test_winds_that_make_no_sense_are_refused(wind, said):
    with pytest.raises(ValidationError, match=said):
        Steady(**wind)
