"""Reading a scenario's text, and the usable part of a text that has mistakes."""

from typing import Any

from barchan.errors import Problem, ScenarioError
from barchan.scenario.definition import Scenario
from barchan.scenario.files import validate
from barchan.scenario.source_map import Path, parse, path_of


def read_text(text: str, name: str) -> Scenario:
    """The scenario in a file's text; raises ScenarioError with every problem, each with its line."""
    data, lines, problems = parse(text, name)
    if data is None and problems:
        raise ScenarioError(problems, name)
    return validate(data, name, lines, problems=problems)


def salvage(text: str, name: str) -> tuple[Scenario, list[Problem]]:
    """The valid part of a scenario's text, with defaults for the rest, and the problems.

    Raises ScenarioError where nothing of the text can be used.
    """
    try:
        return read_text(text, name), []
    except ScenarioError as error:
        first = error
    data, _, _ = parse(text, name)
    left = first
    while isinstance(data, dict):
        dropped = [_drop(data, path_of(problem.key)) for problem in left.problems]
        if not any(dropped):
            break
        try:
            return validate(data, name), first.problems
        except ScenarioError as error:
            left = error
    raise first


def _drop(data: dict[str, Any], path: Path) -> bool:
    """Remove a key, or where it is not there the innermost group that should hold it."""
    if path == ("barchan",):
        data["barchan"] = Scenario.model_fields["barchan"].default
        return True
    group: Any = data
    trail = []
    for step in path:
        if not _has(group, step):
            break
        trail.append((group, step))
        group = group[step]
    if not trail:
        return False
    owner, last = trail[-1]
    del owner[last]
    return True


def _has(group: Any, step: str | int) -> bool:
    if isinstance(group, list):
        return isinstance(step, int) and step < len(group)
    return isinstance(group, dict) and step in group
