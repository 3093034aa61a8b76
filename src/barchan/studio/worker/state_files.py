"""States that stay as they are, each in a file of its own that is written once."""

from collections.abc import Callable
from pathlib import Path
from typing import Any
from uuid import uuid4
from weakref import ref

from barchan.errors import ArchiveError
from barchan.simulation import State
from barchan.studio.worker.history import BUDGET, History

BYTES = BUDGET // 2
"""Bytes of earlier states of one branch on disk, at most."""

MOST_STATES = 100
"""Earlier states of one branch on disk, at most."""


class FileNames:
    """Names of files for things that stay as they are: a name lasts as long as its thing, no other has it."""

    def __init__(self) -> None:
        """None yet."""
        self._known: dict[int, tuple[ref[object], str]] = {}

    def of(self, thing: object) -> str:
        """The name of the file for a thing, the same one whenever it is asked for."""
        key = id(thing)
        if key not in self._known:
            self._known[key] = ref(thing, lambda _: self._known.pop(key, None)), f"{uuid4().hex}.npz"
        return self._known[key][1]


class StateNames:
    """The names of the files that one run needs in a folder, whether they are there or not."""

    def __init__(self, folder: Path, names: FileNames) -> None:
        """None yet."""
        self.folder = folder
        self.needed: list[str] = []
        """The names."""
        self._names = names

    def add(self, thing: object, state: Callable[[], State]) -> str:  # noqa: ARG002 - to be written by others
        """Need the file of a thing that has a state; returns its name."""
        name = self._names.of(thing)
        if name not in self.needed:
            self.needed.append(name)
        return name

    def add_earlier(
        self, history: History, step: int, most_bytes: int = BYTES, *, events: int = 0
    ) -> list[str]:
        """Need files of states before a step, as many as there is room for; returns their names.

        ``events`` are the changes until now: a state of the same step that knows fewer is earlier, too.
        """
        return [self._add_state(state) for state in _chosen(history, (step, events), most_bytes)]

    def _add_state(self, state: State) -> str:
        return self.add(state, lambda: state)


class StateFiles(StateNames):
    """The same, and the states of those that are not there yet, to be written into the folder."""

    def __init__(self, folder: Path, names: FileNames) -> None:
        """None yet."""
        super().__init__(folder, names)
        self._missing: dict[str, State] = {}

    def add(self, thing: object, state: Callable[[], State]) -> str:
        """Need the file of a thing; its state is asked for where there is no such file. Returns its name."""
        known = len(self.needed)
        name = super().add(thing, state)
        if len(self.needed) > known and not (self.folder / name).exists():
            self._missing[name] = state()
        return name

    def write(self) -> str:
        """Write those that are missing, in the order in which they were added.

        Returns why one could not be written, which ends it; nothing where all are there.
        """
        from barchan.archive.checkpoint import write_checkpoint  # brings zarr

        try:
            for name, state in self._missing.items():
                self.folder.mkdir(parents=True, exist_ok=True)
                write_checkpoint(self.folder / name, state)
        except OSError as error:
            (self.folder / name).with_suffix(".partial").unlink(missing_ok=True)
            return error.strerror or str(error)
        return ""


class StoredStates:
    """Reads the states of a folder; a state that several branches have is read once."""

    def __init__(self, folder: Path) -> None:
        """Nothing read yet."""
        self._folder = folder
        self._read: dict[str, State] = {}

    def state(self, name: str) -> State:
        """The state in a file; raises ArchiveError where it is damaged or not there."""
        from barchan.archive.checkpoint import read_checkpoint

        if name not in self._read:
            self._read[name] = read_checkpoint(self._folder / name)
        return self._read[name]

    def history(self, data: dict[str, Any]) -> History:
        """Earlier states as ``add_earlier`` has named them, without those that cannot be read any more."""
        history = History(int(data["every"]), marks={str(k): int(step) for k, step in data["marks"].items()})
        for name in data["states"]:
            try:
                history.keep(self.state(str(name)))
            except ArchiveError:  # a gap to look back on, and no other loss
                continue
        return history


def _chosen(history: History, now: tuple[int, int], most_bytes: int) -> list[State]:
    """Earlier states: of many every second one, and of few that are still too large the newest."""
    states = tuple(state for state in history.states if (state.step, len(state.data["events"])) < now)
    if not states:
        return []
    largest = max(sum(array.nbytes for array in state.arrays.values()) for state in states)
    most = min(MOST_STATES, most_bytes // largest)
    thinned = History(history.every, states, history.marks)
    thinned.fit(BUDGET, most)
    return thinned.states[max(0, len(thinned.states) - most) :]
