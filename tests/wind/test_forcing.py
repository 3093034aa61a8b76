"""From a wind to segments of steps."""

from itertools import pairwise

from hypothesis import given
from hypothesis import strategies as st

from barchan.wind import MixedAxes, Regime, Regimes, Steady
from tests.wind.blown import segments

WINDS = [
    Steady(spread=5.0),
    Steady(speed=6.5, unit="m/s"),
    MixedAxes(kind="mixed_axes", share=0.4),
    Regimes(
        kind="regimes",
        regimes=[
            Regime(direction=10.0, seconds=170.0, speed=8.0, final_speed=3.0, unit="m/s"),
            Regime(direction=100.0, steps=2),
            Regime(direction=200.0, seconds=30.0, speed=0.0),
        ],
    ),
]
PACE = {"step_seconds": 100.0, "strength": lambda speeds: speeds / 7.0}


def unrolled(found):
    """Every segment of every single step."""
    return [segment.part(k, 1) for segment in found for k in range(segment.steps)]


@given(st.sampled_from(WINDS), st.integers(0, 200), st.integers(1, 30), st.data())
def test_segments_do_not_depend_on_where_a_run_is_cut(wind, step, steps, data):
    cut = data.draw(st.integers(0, steps))
    parts = segments(wind, step, cut, **PACE) + segments(wind, step + cut, steps - cut, **PACE)
    assert unrolled(segments(wind, step, steps, **PACE)) == unrolled(parts)


@given(st.sampled_from(WINDS), st.integers(0, 10**12))
def test_the_segments_of_a_step_fill_its_time_and_follow_one_another(wind, step):
    found = segments(wind, step, 1, **PACE)
    assert abs(sum(s.share for s in found) - 1.0) < 1e-9
    assert [s.ends for s in found] == [False] * (len(found) - 1) + [True]
    assert found[0].first == 0
    for before, after in pairwise(found):
        assert after.first == before.first + before.polls
