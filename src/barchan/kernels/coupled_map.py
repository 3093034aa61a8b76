"""Nishimori & Ouchi's two maps, in whole parcels: hops and creep, all cells at once."""

import numpy as np
from numba import njit

from barchan.kernels.core.random import derive, draw
from barchan.kernels.core.state import TRAVEL_UNIT

HOP, CREEP = range(2)
"""Numbers of the random sequences of a step."""

FACE, CORNER = 1.0 / 6.0, 1.0 / 12.0

__all__ = ["CREEP", "HOP", "TRAVEL_UNIT", "creep", "hop"]


@njit(cache=True, error_model="numpy")
def _rounded(number, part):
    """A number rounded up or down, so that it is right in the mean over parts of 1."""
    return np.int64(np.floor(number + part))


@njit(cache=True, error_model="numpy")
def hop(sand, hops_x, hops_y, share, key, joined_y, joined_x, counts):
    """Let every cell give ``share`` parcels (a real number), as far as it has them, over its own hop (cells).

    ``work_unit`` takes the parcels moved and left, and their travel eastwards and northwards.
    """
    rows, cols = sand.shape
    landed = np.zeros(sand.shape, np.int64)
    for row in range(rows):
        for col in range(cols):
            start = derive(key, row * cols + col)
            parcels = min(_rounded(share, draw(start, 1)), np.int64(sand[row, col]))
            step_x = _rounded(hops_x[row, col], draw(start, 2))
            step_y = _rounded(hops_y[row, col], draw(start, 3))
            r, c = row + step_y, col + step_x
            sand[row, col] -= parcels
            counts[0] += parcels
            counts[2] += parcels * step_x * TRAVEL_UNIT
            counts[3] += parcels * step_y * TRAVEL_UNIT
            inside = (joined_y or 0 <= r < rows) and (joined_x or 0 <= c < cols)
            if inside:
                landed[r % rows, c % cols] += parcels
            else:
                counts[1] += parcels
    for row in range(rows):
        for col in range(cols):
            sand[row, col] += landed[row, col]


@njit(cache=True, error_model="numpy")
def _exchange(surface, sand, here, there, share, part):
    """Let sand creep down between two cells; how many parcels did."""
    flow = _rounded(share * (surface[here] - surface[there]), part)
    flow = min(max(flow, -np.int64(sand[there])), np.int64(sand[here]))
    sand[here] -= flow
    sand[there] += flow
    return abs(flow)


@njit(cache=True, error_model="numpy")
def creep(surface, sand, share, key, joined_y, joined_x):
    """Let every pair of neighbours exchange its share of their difference on ``surface`` (parcels).

    Each pair once, from the southwest on; returns how many parcels crept.
    """
    rows, cols = surface.shape
    crept = 0
    if share == 0.0:
        return crept
    for row in range(rows):
        for col in range(cols):
            start = derive(key, row * cols + col)
            for way in range(4):
                r = row + (1 if way else 0)
                c = col + (1, 0, 1, -1)[way]
                if (r == rows and not joined_y) or (not 0 <= c < cols and not joined_x):
                    continue
                weight = share * (FACE if way < 2 else CORNER)
                there = (r % rows, c % cols)
                crept += _exchange(surface, sand, (row, col), there, weight, draw(start, way + 1))
    return crept
