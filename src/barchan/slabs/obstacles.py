"""Distances to walls of ground, kept from one call of the kernel to the next."""

from collections.abc import Hashable

import numpy as np
from numpy.typing import NDArray

from barchan.kernels.bed.state import Stacks
from barchan.kernels.slabs.state import ObstacleRule, SlabRules
from barchan.wind.frame import WindFrame

MOST_KEPT = 4
"""Winds whose distances are kept: winds that alternate need no new search each time."""


class ClearDistances:
    """Cells that a slab may pass before ground can stop it, on one ground under the most recent winds."""

    def __init__(self) -> None:
        """Start without any distances."""
        self._ground: NDArray[np.float64] | None = None
        self._known: dict[Hashable, NDArray[np.uint8]] = {}

    def obstacles(
        self, ground: NDArray[np.float64], rules: SlabRules, frame: WindFrame, stacks: Stacks
    ) -> ObstacleRule | None:
        """The obstacle rule with the addresses of the distances, which hold until the next call.

        The ``stacks`` lie flat in the wind's frame. Among hexagons each hop is looked at cell by cell.
        """
        if rules.obstacles is None or rules.obstacles.sand or rules.grid.hexagonal:
            return rules.obstacles
        if self._ground is None or not np.array_equal(self._ground, ground):
            self._ground = ground.copy()
            self._known.clear()
        side = int(np.sign(frame.angle))
        key = frame.turns, side, rules.repose, rules.speedup is not None
        if key not in self._known:
            if len(self._known) == MOST_KEPT:
                self._known.clear()
            self._known[key] = _measure(rules, side, stacks)
        ahead, back = (distances.ctypes.data for distances in self._known[key])
        return rules.obstacles._replace(clear=ahead, clear_back=back)


def _measure(rules: SlabRules, side: int, stacks: Stacks) -> NDArray[np.uint8]:
    """Clear distances with the wind and, where hops may go against it, against it (last cell first)."""
    from barchan.kernels.slabs.obstacles import clear_distance

    distances = np.empty((2, stacks.surface.size), np.uint8)
    for row, order in ((0, 1), (1, -1)) if rules.speedup else ((0, 1),):
        surface = np.ascontiguousarray(stacks.surface[::order])
        sand = None if stacks.sand is None else np.ascontiguousarray(stacks.sand[::order])
        clear_distance(surface, sand, side, rules.grid, rules.repose, distances[row])
    return distances
