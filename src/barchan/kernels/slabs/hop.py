"""A slab on the wind: how far it hops and where it comes down.

Positions and hops are fixed-point numbers in the wind's frame, along and across the columns' axis; on a
hexagonal lattice as ``hexagons`` says.
"""

import numpy as np

from barchan.kernels.bed.state import DEVIATION, LEVEL_BITS, MEAN
from barchan.kernels.core.internal import internal
from barchan.kernels.slabs.hexagons import cell_after, position


@internal(forceinline=True)
def wrapped(place, size, wrap):
    """A fixed-point position brought back into the field, or -1 where it has left."""
    length = size << 32
    if place >= length:
        if not wrap:
            return -1
        place -= length
        if place >= length:  # hops longer than the field go round it
            place %= length
    if place < 0:
        if not wrap:
            return -1
        place += length
        if place < 0:
            place %= length
    return place


@internal(forceinline=True)
def after_hop(along, across, hop_along, hop_across, grid):
    """The position after a hop; negative where the slab has left the field."""
    if grid.hexagonal:
        row, col, beside, above = cell_after(along, across, hop_along, hop_across)
        return position(row, col, beside, above, grid)
    along = wrapped(along + hop_along, grid.cols, grid.wrap_along)
    if hop_across != 0:
        across = wrapped(across + hop_across, grid.rows, grid.wrap_across)
    return along, across


@internal(forceinline=True)
def hop_cells(height, levels, speedup):
    """Hop (cells, negative: against the wind) from a cell of this height."""
    deviation = speedup.deviation_weight * np.float64(levels.values[DEVIATION])
    reference = np.float64(levels.values[MEAN]) - deviation
    rise = np.float64(height) * speedup.slabs - reference * (1.0 / (1 << LEVEL_BITS))
    hop = speedup.base + speedup.linear * rise
    if rise > 0.0:
        hop += speedup.quadratic * rise * rise
    hop = min(max(hop, -speedup.longest), speedup.longest)
    return np.floor(hop + 0.5) if speedup.whole else hop


@internal(forceinline=True)
def fixed_hop(hop, unit):
    """A hop's part along an axis in 1/``CELL`` cells."""
    return np.int64(np.rint(hop * unit))
