"""From the counts of a kernel to a tally."""

import numpy as np
from numpy.typing import NDArray

from barchan.kernels.core.state import TRAVEL_UNIT
from barchan.kernels.slabs.state import (
    CAPPED,
    ENTERED,
    EXHAUSTED,
    LEFT,
    MOVED,
    TRAVEL_ACROSS,
    TRAVEL_ALONG,
)
from barchan.model import Tally
from barchan.wind.frame import WindFrame
from barchan.wind.segment import Segment


def tally_of(counts: NDArray[np.int64], segment: Segment, frame: WindFrame, across: float = 1.0) -> Tally:
    """What happened in a segment, by the counts that its kernel made in the wind's frame.

    The kernel counts distances along in cells and those across in units of ``across`` cells.
    """
    travel = counts[TRAVEL_ALONG] / TRAVEL_UNIT, counts[TRAVEL_ACROSS] / TRAVEL_UNIT * across
    travel_x, travel_y = frame.to_map(*travel)
    return Tally(
        steps=segment.steps,
        polls=segment.steps * segment.polls,
        moved=int(counts[MOVED]),
        left=int(counts[LEFT]),
        capped=int(counts[CAPPED]),
        travel_x=float(travel_x),
        travel_y=float(travel_y),
        entered=int(counts[ENTERED]),
        exhausted=int(counts[EXHAUSTED]),
    )
