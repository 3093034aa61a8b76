"""How far walls of ground are from each cell, kept from one call of the kernel to the next."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.slabs.arguments import SlabTables
from barchan.wind.frame import WindFrame

MOST_KEPT = 4
"""Winds whose ways are kept: winds that blow in turn need not be looked at anew each time."""


class Ways:
    """What stops slabs on their way over one ground, under the winds that came last."""

    def __init__(self) -> None:
        """Nothing known yet."""
        self._ground: NDArray[np.float64] | None = None
        self._known: dict[Any, NDArray[np.uint8]] = {}

    def path(
        self,
        ground: NDArray[np.float64],
        tables: SlabTables,
        frame: WindFrame,
        surface: NDArray,
        sand: NDArray[np.int32] | None,
    ) -> Any:
        """The tables' ``Path``, with addresses of what is known; they hold until this is asked again.

        ``surface`` and ``sand`` lie flat in the wind's frame.
        """
        if tables.path is None or tables.path.sand:
            return tables.path
        if self._ground is None or not np.array_equal(self._ground, ground):
            self._ground = ground.copy()
            self._known.clear()
        turn = int(np.sign(frame.angle))
        key = frame.turns, turn, tables.repose, tables.speedup is not None
        if key not in self._known:
            if len(self._known) == MOST_KEPT:
                self._known.clear()
            self._known[key] = _look(tables, turn, surface, sand)
        ahead, back = (way.ctypes.data for way in self._known[key])
        return tables.path._replace(clear=ahead, clear_back=back)


def _look(
    tables: SlabTables, turn: int, surface: NDArray, sand: NDArray[np.int32] | None
) -> NDArray[np.uint8]:
    """How many cells are clear with the wind and, where hops may go against it, last cell first, back."""
    from barchan.kernels.slabs.obstacles import clear_way

    ways = np.empty((2, surface.size), np.uint8)
    for way, order in ((0, 1), (1, -1)) if tables.speedup else ((0, 1),):
        turned = np.ascontiguousarray(surface[::order])
        slabs = None if sand is None else np.ascontiguousarray(sand[::order])
        clear_way(turned, slabs, turn, tables.grid, tables.repose, ways[way])
    return ways
