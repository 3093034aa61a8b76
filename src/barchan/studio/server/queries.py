"""Questions that are answered without any worker."""

from collections.abc import Callable
from typing import Any

from barchan.errors import BarchanError, ScenarioError
from barchan.scenario import load_scenario, preset_names, validate
from barchan.scenario.partial import salvage
from barchan.studio.server.workspace import Store

Question = dict[str, Any]


def check(_: Store, question: Question) -> dict[str, Any]:
    """What is wrong with a scenario's text, and what can be used of it."""
    try:
        scenario, problems = salvage(str(question["text"]), str(question.get("name", "scenario")))
    except ScenarioError as error:
        return {"scenario": None, "problems": [vars(problem) for problem in error.problems]}
    return {"scenario": scenario.data(), "problems": [vars(problem) for problem in problems]}


def preset(_: Store, question: Question) -> dict[str, Any]:
    """A preset's complete scenario."""
    if question["name"] not in preset_names():
        raise BarchanError(f"no preset '{question['name']}'")
    return {"scenario": load_scenario(question["name"]).data()}


def variant(_: Store, question: Question) -> dict[str, Any]:
    """A group of a scenario with all its defaults, such as another model or another ground."""
    group = str(question["group"])
    data = validate({"barchan": 1, group: question["value"]}).data()
    return {"group": group, "value": data[group]}


def saved(store: Store, _: Question) -> dict[str, Any]:
    """Names of the runs that can be opened."""
    return {"saved": store.runs(), "folder": str(store.folder)}


ANSWERS: dict[str, Callable[[Store, Question], dict[str, Any]]] = {
    "check": check,
    "preset": preset,
    "variant": variant,
    "saved": saved,
}
