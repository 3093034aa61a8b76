"""How long slopes slide before a run begins, estimated on a coarse copy of its bed."""

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Bed
from barchan.model import Model

SLIDES_PER_SECOND = 3e7
"""Slabs that slide by a cell in a second: 12 to 65 million, measured on blocks 300 to 4500 slabs high."""

_COARSE_CELLS = 48
"""The coarse copy has at most twice as many rows or columns."""

_SWEEPS = 2000

_SHARE = 0.2
"""Share of the excess of a step that slides to one of four neighbours in a sweep."""

_AT_REST = 0.02
"""A step stands that is higher than allowed by no more than this share."""


def settling_seconds(model: Model, bed: Bed) -> float:
    """Time (s) that the slopes of a first bed slide until all stand, within a factor of about three."""
    limits = model.slope_limits()
    if not limits:
        return 0.0
    sand = bed.stack.astype(np.float64)
    height = bed.ground / bed.lattice.thickness + sand
    allowed = min(kind[0] for kind in limits.values())
    return expected_slides(height, sand, allowed, bed.lattice.periodic) / SLIDES_PER_SECOND


def expected_slides(
    height: NDArray[np.float64], sand: NDArray[np.float64], allowed: float, periodic: tuple[bool, bool]
) -> float:
    """Slabs that slide, times the cells they slide over, until no step between neighbours is too high.

    ``height`` and ``sand`` are in slabs, ``allowed`` is the highest step that stands. The means of blocks of
    cells exchange sand in proportion to the excess of their slopes; what crosses a border between blocks has
    slid over a block's width.
    """
    width = max(1, *(size // _COARSE_CELLS for size in height.shape))
    surface, mobile = _means(height, width), _means(sand, width)
    allowed *= width
    slid = 0.0
    for _ in range(_SWEEPS):
        flows = [_flow(surface, mobile, allowed, axis, joined) for axis, joined in enumerate(periodic)]
        if max(np.abs(flow).max() for flow in flows) <= _AT_REST * _SHARE * allowed:
            break
        slid += sum(float(np.abs(flow).sum()) for flow in flows)
        change = sum(np.roll(flow, 1, axis) - flow for axis, flow in enumerate(flows))
        surface, mobile = surface + change, mobile + change
    return slid * width**3


def _means(field: NDArray[np.float64], width: int) -> NDArray[np.float64]:
    rows, cols = (size // min(width, size) for size in field.shape)
    high, wide = (min(width, size) for size in field.shape)
    blocks = field[: rows * high, : cols * wide].reshape(rows, high, cols, wide)
    return np.asarray(blocks.mean(axis=(1, 3)))


def _flow(
    surface: NDArray[np.float64], mobile: NDArray[np.float64], allowed: float, axis: int, joined: bool
) -> NDArray[np.float64]:
    """Slabs that slide from each block to the next along an axis; negative: from the next to it."""
    step = surface - np.roll(surface, -1, axis)
    excess = np.sign(step) * np.maximum(np.abs(step) - allowed, 0.0)
    there = _SHARE * np.where(step > 0, mobile, np.roll(mobile, -1, axis))
    flow = np.clip(_SHARE * excess, -there, there)
    if not joined:
        flow[(slice(None),) * axis + (-1,)] = 0.0
    return np.asarray(flow)
