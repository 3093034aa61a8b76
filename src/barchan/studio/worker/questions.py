"""Commands that ask a run for something and change nothing of it, or have it kept elsewhere."""

from pathlib import Path
from typing import TYPE_CHECKING

from barchan.studio.protocol import Request
from barchan.studio.worker.background import AllMeasured, Background
from barchan.studio.worker.exporting import export_states
from barchan.studio.worker.handlers import WORKER, Answer
from barchan.studio.worker.rescue import to_bytes
from barchan.studio.worker.rose import rose_of
from barchan.studio.worker.saved_runs import save_run, states_of
from barchan.studio.worker.spacetime import space_time as section_over_time
from barchan.studio.worker.strata import layers_along

if TYPE_CHECKING:
    from barchan.studio.worker.commands import RunCommands


@WORKER.handles("keep")
def keep(commands: "RunCommands", _: Request) -> None:
    """Let the server keep the newest state, unless it has it already."""
    now = id(commands.current.live), commands.current.live.steps_done, len(commands.current.live.events)
    if now != commands.kept and (data := to_bytes(commands.current, commands.number)):
        commands.kept = now
        commands.send_bytes(data)


@WORKER.handles("save_folder")
def save_folder(commands: "RunCommands", request: Request) -> Answer:
    """Save the run as an archive, while it goes on."""
    states, folder = states_of(commands.current), Path(request["folder"])
    bookmarks = commands.current.bookmarks_here()
    step = states[-1].step
    return Background(lambda count: {"frames": save_run(states, folder, count, bookmarks), "step": step})


@WORKER.handles("export_to")
def export_to(commands: "RunCommands", request: Request) -> Answer:
    """Write the run for another program, while it goes on; what is looked at is the last frame of it."""
    target, options = Path(request["target"]), dict(request["options"])
    shown = commands.current.shown.steps_done
    states = [state for state in states_of(commands.current) if state.step <= shown]
    if request.get("states") is not None:
        states = states[-max(1, int(request["states"])) :]
    place = target.parent.name
    return Background(lambda count: {"file": f"{place}/{export_states(states, target, options, count)}"})


@WORKER.handles("measured")
def measured(commands: "RunCommands", _: Request) -> Answer:
    """The rows at all fixed steps up to now, as soon as every one of them is measured."""
    commands.desk.wake()
    return AllMeasured(lambda: commands.current)


@WORKER.handles("rose")
def rose(commands: "RunCommands", _: Request) -> Answer:
    """The roses of the wind."""
    return {"rose": rose_of(commands.current.live)}


@WORKER.handles("space_time")
def space_time(commands: "RunCommands", request: Request) -> Answer:
    """The section along a line over the whole run."""
    return section_over_time(commands.current, [float(place) for place in request["line"]])


@WORKER.handles("strata")
def strata(commands: "RunCommands", request: Request) -> Answer:
    """The layers of the bed along a line, with one of their values."""
    line = [float(place) for place in request["line"]]
    return layers_along(commands.current.shown, line, str(request["by"]))
