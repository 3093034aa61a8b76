"""The newest state of a run in a folder, from which it goes on after the studio itself has ended."""

import json
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

from barchan.errors import ArchiveError, BarchanError
from barchan.scenario.definition import text_of
from barchan.studio.worker.bookmarks import bookmark_from
from barchan.studio.worker.desk import Desk
from barchan.studio.worker.rescue import Newest, continued
from barchan.studio.worker.run import StudioRun

if TYPE_CHECKING:
    from barchan.studio.worker.commands import RunCommands

BESIDE = "studio.json"
"""The file beside the state: bookmarks, measures, and how often states are kept."""


def fingerprint(commands: "RunCommands") -> str | None:
    """A text that changes whenever there is more to keep of the run; None for one that only began."""
    run = commands.current
    if not run.has_begun:
        return None
    at = (commands.number, run.branches.current, run.live.steps_done, len(run.live.events))
    return json.dumps([*at, run.bookmarks.data()])


def write_newest(newest: Newest, folder: Path) -> dict[str, Any]:
    """Write it into a new folder; returns title, model, step and steps of the run."""
    from barchan.archive.checkpoint import write_checkpoint  # brings zarr, which a first picture does without
    from barchan.archive.folder import CHECKPOINT, SCENARIO

    scenario = newest.state.data["scenario"]
    folder.mkdir(parents=True)
    (folder / SCENARIO).write_text(text_of(scenario), "utf-8")
    beside = {
        "every": newest.every,
        "rows": newest.rows,
        "bookmarks": [asdict(bookmark) for bookmark in newest.bookmarks],
    }
    (folder / BESIDE).write_text(json.dumps(beside), "utf-8")
    write_checkpoint(folder / CHECKPOINT, newest.state)
    steps = int(scenario["run"]["steps"])
    names = {"title": str(scenario["title"]), "model": str(scenario["model"]["name"])}
    return {**names, "step": newest.state.step, "steps": steps}


def holds_newest(folder: Path) -> bool:
    """Whether ``write_newest`` wrote the folder."""
    return (folder / BESIDE).is_file()


def open_newest(folder: Path, desk: Desk | None = None) -> StudioRun:
    """The run in such a folder, paused; of its past only the measures are left.

    Raises ArchiveError where a file is damaged.
    """
    from barchan.archive.checkpoint import read_checkpoint
    from barchan.archive.folder import CHECKPOINT

    state = read_checkpoint(folder / CHECKPOINT)
    try:
        beside = json.loads((folder / BESIDE).read_text("utf-8"))
        every, rows = int(beside["every"]), list(beside["rows"])
        bookmarks = [bookmark_from(data) for data in beside["bookmarks"]]
    except (OSError, ValueError, KeyError, TypeError, BarchanError) as error:
        raise ArchiveError(f"{folder / BESIDE}: damaged ({error})") from None
    return continued(Newest(state, every, rows, bookmarks), desk)
