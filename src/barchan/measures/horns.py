"""The horns of barchans."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from barchan.directions import downwind
from barchan.measures.dunes import Dune

STRIP = 2.0
"""Width (cells) of the strips along the wind in which a dune's downwind edge is sought."""


@dataclass(frozen=True)
class Horns:
    """A dune seen along the wind, in metres."""

    left: float
    """How far the left quarter of its downwind edge, as one looks downwind, lies beyond the middle half."""
    right: float
    """The same of the right quarter; negative where the edge stays back."""
    width: float
    """Extent across the wind."""
    length: float
    """Extent along the wind."""

    @property
    def crescent(self) -> float:
        """How far the sides reach beyond the middle, over the width: positive for a barchan."""
        return (self.left + self.right) / (2.0 * self.width)

    @property
    def slant(self) -> float:
        """How much farther the left side reaches than the right, over the width."""
        return (self.left - self.right) / self.width


def horns(dune: Dune, direction: float, cell_size: float) -> Horns:
    """The horns of a dune in a wind from ``direction`` (degrees).

    The dune is cut into strips along the wind, and in each its downwind edge is found. The mean edge of the
    outer quarter to each side, less that of the middle half, is positive for the horns of a barchan, zero for
    a straight ridge across the wind and negative for a round dune.
    """
    x, y = downwind(direction)
    along = dune.columns * x + dune.rows * y
    leftward = dune.rows * x - dune.columns * y
    width = float(np.ptp(leftward) + 1.0)
    edges, share = _downwind_edges(along, (leftward - leftward.min() + 0.5) / width, width)
    middle = edges[np.abs(share - 0.5) <= 0.25].mean()
    return Horns(
        left=float(edges[share > 0.75].mean() - middle) * cell_size,
        right=float(edges[share < 0.25].mean() - middle) * cell_size,
        width=width * cell_size,
        length=float(np.ptp(along) + 1.0) * cell_size,
    )


def _downwind_edges(along: NDArray, share: NDArray, width: float) -> tuple[NDArray, NDArray]:
    """The farthest place downwind in each strip, and where it is as a share of the width from the right.

    A strip without a cell, as oblique strips of slender dunes may be, lies between its neighbours.
    """
    count = max(int(width / STRIP), 4)
    strip = np.minimum((share * count).astype(np.int64), count - 1)
    edges = np.full(count, -np.inf)
    np.maximum.at(edges, strip, along)
    places = (np.arange(count) + 0.5) / count
    taken = np.isfinite(edges)
    return np.interp(places, places[taken], edges[taken]), places
