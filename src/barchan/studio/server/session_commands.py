"""The commands that the session carries out itself: they begin, end, save and open whole runs."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from barchan.errors import BarchanError
from barchan.models import models
from barchan.scenario import validate
from barchan.studio.commands import Handlers
from barchan.studio.protocol import Request
from barchan.studio.server.pairs import RUNS, open_together, save_together, start_together
from barchan.studio.server.together import is_together, read_together

if TYPE_CHECKING:
    from barchan.studio.server.session import Session

FIRST, SECOND = RUNS

ENDS_SECOND = "ends_second"
"""The key of a request to the first worker whose run, once it has begun, stands alone."""

SESSION: Handlers[Callable[["Session", Request], None]] = Handlers("session")


@SESSION.handles("create")
def create(session: "Session", request: Request) -> None:
    """Start a scenario; ``changed`` where it came of the one that runs by changes on the page.

    Of two that are compared both begin again with what was changed, the other one with its own model. A
    scenario that did not come of them ends the second one as soon as it has begun itself.

    With ``aside`` the run that there is is set aside, to be taken back by ``alone``: of two that are compared
    the one that was set aside for them, with the left one as a branch of it.

    Another scenario ``beside`` starts as the right one of two that run together.
    """
    data = _checked(session, request["scenario"])
    changed, running = bool(request.get("changed")), bool(request.get("running", True))
    if request.get("beside") is not None:
        beside = _checked(session, request["beside"])
        start_together(session, (data, beside), running, request.get("id"))
        return
    if changed and session.lockstep is not None:
        name = SECOND if request.get("run") == SECOND else FIRST
        other = FIRST if name == SECOND else SECOND
        newest = session.starts.scenario(other) or session.scenarios[other]
        both = {name: data, other: {**data, "model": newest["model"]}}
        session.begin(both, running, {name: {"changed": True, **_id_of(request)}, other: {"changed": True}})
        return
    aside = bool(request.get("aside")) and FIRST in session.scenarios
    if aside:
        session.workers[FIRST].send("keep")
    begun = {"changed": changed, "aside": aside, ENDS_SECOND: session.lockstep is not None}
    if session.lockstep is not None:
        session.lockstep.halt()
    session.start_run(
        FIRST, {"command": "start", **begun, **_id_of(request), "scenario": data, "running": running}
    )


@SESSION.handles("compare")
def compare(session: "Session", request: Request) -> None:
    """Run another model, or another value of a parameter, beside: the same ground, wind and seed.

    Both begin at step 0. The run that was alone is set aside, to be taken back by ``alone``. The model that
    runs already begins with the values that it has; any other with its defaults.
    """
    first = session.scenarios[FIRST]
    if "key" in request:
        second = validate(with_value(first, str(request["key"]), request["value"])).data()
    else:
        second = validate({**first, "model": _model_beside(first, request["model"])}).data()
    from_one = session.lockstep is None
    if from_one:
        session.workers[FIRST].send("keep")
    beside = {
        SECOND: {"origin": session.origins.get(FIRST, first), **_id_of(request)},
        FIRST: {"changed": True, "aside": from_one},
    }
    session.begin({FIRST: first, SECOND: second}, True, beside)
    session.report_runs()


@SESSION.handles("alone")
def alone(session: "Session", request: Request) -> None:
    """End the second simulation, if there is one, and return to the run that was set aside for them.

    To another run that was set aside it leads from a run that is alone, or with ``back``; of two that were
    opened side by side the left one stays.
    """
    pair = session.lockstep is not None
    session.workers[FIRST].send("keep")
    session.end_second()
    if not pair or session.aside.of_it or request.get("back"):
        session.aside.take_back(FIRST, request.get("id"))
    else:
        session.tell("done", id=request.get("id"), stays=True)


@SESSION.handles("share_look")
def share_look(session: "Session", request: Request) -> None:
    """Let those who watch see the surface as the one who commands sees it."""
    session.audience.look(dict(request["look"]))


@SESSION.handles("revive")
def revive(session: "Session", request: Request) -> None:
    """Start lost workers again: from the states kept after step ``kept``, or from their beginning."""
    if request.get("kept") is not None:
        session.resume(int(request["kept"]))
    elif session.scenarios:
        again: dict[str, Request] = {
            name: {"changed": True, "origin": session.origins.get(name, data)}
            for name, data in session.scenarios.items()
        }
        session.begin(dict(session.scenarios), True, again)
    else:
        session.start_run(FIRST, session.first)


@SESSION.handles("save")
def save(session: "Session", request: Request) -> None:
    """Save a run as an archive in the session's folder; of two that are compared where they meet next.

    Without ``run`` both of them are saved together, so that they open side by side again.
    """
    folder = session.workspace.new_run(str(request["name"]))
    if session.lockstep is not None and request.get("run") is None:
        save_together(session, folder, request.get("id"))
        return
    worker = session.workers[request.get("run") or FIRST]

    def write() -> None:
        worker.send("save_folder", folder=str(folder), id=request.get("id"))

    if session.lockstep is None:
        write()
    else:
        session.lockstep.meet(write)


@SESSION.handles("export")
def export(session: "Session", request: Request) -> None:
    """Write a run for another program, into a folder of its own in the session's folder.

    With ``states`` that many of the kept states, the last ones up to the one that is shown; ``options`` are
    those of ``barchan export``, ``fields`` the fields of the file.
    """
    target = session.workspace.new_export(str(request["name"]))
    options = dict(request.get("options") or {})
    chosen = {key: request[key] for key in ("format", "fields") if request.get(key) is not None}
    worker = session.workers[request.get("run") or FIRST]
    states = request.get("states")
    worker.send(
        "export_to", target=str(target), options=options, **chosen, states=states, id=request.get("id")
    )


@SESSION.handles("space_time_file")
def space_time_file(session: "Session", request: Request) -> None:
    """Write the section along a line over the whole run as a picture or a table.

    Of two runs each comes as one ``beside`` the other: with a name, and the limits of colours for both.
    """
    target = session.workspace.new_export(str(request["name"]))
    worker = session.workers[request.get("run") or FIRST]
    given = {"line": request["line"], "beside": request.get("beside"), "id": request.get("id")}
    worker.send("space_time_to", target=str(target), **given)


@SESSION.handles("report")
def report(session: "Session", request: Request) -> None:
    """Write the report that compares both runs up to step ``until``."""
    session.reports.begin(int(request["until"]), request.get("id"))


@SESSION.handles("cancel")
def cancel(session: "Session", request: Request) -> None:
    """Break off the answer to the request with the id ``of``."""
    session.reports.break_off(request.get("of"))
    session.joint.break_off(request.get("of"))
    for worker in session.workers.values():
        worker.send("break_off", of=request.get("of"))


@SESSION.handles("open")
def open_run(session: "Session", request: Request) -> None:
    """Continue a run of the session's folder, or two that were saved together."""
    folder = session.workspace.run(str(request["name"]))
    if folder.name not in session.workspace.runs():
        raise BarchanError(f"no run '{folder.name}' in {session.workspace.folder}")
    folders = read_together(folder).folders if is_together(folder) else [folder]
    open_together(session, folders, request.get("id"))


@SESSION.handles("open_unfinished")
def open_unfinished(session: "Session", request: Request) -> None:
    """Go on with what a studio that ended unexpectedly has left."""
    adopted = session.unfinished.open(str(request["name"]))
    open_together(session, adopted.runs.folders, request.get("id"), adopted)


@SESSION.handles("discard_unfinished")
def discard_unfinished(session: "Session", request: Request) -> None:
    """Delete what a studio that ended unexpectedly has left."""
    session.unfinished.discard(str(request["name"]))
    session.tell("done", id=request.get("id"))


def _model_beside(scenario: dict[str, Any], name: Any) -> dict[str, Any]:
    if name not in models():
        raise BarchanError(f"no model '{name}'; allowed: {', '.join(models())}")
    own: dict[str, Any] = scenario["model"]
    return own if own["name"] == name else {"name": name}


def with_value(scenario: dict[str, Any], key: str, value: Any) -> dict[str, Any]:
    """Data of a scenario with another value at a dotted key; raises BarchanError where it has no such key."""
    first, _, rest = key.partition(".")
    if first not in scenario:
        raise BarchanError(f"the scenario has no '{first}'")
    if not rest:
        return {**scenario, first: value}
    group = scenario[first]
    if not isinstance(group, dict):
        raise BarchanError(f"'{first}' of the scenario has no '{rest}'")
    return {**scenario, first: with_value(group, rest, value)}


def _checked(session: "Session", scenario: Any) -> dict[str, Any]:
    """Data of a scenario that may be started; raises ScenarioError for any other."""
    session.workspace.check(scenario)
    return validate(scenario).seeded().data()


def _id_of(request: Request) -> Request:
    """The id of a request, for the worker that answers it when it has begun."""
    return {"id": request["id"]} if request.get("id") is not None else {}
