"""Earlier states of a run, kept in memory within a budget, so that one can look and go back."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from barchan.simulation import State

BUDGET = 400_000_000
"""Bytes that the states of a run may take; beyond, every second one is forgotten."""

MOST_STATES = 400
"""States of a run that are kept; beyond, every second one is forgotten."""

FINEST = 20
"""Steps from one state to the next at first, at most."""

MOST_HELD = 20
"""Marked states that are held although others are forgotten: those that were marked last."""


class History:
    """States of one run by their steps: the first one, evenly spaced ones, and those that are marked."""

    def __init__(
        self, every: int, states: tuple[State, ...] = (), marks: Mapping[str, int] | None = None
    ) -> None:
        """Keep a state every ``every`` steps, and those at the steps of ``marks``."""
        self.every = every
        self.states = list(states)
        self.marks = dict(marks or {})
        """Steps that are marked, before or after the newest state, by the name of the mark."""

    @property
    def steps(self) -> list[int]:
        """The steps whose states are kept."""
        return [state.step for state in self.states]

    @property
    def due(self) -> int:
        """The step at which the next state is to be kept."""
        last = self.states[-1].step if self.states else -self.every
        ahead = (step for step in self.marks.values() if step > last)
        return min(((last // self.every + 1) * self.every, *ahead))

    def keep(self, state: State) -> None:
        """Keep a state; arrays that are as they were before are held once."""
        if self.states:
            before = self.states[-1].arrays
            shared = {name: _same(before.get(name), array) for name, array in state.arrays.items()}
            state = replace(state, arrays=shared)
        self.states = [known for known in self.states if known.step < state.step] + [state]
        self.fit(BUDGET)

    def fit(self, budget: int, most: int | None = None) -> None:
        """Forget every second state until there are ``most`` that take no more than ``budget`` bytes."""
        most = MOST_STATES if most is None else most
        while len(self.states) > 2 and (self.bytes > budget or len(self.states) > most):
            held = set(list(self.marks.values())[-MOST_HELD:])
            steps = [step for step in self.steps[1:] if step % self.every == 0 or step not in held]
            forgotten = set(steps[::2]) - held
            if not forgotten:
                return
            self.every *= 2
            self.states = [state for state in self.states if state.step not in forgotten]

    @property
    def bytes(self) -> int:
        """Memory of all states (bytes)."""
        arrays = {id(array): array.nbytes for state in self.states for array in state.arrays.values()}
        return sum(arrays.values())

    def at(self, step: int) -> State:
        """The state kept nearest to a step."""
        return min(self.states, key=lambda state: abs(state.step - step))

    def until(self, step: int) -> "History":
        """The states up to a step, for another run that continues from there."""
        marks = {name: marked for name, marked in self.marks.items() if marked <= step}
        return History(self.every, tuple(state for state in self.states if state.step <= step), marks)


def _same(before: NDArray | None, now: NDArray) -> NDArray:
    return before if before is not None and np.array_equal(before, now) else now
