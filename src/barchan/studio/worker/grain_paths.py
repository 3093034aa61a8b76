"""Paths of grains as frames carry them to the browser, computed so seldom that they cost little."""

import numpy as np
from numpy.typing import NDArray

from barchan.analysis.grain_paths import broken_at_edges, follows_grains, paths_over
from barchan.lattice import Lattice
from barchan.simulation import Simulation
from barchan.studio.worker.time_budget import TimeBudget

MOST = 500
"""Most paths that may be asked for."""

SHARE = 0.04
"""Share of the time that may go into paths."""

POINTS = 150
"""Points of a path that are sent, about."""

_DIGITS = 3
"""Decimal places, of cells, that are sent."""

Line = list[float]


class GrainPaths:
    """The paths of some grains over the bed that is looked at."""

    def __init__(self) -> None:
        """No grain is followed yet."""
        self.count = 0
        self.budget = TimeBudget(SHARE)
        self._sent: tuple[int, ...] | None = None

    def request(self, count: int) -> None:
        """Follow ``count`` grains from now on."""
        self.count = min(max(count, 0), MOST)
        self.resend()

    def resend(self) -> None:
        """Let the paths that were sent count as not sent."""
        self._sent = None
        self.budget.at_once()

    def wanted_over(self, simulation: Simulation) -> bool:
        """Whether other paths than those that were sent are to be shown."""
        return self._sent != self._key(simulation)

    def over(self, simulation: Simulation) -> list[Line]:
        """Lines through x, y and z (m) of each point after the other."""
        self._sent = self._key(simulation)
        if not self.count:
            return []
        with self.budget.spending():
            wind, seed = simulation.last_segment, simulation.scenario.seed
            paths = paths_over(simulation.model, simulation.bed, wind, seed, self.count)
            lowest = float(simulation.bed.ground.min())
            return [line for path in paths for line in _lines(path, lowest, simulation.lattice)]

    def _key(self, simulation: Simulation) -> tuple[int, ...]:
        if not self.count or not follows_grains(simulation.model):
            return ()
        return id(simulation), simulation.steps_done, len(simulation.events), self.count


def _lines(path: NDArray[np.float64], lowest: float, lattice: Lattice) -> list[Line]:
    """A path in pieces that cross no edge, its last point and those of bounces always kept."""
    wanted = np.arange(len(path)) % (1 + len(path) // POINTS) == 0
    wanted[:-1] |= np.diff(path[:, -1]) != 0
    wanted[1:] |= np.diff(path[:, -1]) != 0
    wanted[-1] = True
    size = lattice.cell_size
    broken = broken_at_edges(path[wanted], lattice.columns * size, lattice.rows * size)
    broken[:, 2] += lowest
    gaps = np.flatnonzero(np.isnan(broken[:, 0]))
    pieces = [piece[~np.isnan(piece[:, 0])] for piece in np.split(broken, gaps)]
    return [(np.round(piece / size, _DIGITS) * size).ravel().tolist() for piece in pieces if len(piece) > 1]
