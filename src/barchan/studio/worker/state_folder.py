"""A run in a folder, from whose newest states it goes on after the studio itself has ended."""

import json
import os
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

from barchan.errors import ArchiveError, BarchanError
from barchan.scenario.definition import text_of
from barchan.simulation import Simulation, State
from barchan.studio.worker.bookmarks import Bookmarks, bookmark_from, marks_of
from barchan.studio.worker.branches import MOST, Branch, Branches
from barchan.studio.worker.desk import Desk
from barchan.studio.worker.history import History
from barchan.studio.worker.live_measures import LiveMeasures
from barchan.studio.worker.run import StudioRun, measures_with, resumed
from barchan.studio.worker.state_files import BYTES, StateNames, StoredStates

if TYPE_CHECKING:
    from barchan.studio.worker.commands import RunCommands

BESIDE = "studio.json"
"""The file beside the newest state: bookmarks, measures, how often states are kept, and the branches.

What it says of a branch beside its measures are the names of files of states, which stand in another folder,
because later states of the run need them, too.
"""


def fingerprint(commands: "RunCommands") -> str | None:
    """A text that changes whenever there is more to keep of the run; None for one that nobody would miss."""
    run = commands.current
    if not run.would_be_missed:
        return None
    branches = run.branches.current, sorted(run.branches.numbers)
    at = (commands.number, *branches, run.live.steps_done, len(run.live.events))
    return json.dumps([*at, run.bookmarks.data()])


def beside_newest(run: StudioRun, files: StateNames) -> dict[str, Any]:
    """What is written beside the newest state of a run; states that it takes beside are added to ``files``.

    First those from which other branches go on, then the earlier ones of this branch, then those of others.
    """
    branches = run.branches
    newest = [files.add(other, other.simulation.state) for other in branches.others]
    states = files.add_earlier(run.history, run.live.steps_done, events=len(run.live.events))
    others = [
        {
            **_facts(other.number, other.began, other.history, other.measures),
            "newest": name,
            "states": files.add_earlier(
                other.history,
                other.simulation.steps_done,
                BYTES // MOST,
                events=len(other.simulation.events),
            ),
        }
        for other, name in zip(branches.others, newest, strict=True)
    ]
    return {
        **_facts(branches.current, branches.began, run.history, run.measures),
        "states": states,
        "bookmarks": [asdict(bookmark) for bookmark in run.bookmarks],
        "folder": files.folder,
        "numbered": branches.numbered,
        "others": others,
    }


def _facts(number: int, began: int, history: History, measures: LiveMeasures) -> dict[str, Any]:
    rows, marks = list(measures.rows), dict(history.marks)
    return {"number": number, "began": began, "every": history.every, "marks": marks, "rows": rows}


def write_newest(state: State, beside: dict[str, Any], folder: Path) -> dict[str, Any]:
    """Write both into a new folder; returns model, step and steps of the run."""
    from barchan.archive.checkpoint import write_checkpoint  # brings zarr, which a first picture does without
    from barchan.archive.folder import CHECKPOINT, SCENARIO

    scenario = state.data["scenario"]
    folder.mkdir(parents=True)
    (folder / SCENARIO).write_text(text_of(scenario), "utf-8")
    way = Path(os.path.relpath(beside["folder"], folder)).as_posix()
    (folder / BESIDE).write_text(json.dumps({**beside, "folder": way}), "utf-8")
    write_checkpoint(folder / CHECKPOINT, state)
    steps = int(scenario["run"]["steps"])
    return {"model": str(scenario["model"]["name"]), "step": state.step, "steps": steps}


def holds_newest(folder: Path) -> bool:
    """Whether ``write_newest`` wrote the folder."""
    return (folder / BESIDE).is_file()


def open_newest(folder: Path, desk: Desk | None = None) -> tuple[StudioRun, list[str]]:
    """The run in such a folder, paused, and a text for each of its branches that cannot be read any more.

    Raises ArchiveError where the newest state or what stands beside it is damaged.
    """
    from barchan.archive.checkpoint import read_checkpoint
    from barchan.archive.folder import CHECKPOINT

    beside = _read_beside(folder / BESIDE)
    return with_past(read_checkpoint(folder / CHECKPOINT), beside, folder / str(beside["folder"]), desk)


def with_past(
    state: State, beside: dict[str, Any], folder: Path, desk: Desk | None = None
) -> tuple[StudioRun, list[str]]:
    """The run that goes on from a state, paused, with what stood ``beside`` it and the states of a folder.

    With it comes a text for each of its branches that cannot be read any more.
    """
    stored, lost = StoredStates(folder), list[str]()
    run = resumed(state, stored.history(beside), desk, beside["rows"])
    run.bookmarks = Bookmarks(map(bookmark_from, beside["bookmarks"]))
    current = Branch(int(beside["number"]), int(beside["began"]), run.live, run.history, run.measures)
    others = []
    for data in beside["others"]:
        try:
            others.append(_branch(data, stored, run.desk))
        except BarchanError as error:
            lost.append(f"Branch {data['number']} of this run cannot be opened any more: {error}.")
    run.branches = Branches(current, others, int(beside["numbered"]))
    return run, lost


def _read_beside(path: Path) -> dict[str, Any]:
    """What was written beside a state; a run without other branches may have been written with less."""
    try:
        data = json.loads(path.read_text("utf-8"))
        marks = marks_of(Bookmarks(map(bookmark_from, data["bookmarks"])))
        known = {"every": int(data["every"]), "rows": list(data["rows"])}
    except (OSError, ValueError, KeyError, TypeError, BarchanError) as error:
        raise ArchiveError(f"{path}: damaged ({error})") from None
    alone = {"number": 1, "began": 0, "marks": marks, "states": []}
    return {**alone, "folder": ".", "numbered": 1, "others": [], **data, **known}


def _branch(data: dict[str, Any], stored: StoredStates, desk: Desk) -> Branch:
    state = stored.state(str(data["newest"]))
    simulation, history = Simulation.from_state(state), stored.history(data)
    measures = measures_with(data["rows"], simulation, history, desk)
    return Branch(int(data["number"]), int(data["began"]), simulation, history, measures)
