"""The measures of a run at fixed steps: the same on every machine, whatever the browser does meanwhile."""

from collections.abc import Sequence
from itertools import count
from typing import Any

from barchan.analysis.declared_measures import measures_of
from barchan.simulation import Simulation, State
from barchan.studio.worker.desk import Desk
from barchan.studio.worker.measuring import Job, Row

FINEST = 20
"""Steps from one measurement to the next at first, at most."""

ROWS = 200
"""Measurements until the interval doubles for the first time; afterwards it doubles whenever the step has."""

LOOKED_BACK = 64
"""Kept states that are compared with when a run continues from an earlier one."""

_numbers = count(1)


def interval(step: int, first: int) -> int:
    """Steps from one measurement to the next at a step, where it is ``first`` in the beginning."""
    return first << (step // (ROWS * first)).bit_length()


def next_step(step: int, first: int) -> int:
    """The next step after this one at which is measured; every one is a multiple of the interval there."""
    every = interval(max(step, 0), first)
    return (step // every + 1) * every


class LiveMeasures:
    """The rows of a run at its fixed steps, and the measures of the state at which it is paused."""

    def __init__(self, first: int, desk: Desk, past: tuple[State, ...] = ()) -> None:
        """Begin without any row, after these kept states."""
        self.first = min(first, FINEST)
        self.rows: list[Row] = []
        self.due = next_step(past[-1].step, self.first) if past else 0
        """The step at which is measured next."""
        self._desk = desk
        self._past = tuple(state for state in past if state.step % self.first == 0)[-LOOKED_BACK:]
        self.number = next(_numbers)
        """The number of its series at the desk."""
        self._unsent: list[Row] = []
        self._replaced = True
        self.newest = -1
        """The last of the fixed steps so far."""
        self._last = -1
        self._resting: Row | None = None
        """The row of the state at which it was paused last, at whatever step."""

    def take(self, simulation: Simulation) -> None:
        """Measure a simulation where its step is one of the fixed ones."""
        if simulation.steps_done == self.due:
            self.take_state(simulation.state())

    def take_state(self, state: State) -> None:
        """Measure a state, later than those before, where its step is one of the fixed ones."""
        if state.step >= self.due and state.step % interval(state.step, self.first) == 0:
            self.due = next_step(state.step, self.first)
            self.newest = state.step
            self._submit(state)
            self._past = ()

    def begin_after(self, step: int) -> None:
        """Measure at the fixed steps after this one; those before it are past."""
        self.due = max(self.due, next_step(step, self.first))

    def take_extra(self, simulation: Simulation) -> None:
        """Measure a simulation that is paused, at whatever step."""
        step = simulation.steps_done
        if step != self._last:
            self._submit(simulation.state(), extra=True)

    def _submit(self, state: State, extra: bool = False) -> None:
        self._last = state.step
        past = tuple(earlier for earlier in self._past if earlier.step < state.step)
        self._desk.submit(Job(self.number, state, past, extra), self._on_row)

    def _on_row(self, row: Row) -> None:
        if "extra" in row:
            self._resting = row
        else:
            self.rows.append(row)
        self._unsent.append(row)

    def has(self, step: int) -> bool:
        """Whether the state after a step, and so every one before it, is measured."""
        newest = [*self.rows[-1:], *([self._resting] if self._resting else [])]
        return any(row["step"] >= step for row in newest)

    def up_to(self, step: int) -> list[Row]:
        """The rows at the fixed steps up to a step."""
        return [row for row in self.rows if row["step"] <= step]

    def ending_at(self, step: int) -> list[Row]:
        """The rows up to a step, with that of the step itself where the run was paused there."""
        rows, last = self.up_to(step), self._resting
        beyond = last is not None and last["step"] == step and not (rows and rows[-1]["step"] == step)
        return [*rows, last] if last is not None and beyond else rows

    def unsent(self) -> dict[str, Any]:
        """What the browser does not have yet: rows, and whether they replace all others."""
        found: dict[str, Any] = {"measures": self._unsent} if self._unsent or self._replaced else {}
        if found and self._replaced:
            found["measures_replaced"] = True
        self._unsent, self._replaced = [], False
        return found

    def resend(self) -> None:
        """Let all rows count as not sent."""
        self._unsent, self._replaced = list(self.rows), True

    def until(self, step: int, states: list[State]) -> "LiveMeasures":
        """The rows up to a step, for a run that continues from there and has these kept ``states``."""
        return measures_until(step, self.first, self._desk, self.up_to(step), states)


def measures_until(
    step: int, first: int, desk: Desk, rows: list[Row], states: Sequence[State]
) -> LiveMeasures:
    """Measures that have these ``rows`` up to a step, for a run that continues from there.

    Kept ``states`` up to there that are not measured yet are measured for it.
    """
    done = rows[-1]["step"] if rows else -1
    measures = LiveMeasures(first, desk, tuple(state for state in states if state.step <= done))
    measures.rows, measures.newest = rows, done
    for state in states:
        if done < state.step <= step:
            measures.take_state(state)
    measures.begin_after(step)
    measures.resend()
    return measures


def declared_measures(simulation: Simulation) -> list[dict[str, str]]:
    """Name, title and unit of every measure, and what an angle is counted from."""
    return [
        {"name": m.name, "title": m.title, "unit": m.unit, "reference": m.reference}
        for m in measures_of(simulation.scenario)
    ]
