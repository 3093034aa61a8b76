"""Runs of the studio saved as archives, and archives continued in the studio."""

import json
from collections.abc import Iterator, Sequence
from dataclasses import asdict, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from barchan.analysis.fields import scenario_at
from barchan.archive import Archive, open_run
from barchan.archive.checkpoint import read_checkpoint
from barchan.archive.folder import BOOKMARKS, CHECKPOINT, scenario_of
from barchan.archive.frames import COUNTERS
from barchan.errors import ArchiveError, BarchanError
from barchan.scenario import Scenario
from barchan.simulation import LOOK_ONLY, Simulation, State
from barchan.studio.worker.background import Count
from barchan.studio.worker.bookmarks import Bookmark, Bookmarks, bookmark_from, marks_of
from barchan.studio.worker.desk import Desk
from barchan.studio.worker.history import FINEST, History
from barchan.studio.worker.run import StudioRun, resumed
from barchan.version import __version__

if TYPE_CHECKING:
    import xarray as xr


def save_run(
    states: tuple[State, ...],
    folder: Path,
    count: Count = lambda _done, _of: None,
    bookmarks: Sequence[Bookmark] = (),
) -> int:
    """Save states of a run as frames, the last one as its newest state; returns the number of frames.

    Bookmarks stand beside them.

    Raises ArchiveError where the folder is not empty or cannot be written.
    """
    live = Simulation.from_state(states[-1])
    archive = Archive.create(folder, Simulation.from_state(states[0]))
    try:
        archive.log("start", seed=live.scenario.seed, steps=live.scenario.run.steps, version=__version__)
        for number, state in enumerate(states):
            archive.save(Simulation.from_state(state).frame())
            count(number + 1, len(states))
        archive.checkpoint(live)
        if bookmarks:
            text = json.dumps([asdict(bookmark) for bookmark in bookmarks], indent=1)
            (folder / BOOKMARKS).write_text(f"{text}\n", "utf-8")
        archive.log("interrupted", step=live.steps_done, reason="saved from the studio")
        assert archive.frames is not None
        return archive.frames.count
    finally:
        archive.close()


def open_saved_run(folder: Path, desk: Desk | None = None) -> StudioRun:
    """The run in a folder, at its newest checkpoint, with its frames as its past.

    Raises ArchiveError where there is no run to continue.
    """
    scenario = scenario_of(folder)
    last = read_checkpoint(folder / CHECKPOINT)
    bookmarks = [one for one in _bookmarks_in(folder) if one.step <= last.step]
    history = History(min(scenario.run.save_every, FINEST), marks=marks_of(bookmarks))
    for state in _states_in(folder, last):
        history.keep(state)
    history.keep(last)
    run = resumed(last, history, desk)
    run.bookmarks = Bookmarks(bookmarks)
    return run


def _states_in(folder: Path, last: State) -> Iterator[State]:
    """The frames of a run before its newest state, to look at; none where it has no frames."""
    try:
        dataset = open_run(folder)
    except ArchiveError:
        return
    with dataset:
        for at in range(dataset.sizes["step"]):
            if int(dataset["step"][at]) < last.step:
                yield _state_of(dataset.isel(step=at), last)


def _bookmarks_in(folder: Path) -> list[Bookmark]:
    """The bookmarks beside a run; none where their file is missing or is damaged: the run is good without."""
    try:
        return [bookmark_from(data) for data in json.loads((folder / BOOKMARKS).read_text("utf-8"))]
    except (OSError, ValueError, TypeError, BarchanError):
        return []


def run_of_frames(frames: "xr.Dataset", scenario: Scenario, desk: Desk | None = None) -> StudioRun:
    """The frames of a run to look at, the last one first; no run goes on from them.

    Raises ArchiveError where there are none.
    """
    if not frames.sizes.get("step"):
        raise ArchiveError("the run has no frames")
    pattern = _as_changed(Simulation(scenario).state(), frames, scenario)
    history = History(min(scenario.run.save_every, FINEST))
    for at in range(frames.sizes["step"]):
        history.keep(_state_of(frames.isel(step=at), pattern))
    run = resumed(history.states[-1], history, desk)
    run.continues = False
    return run


def _as_changed(state: State, frames: "xr.Dataset", scenario: Scenario) -> State:
    """The state with the events of the frames, and the parameters and the wind in force after them."""
    now = scenario_at(frames.isel(step=-1), scenario).data()
    events = json.loads(frames.attrs.get("events", "[]"))
    return replace(state, data={**state.data, "model": now["model"], "wind": now["wind"], "events": events})


def _state_of(frame: "xr.Dataset", last: State) -> State:
    """A frame as a state to look at; frames lack the model's own state, so no run continues from it."""
    arrays = dict(last.arrays)
    for name, values in frame.data_vars.items():
        if f"bed/{name}" in arrays:
            arrays[f"bed/{name}"] = values.values
    counters = {counter.name: frame[counter.name].item() for counter in COUNTERS if counter.name in frame}
    data = {
        **last.data,
        "step": int(frame["step"]),
        "ledger": _updated(last.data["ledger"], counters),
        "tally": _updated(last.data["tally"], counters),
        LOOK_ONLY: True,
    }
    return State(data, arrays)


def _updated(before: dict[str, Any], counters: dict[str, Any]) -> dict[str, Any]:
    return {name: counters.get(name, value) for name, value in before.items()}
