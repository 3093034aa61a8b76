"""States of the runs that the server keeps, so that a lost process does not take its run along."""

from barchan.studio.protocol import state_head

EVERY = 5.0
"""Seconds from one state that is kept to the next."""

LARGE = 32 << 20
"""Bytes of a state beyond which it is kept less often, in proportion."""

DEPTH = 2
"""States of a run that are kept: of two runs, one may have been lost between sending one and the other."""


class KeptStates:
    """The newest states of each run; those of a run that was replaced go when the new one has begun."""

    def __init__(self) -> None:
        """Nothing kept."""
        self._by_run: dict[str, dict[int, bytes]] = {}
        self._numbers: dict[str, int] = {}

    def take(self, run: str, data: bytes) -> None:
        """Keep a state."""
        number, step = state_head(data)
        if number == self._numbers.get(run, number):
            kept = self._by_run.setdefault(run, {})
            kept.pop(step, None)
            kept[step] = data
            self._by_run[run] = dict(list(kept.items())[-DEPTH:])

    def begun(self, run: str, number: int, resumed: bool) -> None:
        """Another run has begun; unless it was ``resumed``, what is kept of the one before is of no use."""
        self._numbers[run] = number
        if not resumed:
            self._by_run.pop(run, None)

    def newest(self, run: str) -> bytes | None:
        """The state of a run that was kept last; None where there is none."""
        kept = list(self._by_run.get(run, {}).values())
        return kept[-1] if kept else None

    def forget(self, run: str) -> None:
        """A run was ended."""
        self._by_run.pop(run, None)
        self._numbers.pop(run, None)

    def common_step(self, runs: list[str]) -> int | None:
        """The step that was kept last of all of some runs; None where there is none.

        It need not be the highest: a run may have been continued from an earlier state.
        """
        kept = [self._by_run.get(run, {}) for run in runs]
        shared = [step for step in kept[0] if all(step in other for other in kept[1:])] if kept else []
        return shared[-1] if shared else None

    def at(self, run: str, step: int) -> bytes:
        """The state of a run after a step; raises KeyError where it is not kept."""
        return self._by_run[run][step]

    @property
    def pause(self) -> float:
        """Seconds until states are to be kept again."""
        largest = max((len(data) for kept in self._by_run.values() for data in kept.values()), default=0)
        return EVERY * max(1.0, largest / LARGE)
