"""Cells without a height: those a user marks, and those that look like a mark that is not declared.

A code such as −9999 that is read as a height becomes ground ten kilometres deep. So a value is suspect where
it is one of the codes in use, lies beyond any height, or is the lowest or highest of the file and set off
from all of its neighbours by a step that no slope in the file comes near.
"""

import numpy as np
from numpy.typing import NDArray

from barchan.ground.terrain import HIGHEST
from barchan.missing import marked

CODES = (-9999.0, -9999.9, -99999.0, -32768.0, -32767.0, 9999.0, 32767.0, 99999.0)
"""Codes for missing heights within the range of heights; beyond that range every number is one."""

STEEPEST = 20.0
"""Cells' widths that a step to every neighbour must exceed to set a value off."""

SETS_OFF = 3.0
"""Multiple of the file's other steps that it must exceed as well."""


def suspects(values: NDArray[np.float64], metres: float, cell: float) -> list[tuple[float, int]]:
    """Values that look like a code for missing cells, each with the number of its cells.

    ``values`` are the file's numbers, each worth so many ``metres``; ``cell`` is the width of a cell (m).
    """
    known = np.isfinite(values)
    codes = marked(values, list(CODES)) | (known & (np.abs(values * metres) > HIGHEST))
    found = [(float(v), int(n)) for v, n in zip(*np.unique(values[codes], return_counts=True), strict=True)]
    rest = np.where(codes | ~known, np.nan, values)
    if np.isnan(rest).all():
        return found
    for end in (np.nanmin(rest), np.nanmax(rest)):
        here = rest == end
        if _set_off(rest * metres, here, cell):
            found.append((float(end), int(here.sum())))
    return found


def _set_off(heights: NDArray[np.float64], here: NDArray[np.bool_], cell: float) -> bool:
    """Whether each step (m) between these cells and others is far beyond all steps among the others."""
    border, inside = [], []
    for first, second in (((slice(1, None),), (slice(None, -1),)), (_ALL_BUT_FIRST, _ALL_BUT_LAST)):
        step = np.abs(heights[first] - heights[second])
        apart = here[first] != here[second]
        among = ~here[first] & ~here[second]
        border.append(step[apart & np.isfinite(step)])
        inside.append(step[among & np.isfinite(step)])
    around = np.concatenate(border)
    if not around.size:
        return False
    steepest = max(float(np.concatenate(inside).max(initial=0.0)), cell)
    return bool(around.min() > max(STEEPEST * cell, SETS_OFF * steepest))


_ALL_BUT_FIRST = (slice(None), slice(1, None))
_ALL_BUT_LAST = (slice(None), slice(None, -1))


def filled(heights: NDArray[np.float64], holes: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Each hole's cells set to the mean of their four neighbours: a membrane over the hole's rim."""
    from scipy.sparse import coo_array
    from scipy.sparse.linalg import spsolve

    number = np.full(holes.shape, -1)
    number[holes] = np.arange(holes.sum())
    count = int(holes.sum())
    rows, cols, weights = [], [], []
    diagonal, known = np.zeros(count), np.zeros(count)
    for here, there in _neighbours():
        cell, neighbour = number[here], number[there]
        inner, rim = (cell >= 0) & (neighbour >= 0), (cell >= 0) & (neighbour < 0)
        np.add.at(diagonal, cell[cell >= 0], 1.0)
        np.add.at(known, cell[rim], heights[there][rim])
        rows.append(cell[inner])
        cols.append(neighbour[inner])
        weights.append(np.full(inner.sum(), -1.0))
    rows.append(np.arange(count))
    cols.append(np.arange(count))
    weights.append(diagonal)
    places = (np.concatenate(rows), np.concatenate(cols))
    matrix = coo_array((np.concatenate(weights), places), shape=(count, count)).tocsc()
    whole = heights.copy()
    whole[holes] = spsolve(matrix, known)
    return whole


def _neighbours() -> list[tuple[tuple[slice, slice], tuple[slice, slice]]]:
    """The cells of an array that have a neighbour on one side, and those neighbours, for each side."""
    every, first, last = slice(None), slice(None, -1), slice(1, None)
    return [
        ((first, every), (last, every)),
        ((last, every), (first, every)),
        ((every, first), (every, last)),
        ((every, last), (every, first)),
    ]
