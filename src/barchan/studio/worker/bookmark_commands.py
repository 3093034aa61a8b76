"""Commands on the bookmarks of a run."""

from dataclasses import replace
from typing import TYPE_CHECKING

from barchan.errors import BarchanError
from barchan.studio.protocol import Request
from barchan.studio.worker.bookmarks import bookmark_from
from barchan.studio.worker.handlers import WORKER, Answer
from barchan.words import counted

if TYPE_CHECKING:
    from barchan.studio.worker.commands import RunCommands


@WORKER.handles("bookmark")
def bookmark(commands: "RunCommands", request: Request) -> Answer:
    """Set bookmarks: at what is looked at, or at a ``step`` of the same run that the page knows of."""
    run = commands.current
    for data in request["bookmarks"]:
        given = bookmark_from(data)
        if "step" not in data and given.id not in run.bookmarks:
            branch, events = run.branches.current, len(run.shown.events)
            given = replace(given, step=run.shown.steps_done, branch=branch, events=events)
        run.mark(given)
    commands.describe()
    return {"bookmarks": run.bookmarks.data()}


@WORKER.handles("unbookmark")
def unbookmark(commands: "RunCommands", request: Request) -> None:
    """Remove a bookmark."""
    commands.current.unmark(str(request["bookmark"]))
    commands.describe()


@WORKER.handles("visit")
def visit(commands: "RunCommands", request: Request) -> Answer:
    """Look at a bookmark's moment, on the branch that holds it.

    Raises BarchanError where the branch is not kept, or the run has not come so far.
    """
    run = commands.current
    chosen = run.bookmarks[str(request["bookmark"])]
    if chosen.id not in run.history.marks:
        if chosen.branch not in run.branches.numbers:
            raise BarchanError(f"'{chosen.name}' is on branch {chosen.branch}, which is not kept any more")
        run.switch(chosen.branch)
        commands.announce()
    if chosen.step > run.live.steps_done:
        done = run.live.steps_done
        raise BarchanError(
            f"'{chosen.name}' is at step {chosen.step}; the run has done {counted(done, 'step')}"
        )
    if chosen.step == run.live.steps_done:
        run.pause()
        run.look_now()
    else:
        run.look(chosen.step)
    return {"step": run.shown.steps_done}
