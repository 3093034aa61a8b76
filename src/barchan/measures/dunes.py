"""Single dunes: bodies of sand higher than the sand between them."""

from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import NDArray

from barchan.measures.filters import Field, Periodic, smoothed


@dataclass(frozen=True)
class Dune:
    """One body of sand. Its cells are numbered as if the field continued over periodic edges."""

    rows: NDArray[np.int64]
    columns: NDArray[np.int64]
    depth: Field
    """Depth of the sand (m) over each cell, smoothed, above the level that parts the dunes."""
    level: float = 0.0
    """Depth of the sand (m) at that level."""

    @property
    def height(self) -> float:
        """Its highest depth (m) above that level."""
        return float(self.depth.max())

    @property
    def cells(self) -> int:
        """How many cells it covers."""
        return len(self.rows)


def find_dunes(
    depth: NDArray,
    least: float,
    periodic: Periodic = (True, True),
    level: float | None = None,
    width: float = 2.0,
) -> list[Dune]:
    """Every body of sand deeper than ``level`` (m) that rises above it by ``least`` (m) or more.

    The depth of the sand (m) is smoothed over ``width`` cells; the level is its mean where none is given.
    Cells of NaN belong to no dune. Left out are ridges that run on without an end over joined edges, and
    dunes that an open edge cuts.
    """
    deep = smoothed(depth, width, periodic)
    known = np.isfinite(deep)
    if not known.any():
        return []
    parting = float(deep.mean(where=known)) if level is None else level
    above = deep - parting
    bodies = bodies_of(above > 0.0, periodic)
    found = []
    for rows, columns in _cells_of(bodies):
        high = above[rows, columns]
        if not high.max() >= least:
            continue
        north, east = (
            _unrolled(at, n, p) for at, n, p in zip((rows, columns), depth.shape, periodic, strict=True)
        )
        if north is not None and east is not None:
            found.append(Dune(north, east, high, parting))
    return found


def _cells_of(bodies: NDArray[np.int64]) -> list[tuple[NDArray[np.intp], NDArray[np.intp]]]:
    """Rows and columns of the cells of each body, in one pass over the field."""
    flat = bodies.ravel()
    cells = np.flatnonzero(flat)
    cells = cells[np.argsort(flat[cells], kind="stable")]
    starts = np.flatnonzero(np.diff(flat[cells])) + 1
    parts = np.split(cells, starts) if cells.size else []
    return [(part // bodies.shape[1], part % bodies.shape[1]) for part in parts]


def bodies_of(raised: NDArray[np.bool_], periodic: Periodic) -> NDArray[np.int64]:
    """Number of the body of each cell, counted from 1; bodies go on over joined edges.

    A margin repeats the cells beyond each joined edge; a cell and its copies belong to one body.
    """
    wide = raised
    for axis, joined in enumerate(periodic):
        margin = [(int(axis == other),) * 2 for other in (0, 1)]
        wide = np.pad(wide, margin, mode="wrap") if joined else np.pad(wide, margin)
    numbers, count = scipy.ndimage.label(wide, np.ones((3, 3)))
    joins = [(axis, copy, own) for axis in (0, 1) if periodic[axis] for copy, own in ((0, -2), (-1, 1))]
    empty = np.zeros((2, 0), np.int64)
    pairs = [np.stack([numbers.take(copy, axis), numbers.take(own, axis)]) for axis, copy, own in joins]
    first, last = np.concatenate([empty, *pairs], axis=1)
    links = scipy.sparse.coo_array((np.ones(len(first)), (first, last)), (count + 1, count + 1))
    _, bodies = scipy.sparse.csgraph.connected_components(links, directed=False)
    return bodies[numbers][1:-1, 1:-1].astype(np.int64)


def _unrolled(at: NDArray[np.intp], size: int, joined: bool) -> NDArray[np.int64] | None:
    """Places along an axis without the jump at a joined edge; None where a body has no end or is cut."""
    taken = np.zeros(size, bool)
    taken[at] = True
    if not joined:
        return None if taken[0] or taken[-1] else at.astype(np.int64)
    if taken.all():
        return None
    gap = int(np.argmin(taken))
    return (at - gap) % size + gap
