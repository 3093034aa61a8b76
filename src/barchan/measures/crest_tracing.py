"""Cells of thin lines put in order: from one end or fork to the next."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from barchan.measures.filters import Periodic

_STEPS = ((1, 0), (0, 1), (1, 1), (1, -1))
"""Steps to half of the neighbours (rows, columns), those over an edge first."""


@dataclass(frozen=True)
class Chain:
    """Cells of a line in order, numbered as if the field continued over joined edges."""

    rows: NDArray[np.int64]
    columns: NDArray[np.int64]
    ends: tuple[bool, bool]
    """Whether its first cell and its last are ends of a line: no fork, no ring, nothing beyond them."""

    @property
    def length(self) -> float:
        """From centre to centre (cells)."""
        return float(np.hypot(np.diff(self.rows), np.diff(self.columns)).sum())


def chains(lines: NDArray[np.bool_], periodic: Periodic) -> list[Chain]:
    """The lines of a thin mask, cut at forks. Cells without a neighbour are left out."""
    links = _Links(lines, periodic)
    degree = np.array([len(near) for near in links.near])
    found = []
    used: set[tuple[int, int]] = set()
    starts = [*np.flatnonzero((degree > 0) & (degree != 2)).tolist(), *np.flatnonzero(degree == 2).tolist()]
    for start in starts:
        for first, (there, _, _) in enumerate(links.near[start]):
            if (start, there) not in used:
                found.append(links.walk(start, first, degree, used))
    return found


class _Links:
    """Which cells of a mask are next to which, and the steps (rows, columns) between them."""

    def __init__(self, lines: NDArray[np.bool_], periodic: Periodic) -> None:
        self.rows, self.columns = np.nonzero(lines)
        number = np.full(lines.shape, -1)
        number[self.rows, self.columns] = np.arange(len(self.rows))
        self.near: list[list[tuple[int, int, int]]] = [[] for _ in self.rows]
        shape = lines.shape
        for down, right in _STEPS:
            there, inside = [], np.ones(len(self.rows), bool)
            for at, step, size, joined in zip(
                (self.rows, self.columns), (down, right), shape, periodic, strict=True
            ):
                beyond = at + step
                inside &= joined or ((beyond >= 0) & (beyond < size))
                there.append(beyond % size)
            inside &= number[there[0], there[1]] >= 0
            if down and right:  # cells that share a neighbour over an edge are linked by that one
                inside &= (number[self.rows, there[1]] < 0) & (number[there[0], self.columns] < 0)
            for one in np.flatnonzero(inside).tolist():
                other = int(number[there[0][one], there[1][one]])
                self.near[one].append((other, down, right))
                self.near[other].append((one, -down, -right))

    def walk(self, start: int, first: int, degree: NDArray, used: set[tuple[int, int]]) -> Chain:
        """The line from a cell by way of one of its neighbours to the next end or fork, or back to itself."""
        row, column = int(self.rows[start]), int(self.columns[start])
        rows, columns = [row], [column]
        here, step = start, self.near[start][first]
        while True:
            there, down, right = step
            used.add((here, there))
            used.add((there, here))
            row, column = row + down, column + right
            rows.append(row)
            columns.append(column)
            if there == start or degree[there] != 2:
                ends = (bool(degree[start] == 1), bool(degree[there] == 1))
                return Chain(np.array(rows), np.array(columns), ends)
            one, other = self.near[there]
            here, step = there, other if one[0] == here else one
