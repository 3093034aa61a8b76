"""Crest lines: where they run, how long they are, how often they end, how much their directions differ."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from barchan.measures.crest_cells import crest_cells
from barchan.measures.crest_tracing import Chain, chains
from barchan.measures.filters import Field, Periodic

SHORTEST = 8.0
"""Crest lines of fewer cells, and side branches of fewer, are left out; ours."""

CHORD = 4
"""Cells over which the direction of a crest is taken."""


@dataclass(frozen=True)
class CrestLine:
    """One crest from an end or a fork to the next, in cells from the centre of the south-western cell."""

    rows: Field
    columns: Field
    """Places along it, as if the field continued over joined edges."""
    ends: int
    """How many of its two ends (0 to 2) lie in the field: neither at a fork nor at an open edge or a void."""

    @property
    def length(self) -> float:
        """Length along the line (cells)."""
        return float(np.hypot(np.diff(self.rows), np.diff(self.columns)).sum())

    @property
    def azimuth(self) -> float:
        """Mean direction (degrees clockwise from north, in [0, 180)), its parts weighted by their length."""
        return mean_direction([self])[0]


def crest_lines(
    elevation: NDArray,
    periodic: Periodic = (True, True),
    width: float = 2.0,
    reach: float = 16.0,
    shortest: float = SHORTEST,
) -> list[CrestLine]:
    """The crest lines of a surface smoothed over ``width`` cells, the longest first.

    Crests lie above the mean of the ``2 reach + 1`` cells about them to either side; half of the spacing is a
    good ``reach``. Lines shorter than ``shortest`` (cells) are left out, and so are side branches.
    """
    cells, north, east = crest_cells(elevation, periodic, width, reach)
    unknown = ~np.isfinite(np.asarray(elevation, float))
    found = chains(cells, periodic)
    branches = [c for c in found if c.length < shortest and sum(c.ends) == 1]
    if branches:
        found = chains(_without(cells, branches), periodic)
    lines = [
        _line(chain, north, east, unknown, periodic)
        for chain in found
        if sum(chain.ends) < 2 or chain.length >= shortest
    ]
    return sorted(lines, key=lambda line: -line.length)


def _without(cells: NDArray[np.bool_], branches: Sequence[Chain]) -> NDArray[np.bool_]:
    """The mask without side branches; the forks that they leave from stay."""
    left = cells.copy()
    for branch in branches:
        kept = slice(None, -1) if branch.ends[0] else slice(1, None)
        left[branch.rows[kept] % cells.shape[0], branch.columns[kept] % cells.shape[1]] = False
    return left


def _line(
    chain: Chain, north: Field, east: Field, unknown: NDArray[np.bool_], periodic: Periodic
) -> CrestLine:
    at = chain.rows % north.shape[0], chain.columns % north.shape[1]
    ends = sum(
        end and not _at_rim(chain.rows[place], chain.columns[place], unknown, periodic)
        for end, place in zip(chain.ends, (0, -1), strict=True)
    )
    return CrestLine(chain.rows + north[at], chain.columns + east[at], ends)


def _at_rim(row: int, column: int, unknown: NDArray[np.bool_], periodic: Periodic) -> bool:
    """Whether a crest goes on out of sight: an open edge or a void lies within four cells of its end."""
    near = []
    for at, size, joined in zip((row, column), unknown.shape, periodic, strict=True):
        places = np.arange(at - CHORD, at + CHORD + 1)
        if not joined and (places[0] < 0 or places[-1] >= size):
            return True
        near.append(places % size)
    return bool(unknown[np.ix_(near[0], near[1])].any())


def crest_length(lines: Sequence[CrestLine]) -> float:
    """Length (cells) of all lines together."""
    return sum(line.length for line in lines)


def defect_density(lines: Sequence[CrestLine], cell_size: float) -> float:
    """Ends of crests per length of crest (1/m); NaN where there is no crest."""
    length = crest_length(lines) * cell_size
    return sum(line.ends for line in lines) / length if length else float("nan")


def mean_direction(lines: Sequence[CrestLine]) -> tuple[float, float]:
    """Mean direction of crests (degrees clockwise from north, in [0, 180)) and its spread (degrees).

    Directions over four cells each, weighted by length, are axes: their angles are doubled, and the spread is
    half of the circular standard deviation sqrt(-2 ln R) of the doubled angles, R the length of their mean
    vector (Mardia and Jupp 2000). Both NaN without a crest; the direction is NaN where all cancel.
    """
    total, length = 0.0 + 0.0j, 0.0
    for line in lines:
        chord = max(min(CHORD, len(line.rows) - 1), 1)
        rows, columns = (at[chord:] - at[:-chord] for at in (line.rows, line.columns))
        size = np.hypot(rows, columns)
        total += complex((size * np.exp(2j * np.arctan2(columns, rows))).sum()) / chord
        length += float(size.sum()) / chord
    if not length:
        return float("nan"), float("nan")
    resultant = min(abs(total) / length, 1.0)
    if resultant < 1e-9:
        return float("nan"), float("inf")
    azimuth = float(np.degrees(np.angle(total)) / 2 % 180.0 % 180.0)
    return azimuth, float(np.degrees(np.sqrt(-2 * np.log(resultant))) / 2)
