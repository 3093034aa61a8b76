"""The heights of a bed as slab kernels read and change them: flat arrays in the wind's frame."""

import numpy as np
from numpy.typing import DTypeLike, NDArray

from barchan.bed import Bed
from barchan.heights import FRACTION_BITS, above_lowest
from barchan.kernels.bed.state import Stacks
from barchan.kernels.core.state import SIMD_WIDTH
from barchan.kernels.slabs.state import MOBILE
from barchan.wind.frame import WindFrame

_MOST_MOBILE = 2**30
"""Bound of mobilities in whole numbers, so that chances in proportion to them do not overflow."""


def is_flat(ground: NDArray[np.float64]) -> bool:
    """Whether the ground has one height everywhere."""
    return bool((ground == ground.flat[0]).all())


def stacks_of(bed: Bed, frame: WindFrame, mobility: NDArray[np.float64] | None) -> Stacks:
    """The bed's stacks in the wind's frame; the surface has room before it for the shadow test.

    Over flat ground the surface is the number of slabs; elsewhere it is the elevation above the lowest
    ground, in fractions of a slab (``barchan.heights``), beside the number of slabs.
    """
    mobile = None
    if mobility is not None:
        whole = np.clip(np.rint(mobility * MOBILE), -_MOST_MOBILE, _MOST_MOBILE).astype(np.int32)
        mobile = np.ascontiguousarray(frame.enter(whole)).ravel()
    sand = frame.enter(bed.sand)
    if is_flat(bed.ground):
        return Stacks(_with_room(sand, np.int32), None, mobile)
    surface = frame.enter(above_lowest(bed.ground, bed.lattice.thickness))
    surface = surface + (sand.astype(np.int64) << FRACTION_BITS)
    sand = np.ascontiguousarray(sand).ravel().copy()
    return Stacks(_with_room(surface, np.int64), sand, mobile)


def write_back(bed: Bed, frame: WindFrame, stacks: Stacks) -> None:
    """Take the numbers of slabs of the stacks over into the bed."""
    sand = stacks.surface if stacks.sand is None else stacks.sand
    bed.sand[...] = frame.leave(sand.reshape(frame.enter(bed.sand).shape))


def _with_room(field: NDArray, dtype: DTypeLike) -> NDArray:
    """A flat copy of a field with as much memory before it as one vector read may touch."""
    buffer = np.zeros(SIMD_WIDTH + field.size, dtype)
    buffer[SIMD_WIDTH:] = field.ravel()
    return buffer[SIMD_WIDTH:]
