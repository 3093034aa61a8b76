"""What winds do, step by step."""

from barchan.wind import Forcing, Pace
from barchan.wind.forcing import Blows

CELLS = 100


def forcing(wind: Blows, step_seconds=None, strength=None, cells=CELLS, seed=1) -> Forcing:
    """A wind over some cells."""
    return Forcing(wind, Pace(seed, step_seconds, strength), cells)


def segments(wind, step, steps, **pace):
    """All segments of some steps."""
    return [segment for turn in forcing(wind, **pace).turns(step, steps) for segment in turn]


def blown(wind, step, steps, **pace):
    """(step, direction, hop length) of every segment of every single step."""
    return [
        (segment.step + k, segment.direction, segment.hop_length)
        for segment in segments(wind, step, steps, **pace)
        for k in range(segment.steps)
    ]
