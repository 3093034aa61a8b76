"""Earlier states of a run, kept in memory within a budget, so that one can look and go back."""

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


class History:
    """States of one run by their steps, evenly spaced, the first one always kept."""

    def __init__(self, every: int, states: tuple[State, ...] = ()) -> None:
        """Keep a state every ``every`` steps."""
        self.every = every
        self.states = list(states)

    @property
    def steps(self) -> list[int]:
        """The steps whose states are kept."""
        return [state.step for state in self.states]

    @property
    def due(self) -> int:
        """The step at which the next state is to be kept."""
        last = self.states[-1].step if self.states else -self.every
        return (last // self.every + 1) * self.every

    def keep(self, state: State) -> None:
        """Keep a state; arrays that are as they were before are held once."""
        if self.states:
            before = self.states[-1].arrays
            shared = {name: _same(before.get(name), array) for name, array in state.arrays.items()}
            state = replace(state, arrays=shared)
        self.states = [known for known in self.states if known.step < state.step] + [state]
        self.fit(BUDGET)

    def fit(self, budget: int) -> None:
        """Forget every second state until all take no more than ``budget`` bytes."""
        while len(self.states) > 2 and (self.bytes > budget or len(self.states) > MOST_STATES):
            self.every *= 2
            self.states = self.states[::2]

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
        return History(self.every, tuple(state for state in self.states if state.step <= step))


def _same(before: NDArray | None, now: NDArray) -> NDArray:
    return before if before is not None and np.array_equal(before, now) else now
