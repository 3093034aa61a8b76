"""What winds do, step by step."""

from barchan.wind import Forcing, StepClock
from barchan.wind.forcing import Blows

CELLS = 100


def forcing(wind: Blows, step_seconds=None, strength=None, cells=CELLS, seed=1) -> Forcing:
    """A wind over some cells."""
    return Forcing(wind, StepClock(seed, step_seconds, strength), cells)


def segments(wind, step, steps, **clock):
    """All segments of some steps."""
    return [segment for together in forcing(wind, **clock).segments(step, steps) for segment in together]


def blown(wind, step, steps, **clock):
    """(step, direction, hop length) of every segment of every single step."""
    return [
        (segment.step + k, segment.direction, segment.hop_length)
        for segment in segments(wind, step, steps, **clock)
        for k in range(segment.steps)
    ]
