"""Commands that begin another run, or return to one that was set aside."""

from pathlib import Path
from typing import TYPE_CHECKING

from barchan.errors import BarchanError
from barchan.scenario import validate
from barchan.scenario.changes import changed_from
from barchan.studio.protocol import Request
from barchan.studio.worker.handlers import WORKER, Answer
from barchan.studio.worker.rescue import from_bytes
from barchan.studio.worker.run import started
from barchan.studio.worker.state_folder import holds_newest, open_newest

if TYPE_CHECKING:
    from barchan.studio.worker.commands import RunCommands

NAMES = ("start", "open_folder", "resume", "take_back")
"""Commands whose run has a number of its own, by which the server knows it."""


@WORKER.handles("start")
def start(commands: "RunCommands", request: Request) -> Answer:
    """Start a scenario; ``changed`` where it came of the last one by changes on the page.

    ``aside`` keeps the run that there is, paused, to be taken back; a scenario that did not come of it takes
    the place of that, too. ``unasked`` is one that the studio begins with by itself.
    """
    scenario = validate(request["scenario"], "scenario")
    origin = scenario
    if "origin" in request:
        origin = validate(request["origin"], "scenario")
    elif request.get("changed") and commands.origin is not None:
        origin = commands.origin
    run = started(changed_from(scenario, origin), commands.desk)
    run.wanted = not request.get("unasked")
    ended = None
    if request.get("aside") and commands.run is not None:
        ended = commands.set_aside(of_it=bool(request.get("changed")))
    elif not request.get("changed"):
        commands.aside = None
    loaded = commands.frames.loaded if request.get("changed") and commands.run is not None else None
    commands.take(run, bool(request.get("running")), origin, loaded)
    return commands.way_back(ended)


@WORKER.handles("take_back")
def take_back(commands: "RunCommands", _: Request) -> Answer:
    """Return to the run that was set aside, as it was.

    The one in its place becomes a branch of it where it came of it; else it is set aside in turn. Raises
    BarchanError where none was set aside.
    """
    if commands.aside is None:
        raise BarchanError("no run was set aside")
    before, commands.aside = commands.aside, None
    if before.of_it:
        before.take_in(commands.current)
    else:
        commands.set_aside(of_it=False)
    commands.take(before.run, running=False, origin=before.origin, loaded=before.loaded)
    return commands.way_back()


@WORKER.handles("restart")
def restart(commands: "RunCommands", request: Request) -> None:
    """Start again with the same scenario and seed."""
    running = bool(request.get("running", commands.current.running))
    run = started(commands.current.live.scenario, commands.desk)
    run.wanted = commands.current.wanted
    commands.take(run, running, commands.origin, commands.frames.loaded)


@WORKER.handles("open_folder")
def open_folder(commands: "RunCommands", request: Request) -> Answer:
    """Continue the run in an archive, or from the state in a folder, paused where it ended.

    ``aside`` is as of ``start``.
    """
    from barchan.studio.worker.saved_runs import open_saved_run  # brings zarr, which a new run does without

    folder = Path(request["folder"])
    ended, lost = None, list[str]()
    if holds_newest(folder):
        run, lost = open_newest(folder, commands.desk)
    else:
        run = open_saved_run(folder, commands.desk)
    if request.get("aside") and commands.run is not None:
        ended = commands.set_aside(of_it=False)
    else:
        commands.aside = None
    commands.take(run, running=False)
    for text in lost:
        commands.warn(text)
    return {"step": run.live.steps_done, **commands.way_back(ended)}


@WORKER.handles("resume")
def resume(commands: "RunCommands", request: Request) -> None:
    """Continue from a state that the server has kept, paused."""
    run, lost = from_bytes(request["state"], commands.desk)
    commands.take(run, running=False)
    for text in lost:
        commands.warn(text)
