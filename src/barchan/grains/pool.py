"""Slots that grains fly in: arrays of their motion and marks, and how they are kept together."""

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.kernels.grains.state import Grains

MOTION, MARKS = 8, 4
"""Quantities of a grain, as numbers and as whole numbers; see ``kernels.grain_state.Grains``."""

_SUNK = -1.0
"""Height (m) of free slots, as ``kernels.grain_state.SUNK``."""

_PAGE, _STAGGER = 1024, 80
"""Numbers in a page of memory, and by how many rows start apart within it."""


def free_slots(count: int) -> tuple[NDArray[np.float32], NDArray[np.int32]]:
    """Free slots: motion and marks.

    Rows start at different places of a memory page: a cache keeps few lines that start at the same one.
    """
    width = -(-count // _PAGE) * _PAGE + _STAGGER
    numbers = np.zeros((MOTION + MARKS, width), np.float32)[:, :count]
    motion, marks = numbers[:MOTION], numbers[MOTION:].view(np.int32)
    motion[2] = _SUNK
    return motion, marks


def grains_in(
    motion: NDArray[np.float32], marks: NDArray[np.int32], kinds: NDArray[np.int32] | None = None
) -> Any:
    """The grains in slots as the kernels take them."""
    return Grains(*motion, *marks)._replace(kind=kinds)


def close_gaps(quantities: Iterable[NDArray], held: NDArray[np.bool_], spare: int) -> int:
    """Move grains up to the first slots, in their order, where more than ``spare`` free ones lie between.

    ``held`` tells which slots hold one, ``quantities`` are what they hold. Returns how many slots it takes
    from the first one to the last grain.
    """
    full = np.flatnonzero(held)
    last = int(full[-1]) + 1 if full.size else 0
    if last <= full.size + spare:
        return last
    order = np.concatenate((full, np.flatnonzero(~held[:last])))
    for quantity in quantities:
        quantity[:last] = quantity[order]
    return full.size
