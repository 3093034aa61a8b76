"""Measuring states of runs in a process of its own, so that the model does not wait for its measures."""

import copy
import math
import pickle
from dataclasses import dataclass
from typing import Any

from barchan.analysis.declared_measures import measures_of
from barchan.analysis.frame_measurer import FrameMeasurer
from barchan.errors import BarchanError
from barchan.simulation import Simulation, State

Row = dict[str, Any]
"""The measures after a step: ``step``, ``values`` by name (None where one has none), ``doubts`` by name."""

MOST_SERIES = 16
"""Series whose earlier frames are remembered."""


@dataclass(frozen=True)
class Job:
    """A state that is to be measured."""

    series: int
    """States of a series are compared with those before them."""
    state: State
    past: tuple[State, ...] = ()
    """Earlier states to compare with, for the first of a series that has a past."""
    extra: bool = False
    """Whether later states of the series are not compared with it: its step is not one of the fixed ones."""

    @property
    def bytes(self) -> int:
        """Memory of its arrays."""
        return sum(array.nbytes for array in self.state.arrays.values())


class Measuring:
    """Measures one state after the other."""

    def __init__(self) -> None:
        """Begin without a series."""
        self._series: dict[int, FrameMeasurer] = {}

    def row(self, job: Job) -> Row:
        """The measures of a state."""
        simulation = Simulation.from_state(job.state)
        known = self._series.pop(job.series, None)
        measurer = known or _looking_back(simulation, job.past)
        if job.extra:
            if known is not None:
                self._series[job.series] = known
            return {**_measured(simulation, copy.deepcopy(measurer)), "extra": True}
        self._series[job.series] = measurer
        while len(self._series) > MOST_SERIES:
            del self._series[next(iter(self._series))]
        return _measured(simulation, measurer)

    def answer(self, data: bytes) -> Row:
        """The measures of the state in a pickled job of this session; what fails is said in the row."""
        return self.row_or_failure(pickle.loads(data))  # noqa: S301 - the worker of this session wrote it

    def row_or_failure(self, job: Job) -> Row:
        """The measures of a state, or an empty row that says why there are none."""
        try:
            return self.row(job)
        except (BarchanError, ArithmeticError, LookupError, MemoryError, TypeError, ValueError) as error:
            extra = {"extra": True} if job.extra else {}
            return {"step": job.state.step, "values": {}, "doubts": {}, "failed": str(error), **extra}


def _looking_back(simulation: Simulation, past: tuple[State, ...]) -> FrameMeasurer:
    measurer = FrameMeasurer(simulation.scenario)
    for state in past:
        earlier = Simulation.from_state(state)
        tally = earlier.tally
        measurer.keep(state.step, earlier.bed, earlier.forcing, (tally.travel_x, tally.travel_y))
    return measurer


def _measured(simulation: Simulation, measurer: FrameMeasurer) -> Row:
    tally = simulation.tally
    frame = measurer.measured(
        simulation.steps_done,
        simulation.bed,
        simulation.forcing,
        simulation.wind_direction,
        (tally.travel_x, tally.travel_y),
        lambda: (simulation.model, simulation.bed, simulation.last_segment),
    )
    found = [measure.of(frame) for measure in measures_of(simulation.scenario)]
    return {
        "step": simulation.steps_done,
        "values": {v.measure.name: v.value if math.isfinite(v.value) else None for v in found},
        "doubts": {v.measure.name: v.doubt for v in found if v.doubt},
    }
