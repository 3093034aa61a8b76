"""The arms of parabolic dunes."""

from dataclasses import dataclass

import numpy as np

from barchan.directions import downwind
from barchan.measures.dunes import Dune

STRIP = 2.0
"""Width (cells) of the strips along the wind in which a dune's upwind edge is sought."""


@dataclass(frozen=True)
class Arms:
    """The limbs of a dune that point upwind, in metres."""

    left: float
    """How far the left third of its upwind edge, as one looks downwind, reaches beyond the middle third."""
    right: float
    """The same of the right third; negative where the edge stays back."""
    width: float
    """Extent across the wind."""

    @property
    def ratio(self) -> float:
        """Length of the shorter arm over the width: a hairpin has at least 1/2, a dune without arms none."""
        return min(self.left, self.right) / self.width


def arms(dune: Dune, direction: float, cell_size: float) -> Arms:
    """The arms of a dune in a wind from ``direction`` (degrees).

    The dune is cut into strips along the wind, and in each its upwind edge is found. The farthest edge
    in the outer third to each side, less the median edge of the middle third, is the length of an arm. It is
    negative for a barchan, whose middle reaches farthest upwind.
    """
    x, y = downwind(direction)
    upwind = -(dune.columns * x + dune.rows * y)
    leftward = dune.rows * x - dune.columns * y
    width = float(np.ptp(leftward) + 1.0)
    share = (leftward - leftward.min() + 0.5) / width
    count = max(int(width / STRIP), 3)
    strip = np.minimum((share * count).astype(np.int64), count - 1)
    edges = np.full(count, -np.inf)
    np.maximum.at(edges, strip, upwind)
    place = (np.arange(count) + 0.5) / count
    hollow = float(np.median(edges[np.abs(place - 0.5) <= 1 / 6]))
    return Arms(
        left=(float(edges[place > 2 / 3].max()) - hollow) * cell_size,
        right=(float(edges[place < 1 / 3].max()) - hollow) * cell_size,
        width=width * cell_size,
    )
