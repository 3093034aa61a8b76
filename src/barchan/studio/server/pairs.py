"""Runs that are saved side by side and opened side by side again."""

import shutil
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from barchan.studio.protocol import Request
from barchan.studio.server.lockstep import Lockstep
from barchan.studio.server.together import Member, name_together

if TYPE_CHECKING:
    from barchan.studio.server.joint_answers import Answers
    from barchan.studio.server.session import Session
    from barchan.studio.server.unfinished import Adopted

RUNS = ("a", "b")
"""The names of two runs side by side."""


def save_together(session: "Session", folder: Path, request: Any) -> None:
    """Save both runs where they meet next, in folders beside each other that are named by their models."""
    models = {run: str(session.scenarios[run]["model"]["name"]) for run in session.workers}
    same = len(set(models.values())) < len(models)
    folders = {run: f"{model}-{run}" if same else model for run, model in models.items()}

    def done(answers: "Answers") -> None:
        words = ("title", "model", "step", "steps")
        members = [
            Member(folder=folders[run], **{word: answer[word] for word in words})
            for run, answer in answers.items()
        ]
        name_together(folder, members)
        frames = sum(answer["frames"] for answer in answers.values())
        session.tell("done", id=request, frames=frames, step=members[0].step)

    def failed(why: str, _: "Answers") -> None:
        shutil.rmtree(folder, ignore_errors=True)
        session.tell("refused", id=request, command="save", text=why, problems=[])

    def progress(count: int, of: int) -> None:
        session.tell("progress", id=request, done=count, of=of)

    def ask() -> None:
        parts: dict[str, Request] = {
            run: {"command": "save_folder", "folder": str(folder / own)} for run, own in folders.items()
        }
        session.joint.ask(parts, done, failed, progress, request)

    assert session.lockstep is not None
    session.lockstep.meet(ask)


def open_together(
    session: "Session", folders: Sequence[Path], request: Any = None, adopted: "Adopted | None" = None
) -> None:
    """Go on with a run, or with two side by side, paused where they were saved.

    The run that there is is set aside, as of ``create``. What was ``adopted`` of an earlier studio is left as
    it is where they cannot be opened.
    """

    def settled(begun: bool) -> None:
        if adopted is None:
            return
        if begun:
            session.autosave.adopt(adopted)
        else:
            adopted.release()

    parts: dict[str, Request] = {
        run: {"command": "open_folder", "folder": str(folder)}
        for run, folder in zip(RUNS, folders, strict=False)
    }
    _begin_together(session, parts, "open", request, settled)


def start_together(
    session: "Session", scenarios: Sequence[dict[str, Any]], running: bool, request: Any
) -> None:
    """Start two scenarios side by side; the run that there is is set aside, as of ``create``."""

    def settled(begun: bool) -> None:
        if begun and running and session.lockstep is not None:
            session.lockstep.run()

    parts: dict[str, Request] = {
        run: {"command": "start", "scenario": data, "running": False}
        for run, data in zip(RUNS, scenarios, strict=True)
    }
    _begin_together(session, parts, "create", request, settled)


def _begin_together(
    session: "Session",
    parts: dict[str, Request],
    command: str,
    request: Any,
    settled: Callable[[bool], None],
) -> None:
    """Let each run begin with its part, and all or none; ``settled`` is then told whether they have."""
    first, _ = RUNS
    if first in session.scenarios:
        session.workers[first].send("keep")
    if session.lockstep is not None:
        session.lockstep.pause()
    if len(parts) > 1:
        session.end_second()

    def done(answers: "Answers") -> None:
        settled(True)
        if len(answers) == 1 and session.lockstep is not None:
            session.end_second()
        told = {key: answers[first][key] for key in ("step", "aside", "ended") if key in answers[first]}
        session.tell("done", id=request, **told)

    def failed(why: str, answers: "Answers") -> None:
        settled(False)
        if len(parts) > 1:
            session.end_second()
        if first in answers:
            session.aside.take_back(first)
        session.tell("refused", id=request, command=command, text=why, problems=[])

    asked: dict[str, Request] = {run: {**part, "aside": run == first} for run, part in parts.items()}
    session.joint.ask(asked, done, failed, request=request, send=session.start_run)
    if len(parts) > 1:
        session.lead(Lockstep(session.workers, session.on_lockstep))
        session.report_runs()
