"""The resultant wind: where the sand that all winds of a cycle move comes from, on the whole."""

import math
from collections.abc import Iterator
from dataclasses import replace

from barchan.directions import bearing, downwind
from barchan.wind.forcing import Forcing
from barchan.wind.series import SeriesWind

CANCELS = 0.02
"""Share of all transport below which what remains of it has no direction; ours."""


def resultant_direction(forcing: Forcing, step: int, usual_hop: float = 1.0) -> float:
    """Direction (degrees) that the mean transport of a whole cycle of the wind comes from.

    The cycle is that of the wind of ``step``. Of a wind that never comes again it is the mean until the end
    of that step; of one that stays the same, or comes again within a step, that of the step. Transport is in
    proportion to the polls and the hop length of each wind (``usual_hop``, in cells, where it states none);
    random deviations from its direction are left out. NaN where no sand moves, or where the winds cancel to
    less than 2 % of the transport.
    """
    period = forcing.wind.period(step, forcing.clock)
    whole = replace(forcing, clock=replace(forcing.clock, deviates=False))
    if period == 0.0:
        first, steps = step, 1
    elif math.isinf(period):
        first, steps = 0, step + 1
    else:
        first, steps = 0, round(period * _whole(period))
    total, sums = 0.0, [0.0, 0.0]
    for work, direction in _works(whole, first, steps, usual_hop):
        total += work
        for axis, part in enumerate(downwind(direction)):
            sums[axis] += work * part
    if math.hypot(*sums) <= CANCELS * total:
        return math.nan
    return bearing(*sums)


def _works(forcing: Forcing, first: int, steps: int, usual_hop: float) -> Iterator[tuple[float, float]]:
    """The transport of each wind of some steps, in polls of a step times hops, and its direction.

    Of a series that starts over, whose steps are whole cycles, that of each row of one cycle.
    """
    wind = forcing.wind
    if steps > 1 and isinstance(wind, SeriesWind) and wind.repeat:
        polls, directions = wind.transport(forcing.clock)
        yield from zip((usual_hop * polls).tolist(), directions.tolist(), strict=True)
        return
    for _, count, intervals in forcing.constant_intervals(first, steps):
        for interval in intervals:
            hop = usual_hop if interval.hop_length is None else interval.hop_length
            yield count * interval.share * interval.strength * hop, interval.direction


def _whole(period: float) -> int:
    """Cycles, up to ten, that are nearest to a whole number of steps."""
    return min(range(1, 11), key=lambda count: (round(abs(period * count - round(period * count)), 3), count))
