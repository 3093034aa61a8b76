"""The section along a line at every kept state of a run."""

import base64
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.errors import BarchanError
from barchan.fields import GROUND, LayerInfo, count_names, depth_of
from barchan.lattice import Lattice
from barchan.simulation import Simulation, State
from barchan.squares import Squares
from barchan.studio.worker.background import Count
from barchan.studio.worker.run import StudioRun, states_of

COLUMNS = 512
"""Places along the line."""

_LARGEST = np.iinfo(np.uint16).max


@dataclass(frozen=True)
class Diagram:
    """Elevations along a line at kept states."""

    steps: list[int]
    seconds: list[float] | None
    """Moments of the states, where steps have a duration."""
    distance: NDArray[np.float64]
    """Metres from the line's beginning to each place."""
    heights: NDArray[np.float64]
    """Elevation (m) by state and place."""


def diagram_of(states: Sequence[State], line: list[float], count: Count = lambda _done, _of: None) -> Diagram:
    """The elevations of states along a line from x, y to x, y (m).

    Raises BarchanError where that is no line.
    """
    if len(line) != 4 or not np.isfinite(line).all():
        raise BarchanError("a section needs two places: x, y, x, y in metres")
    last = Simulation.from_state(states[-1])
    sampler = _Sampler(last.lattice, last.bed.layers, line)
    rows = []
    for number, state in enumerate(states):
        rows.append(sampler.section(state))
        count(number + 1, len(states) + 1)
    steps, length = [state.step for state in states], np.hypot(line[2] - line[0], line[3] - line[1])
    each = last.scenario.step_seconds
    seconds = None if each is None else [each * step for step in steps]
    return Diagram(steps, seconds, np.linspace(0.0, float(length), COLUMNS), np.array(rows))


def space_time(run: StudioRun, line: list[float]) -> dict[str, Any]:
    """Elevations along a line, a row for each kept state, as 16 bits between two heights.

    Raises BarchanError where that is no line.
    """
    found = diagram_of(states_of(run), line)
    heights = found.heights
    low, high = float(heights.min()), float(heights.max())
    scale = (high - low) / _LARGEST or 1.0
    numbers = np.rint((heights - low) / scale).astype("<u2")
    return {
        "steps": found.steps,
        "columns": COLUMNS,
        "low": low,
        "scale": scale,
        "values": base64.b64encode(numbers.tobytes()).decode(),
    }


class _Sampler:
    """Places along a line, and the four cells about each with their weights."""

    def __init__(self, lattice: Lattice, layers: tuple[LayerInfo, ...], line: list[float]) -> None:
        x0, y0, x1, y1 = line
        self._squares = Squares(lattice)
        lattice = self._squares.lattice
        share = np.linspace(0.0, 1.0, COLUMNS)
        self._thickness, self._layers = lattice.thickness, layers
        rows, v = _between((y0 + share * (y1 - y0)) / lattice.cell_size, lattice.rows)
        columns, u = _between((x0 + share * (x1 - x0)) / lattice.cell_size, lattice.columns)
        self._cells = rows[:, None, :], columns[None, :, :]
        self._weights = v[:, None, :] * u[None, :, :]

    def section(self, state: State) -> NDArray[np.float64]:
        """Elevation (m) at each place."""
        names = (GROUND.name, *count_names(self._layers))
        arrays = {name: state.arrays[f"bed/{name}"] for name in names}
        if self._squares.true.hexagonal:
            arrays = {name: self._squares.between(one.astype(np.float64)) for name, one in arrays.items()}
        here = {name: one[self._cells] for name, one in arrays.items()}
        elevation = here[GROUND.name] + depth_of(self._layers, here, self._thickness)
        heights: NDArray[np.float64] = (elevation * self._weights).sum(axis=(0, 1))
        return heights


def _between(place: NDArray[np.float64], count: int) -> tuple[NDArray[np.intp], NDArray[np.float64]]:
    """The two cells about each place (counted in cells from an edge), and the weight of each."""
    at = np.clip(place - 0.5, 0.0, count - 1.0)
    first = np.floor(at).astype(np.intp)
    share = at - first
    return np.stack([first, np.minimum(first + 1, count - 1)]), np.stack([1.0 - share, share])
