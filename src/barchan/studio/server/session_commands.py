"""The commands that the session carries out itself: they begin, end, save and open whole runs."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from barchan.errors import BarchanError
from barchan.models import models
from barchan.scenario import validate
from barchan.studio.commands import Handlers
from barchan.studio.protocol import Request

if TYPE_CHECKING:
    from barchan.studio.server.session import Session

FIRST, SECOND = "a", "b"

SESSION: Handlers[Callable[["Session", Request], None]] = Handlers("session")


@SESSION.handles("create")
def create(session: "Session", request: Request) -> None:
    """Start a scenario; where there are two workers in the other one, too, with its own model."""
    session.workspace.check(request["scenario"])
    data = validate(request["scenario"]).seeded().data()
    name = SECOND if session.lockstep is not None and request.get("run") == SECOND else FIRST
    begun = {name: data}
    answering = _answer_of(name, request)
    if session.lockstep is not None:
        other = FIRST if name == SECOND else SECOND
        newest = session.starts.scenario(other) or session.scenarios[other]
        begun[other] = {**data, "model": newest["model"]}
    session.begin(begun, bool(request.get("running", True)), answering)


@SESSION.handles("compare")
def compare(session: "Session", request: Request) -> None:
    """Run another model beside, on the same ground, under the same wind, from the same seed.

    The model that runs already begins with the values that it has; any other with its defaults.
    """
    first, name = session.scenarios[FIRST], request["model"]
    if name not in models():
        raise BarchanError(f"no model '{name}'; allowed: {', '.join(models())}")
    model = first["model"] if first["model"]["name"] == name else {"name": name}
    second = validate({**first, "model": model}).data()
    session.begin({FIRST: first, SECOND: second}, True, _answer_of(SECOND, request))
    session.report_runs()


@SESSION.handles("alone")
def alone(session: "Session", _: Request) -> None:
    """End the second simulation."""
    session.end_second()


@SESSION.handles("revive")
def revive(session: "Session", request: Request) -> None:
    """Start lost workers again: from the states kept after step ``kept``, or from their beginning."""
    if request.get("kept") is not None:
        session.resume(int(request["kept"]))
    elif session.scenarios:
        session.begin(dict(session.scenarios), running=True)
    else:
        session.start_run(FIRST, session.first)


@SESSION.handles("save")
def save(session: "Session", request: Request) -> None:
    """Save a run as an archive in the session's folder."""
    folder = session.workspace.new_run(str(request["name"]))
    worker = session.workers[request.get("run") or FIRST]
    worker.send("save_folder", folder=str(folder), id=request.get("id"))


@SESSION.handles("open")
def open_run(session: "Session", request: Request) -> None:
    """Continue an archive of the session's folder."""
    folder = session.workspace.run(str(request["name"]))
    if folder.name not in session.workspace.runs():
        raise BarchanError(f"no run '{folder.name}' in {session.workspace.folder}")
    session.end_second()
    session.start_run(FIRST, {"command": "open_folder", "folder": str(folder), "id": request.get("id")})


def _answer_of(name: str, request: Request) -> dict[str, Request]:
    """The id of a request that a worker answers when it has begun, by the worker's name."""
    return {name: {"id": request["id"]}} if request.get("id") is not None else {}
