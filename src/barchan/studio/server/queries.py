"""Questions that are answered without any worker."""

from collections.abc import Callable
from typing import Any

from barchan.errors import BarchanError, Problem, ScenarioError
from barchan.scenario import FORMAT, load_scenario, preset_names, validate
from barchan.scenario.partial import changes, salvage
from barchan.scenario.source_map import parse
from barchan.studio.commands import Handlers
from barchan.studio.protocol import Request
from barchan.studio.server.workspace import Workspace

QUERIES: Handlers[Callable[[Workspace, Request], dict[str, Any]]] = Handlers("query")


@QUERIES.handles("check")
def check(workspace: Workspace, request: Request) -> dict[str, Any]:
    """The problems of a scenario's text, and the part of it that can be used."""
    text, name = str(request["text"]), str(request.get("name", "scenario"))
    try:
        workspace.check(parse(text, name)[0])  # a lattice may be taken from the ground's file
        scenario, problems = salvage(text, name)
    except ScenarioError as error:
        return {"scenario": None, "problems": _plain(workspace, error.problems)}
    return {
        "scenario": scenario.data(),
        "problems": _plain(workspace, problems),
        "changes": changes(text, name, scenario) if problems else [],
    }


def _plain(workspace: Workspace, problems: list[Problem]) -> list[dict[str, Any]]:
    return workspace.plainly("", [vars(problem) for problem in problems])[1]


@QUERIES.handles("preset")
def preset(_: Workspace, request: Request) -> dict[str, Any]:
    """A preset's complete scenario."""
    if request["name"] not in preset_names():
        raise BarchanError(f"no preset '{request['name']}'")
    return {"scenario": load_scenario(request["name"]).data()}


@QUERIES.handles("variant")
def variant(_: Workspace, request: Request) -> dict[str, Any]:
    """A group of a scenario with all its defaults, such as another model or another ground.

    ``beside`` holds the groups that it has to go together with, such as the model under a wind.
    """
    group = str(request["group"])
    beside = dict(request.get("beside") or {})
    data = validate({"barchan": FORMAT, **beside, group: request["value"]}).data()
    return {"group": group, "value": data[group]}


@QUERIES.handles("saved")
def saved(workspace: Workspace, _: Request) -> dict[str, Any]:
    """Names of the runs that can be opened."""
    return {"saved": workspace.runs(), "folder": str(workspace.folder)}
