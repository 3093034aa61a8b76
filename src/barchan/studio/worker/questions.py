"""Commands that ask a run for something and change nothing of it, or have it kept or compared elsewhere."""

import shutil
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from barchan.errors import ArchiveError, BarchanError
from barchan.export.formats import format_of
from barchan.export.options import options_of
from barchan.simulation import State
from barchan.studio.protocol import Request
from barchan.studio.worker.background import AllMeasured, Background, Count, Reading
from barchan.studio.worker.file_content import file_content
from barchan.studio.worker.handlers import WORKER, Answer
from barchan.studio.worker.overlay import read_overlay
from barchan.studio.worker.rescue import MOST, newest_of, to_bytes
from barchan.studio.worker.rose import rose_of
from barchan.studio.worker.run import StudioRun, states_of
from barchan.studio.worker.spacetime import space_time as section_over_time
from barchan.studio.worker.spacetime_files import Beside, write_space_time
from barchan.studio.worker.state_files import StateFiles, StateNames
from barchan.studio.worker.state_folder import beside_newest, fingerprint, write_newest
from barchan.studio.worker.strata import layers_along

if TYPE_CHECKING:
    from barchan.studio.worker.commands import RunCommands

REPORT_MADE_BY = "barchan studio   (File, Comparison report of both runs)"


@WORKER.handles("keep")
def keep(commands: "RunCommands", _: Request) -> None:
    """Let the server keep the newest state, unless it has it already."""
    now = id(commands.current.live), commands.current.live.steps_done, len(commands.current.live.events)
    files = StateNames(commands.files_folder or Path(), commands.files)
    if now != commands.kept and (data := to_bytes(commands.current, commands.number, files)):
        commands.kept = now
        commands.send_bytes(data)


@WORKER.handles("keep_in")
def keep_in(commands: "RunCommands", request: Request) -> Answer:
    """Write the newest state into a folder, while the run goes on, unless it is the one that is ``known``."""
    found = fingerprint(commands)
    if found is None or found == request.get("known"):
        return {"fingerprint": found, "written": False}
    commands.files_folder = Path(request["states"])
    return _kept(commands, commands.current, commands.title, request, {"fingerprint": found})


@WORKER.handles("keep_aside_in")
def keep_aside_in(commands: "RunCommands", request: Request) -> Answer:
    """Write the state of the run that is set aside into a folder, unless nobody would miss it."""
    if commands.aside is None or not commands.aside.run.would_be_missed:
        return {"written": False}
    return _kept(commands, commands.aside.run, commands.aside.title, request, {})


def _kept(
    commands: "RunCommands", run: StudioRun, title: str, request: Request, answer: dict[str, Any]
) -> Answer:
    """Write the newest state; ``lacking`` says why branches or earlier states could not be written beside."""
    folder, state = Path(request["folder"]), newest_of(run)
    if state is None:
        raise BarchanError(f"the run's state has more than the {MOST >> 20} MB that are kept by themselves")
    files = StateFiles(Path(request["states"]), commands.files)
    beside = beside_newest(run, files)

    def write(_: Count) -> dict[str, Any]:
        member = {**write_newest(state, beside, folder), "title": title}
        lacking = files.write()
        again = {"fingerprint": None} if lacking else {}
        return {
            **answer,
            **again,
            "written": True,
            "member": member,
            "files": files.needed,
            "lacking": lacking,
        }

    return _written(folder, write)


@WORKER.handles("save_folder")
def save_folder(commands: "RunCommands", request: Request) -> Answer:
    """Save the run as an archive, while it goes on; up to step ``until`` where that is stated."""
    from barchan.studio.worker.saved_runs import save_run  # brings zarr, which a first picture does without

    folder = Path(request["folder"])
    states = _up_to(states_of(commands.current), request.get("until"))
    step = states[-1].step
    bookmarks = [one for one in commands.current.bookmarks_here() if one.step <= step]
    scenario = commands.current.live.scenario
    commands.current.wanted = True
    words = {"title": commands.title, "model": scenario.model.name, "steps": scenario.run.steps}
    return _written(
        folder, lambda count: {"frames": save_run(states, folder, count, bookmarks), **words, "step": step}
    )


@WORKER.handles("export_to")
def export_to(commands: "RunCommands", request: Request) -> Answer:
    """Write the run for another program, while it goes on; what is looked at is the last frame of it."""
    from barchan.studio.worker.exporting import export_states  # brings zarr, too

    target, options = Path(request["target"]), options_of(dict(request["options"]))
    chosen = {key: request[key] for key in ("format", "fields") if request.get(key) is not None}
    states = _up_to(states_of(commands.current), commands.current.shown.steps_done)
    series = format_of(target, chosen.get("format")).series
    several = request.get("states") or (len(states) if series else 1)
    states = states[-max(1, int(several)) :]
    return _file(target, lambda count: export_states(states, target, {**options, **chosen}, count))


@WORKER.handles("space_time_to")
def space_time_to(commands: "RunCommands", request: Request) -> Answer:
    """Write the section along a line over time up to what is looked at, of a run ``beside`` another too."""
    target, line = Path(request["target"]), [float(place) for place in request["line"]]
    states = _up_to(states_of(commands.current), commands.current.shown.steps_done)
    beside = None
    if given := request.get("beside"):
        low, high = given["limits"]
        beside = Beside(str(given["name"]), (float(low), float(high)))
    return _file(target, lambda count: write_space_time(states, line, target, count, beside))


@WORKER.handles("report_to")
def report_to(_: "RunCommands", request: Request) -> Answer:
    """Write the report that compares the saved runs in the folders ``runs``."""
    from barchan.comparison.of_runs import compare_runs  # brings pandas and matplotlib

    target, runs = Path(request["target"]), [Path(folder) for folder in request["runs"]]
    return _file(target, lambda count: compare_runs(runs, target, count, REPORT_MADE_BY).name)


@WORKER.handles("break_off")
def break_off(commands: "RunCommands", request: Request) -> None:
    """Give up the work on the answer to the request with the id ``of``."""
    commands.break_off(request.get("of"))


def _up_to(states: tuple[State, ...], step: int | None) -> tuple[State, ...]:
    """The states up to a step, of which there is always the first."""
    return states if step is None else tuple(state for state in states if state.step <= step) or states[:1]


def _file(target: Path, write: Callable[[Count], str]) -> Background:
    """An answer that names the file that is written, beside ``target``, for the page to fetch."""
    return _written(target.parent, lambda count: {"file": f"{target.parent.name}/{write(count)}"})


def _written(folder: Path, write: Callable[[Count], dict[str, Any]]) -> Background:
    """Work that writes into a new folder, of which nothing is left where it is broken off or fails."""

    def work(count: Count) -> dict[str, Any]:
        try:
            return write(count)
        except ArchiveError:  # the folder holds what others have written
            raise
        except Exception:
            shutil.rmtree(folder, ignore_errors=True)
            raise

    return Background(work)


@WORKER.handles("measured")
def measured(commands: "RunCommands", _: Request) -> Answer:
    """The rows at all fixed steps up to now and of the state where it rests, once all are measured."""
    answer = AllMeasured(lambda: commands.current)
    commands.desk.wake()
    return answer


@WORKER.handles("rose")
def rose(commands: "RunCommands", _: Request) -> Answer:
    """The roses of the wind."""
    return {"rose": rose_of(commands.current.live)}


@WORKER.handles("space_time")
def space_time(commands: "RunCommands", request: Request) -> Answer:
    """The section along a line over the whole run."""
    return section_over_time(commands.current, [float(place) for place in request["line"]])


@WORKER.handles("overlay")
def overlay(commands: "RunCommands", request: Request) -> None:
    """Compare the surface with the terrain in a file from now on; without a path with none."""
    wanted = request.get("path") is not None
    commands.frames.overlay = read_overlay(request, commands.current.live.lattice) if wanted else None
    commands.describe()


@WORKER.handles("inspect")
def inspect(_: "RunCommands", request: Request) -> Answer:
    """What a file holds; what was read is at hand for the command that uses it."""
    path = Path(request["path"])
    return Reading(lambda _: file_content(path))


@WORKER.handles("strata")
def strata(commands: "RunCommands", request: Request) -> Answer:
    """The layers of the bed along a line, with one of their values."""
    line = [float(place) for place in request["line"]]
    return layers_along(commands.current.shown, line, str(request["by"]))
