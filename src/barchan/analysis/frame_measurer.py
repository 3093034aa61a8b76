"""Compares each frame of a run with the frames before it."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from barchan.analysis.measured_frame import MeasuredFrame, WindChoice
from barchan.bed import Bed
from barchan.measures.migration import NOWHERE, WHOLE, Migration, migration, moved, whole_cycles
from barchan.models import Model
from barchan.scenario import Scenario
from barchan.squares import bedforms_of
from barchan.wind.forcing import Blows, Forcing
from barchan.wind.resultant import resultant_direction
from barchan.wind.segment import Segment

LAGS = 3
"""Earlier frames, or whole cycles of the wind, that a frame's migration is measured from."""

MOST_KEPT = 64
"""Frames that are kept at most, where a cycle of the wind is long."""


@dataclass(frozen=True)
class _Kept:
    step: int
    surface: NDArray[np.float64]
    travelled: NDArray[np.float64]
    path: NDArray[np.float64]
    """Displacement (rows, columns) of the bedforms since some earlier frame; followed under winds in turn."""


class FrameMeasurer:
    """Compares each frame of a run with those before it, of which it keeps as many as migration needs.

    These are ``LAGS`` frames where the wind stays the same, or else all of as many cycles of the wind.
    """

    def __init__(self, scenario: Scenario, wind: WindChoice = "resultant") -> None:
        """Begin without earlier frames; windward and downwind refer to the ``wind`` chosen."""
        self.scenario = scenario
        self.wind = wind
        self._recent: list[_Kept] = []
        self._resultant: tuple[Blows, float] | None = None

    @property
    def last_step(self) -> int | None:
        """The step of the newest frame."""
        return self._recent[-1].step if self._recent else None

    def keep(self, step: int, bed: Bed, forcing: Forcing, travelled: Sequence[float]) -> None:
        """Keep a frame to compare later ones with: its bed and the distances travelled (cells, x and y).

        Its last step was under the wind of ``forcing``.
        """
        cycle, lattice = _cycle(forcing, step), self.scenario.lattice
        surface = bedforms_of(bed)
        path = np.zeros(2)
        swings = 0.0 < cycle < math.inf
        if swings and self._recent:
            before = self._recent[-1]
            path = before.path + moved(before.surface, surface, lattice.periodic)
        self._recent.append(_Kept(step, surface, np.asarray(travelled, float), path))
        least = step - (LAGS + WHOLE) * cycle if swings else -math.inf
        most = MOST_KEPT if swings else LAGS + 1
        self._recent = [frame for frame in self._recent[-most:] if frame.step >= least]

    def measured(
        self,
        step: int,
        bed: Bed,
        forcing: Forcing,
        direction: float,
        travelled: Sequence[float],
        modelled: Callable[[], tuple[Model, Bed, Segment]],
    ) -> MeasuredFrame:
        """The next frame of the run, after ``step`` steps, the last of them under the wind of ``forcing``.

        ``direction`` (degrees) is where the wind of that step came from.
        """
        self.keep(step, bed, forcing, travelled)
        now, before = self._recent[-1], self._recent[max(len(self._recent) - 2, 0)]
        found, span, standing = self._migration(_cycle(forcing, step))
        travel = now.travelled - before.travelled
        return MeasuredFrame(
            modelled=modelled,
            bed=bed,
            surface=now.surface,
            scenario=self.scenario,
            direction=direction,
            resultant=self._resultant_of(forcing, step),
            wind=self.wind,
            migration=found,
            standing=standing,
            travel=(float(travel[0]), float(travel[1])),
            steps=step - before.step,
            span=span,
        )

    def _migration(self, cycle: float) -> tuple[Migration, int, str]:
        """The migration, the time (steps) since the nearest frame used, and why there is none."""
        steps = np.array([frame.step for frame in self._recent])
        if len(steps) < 2:
            return NOWHERE, 0, "no earlier frame to compare with"
        if math.isinf(cycle):
            cycle = 0.0
        used = whole_cycles(steps.astype(float), cycle, LAGS)
        if not used:
            return NOWHERE, 0, f"no frame is whole cycles of the wind ({cycle:g} steps) earlier"
        surfaces = [frame.surface for frame in self._recent]
        path = np.array([frame.path for frame in self._recent]) if cycle else None
        found = migration(steps, surfaces, self.scenario.lattice.periodic, lags=LAGS, cycle=cycle, path=path)
        return found, int(steps[-1] - steps[used[0]]), ""

    def _resultant_of(self, forcing: Forcing, step: int) -> float:
        """The resultant direction, computed once as long as the wind stays the same and repeats itself."""
        known = self._resultant
        if known is None or known[0] != forcing.wind or math.isinf(_cycle(forcing, step)):
            hop = getattr(self.scenario.model, "hop_length", 1.0)
            known = self._resultant = forcing.wind, resultant_direction(forcing, max(step - 1, 0), hop)
        return known[1]


def _cycle(forcing: Forcing, step: int) -> float:
    """Steps after which the wind of the last of ``step`` steps repeats itself; see ``Blows.period``."""
    return forcing.wind.period(max(step - 1, 0), forcing.clock)
