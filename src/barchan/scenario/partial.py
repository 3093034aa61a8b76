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
        found = {_innermost(data, path_of(problem.key)) for problem in left.problems} - {()}
        if not found:
            break
        for path in sorted(found, key=_in_order, reverse=True):  # from the end: an item moves those behind it
            _drop(data, path)
        try:
            return validate(data, name), first.problems
        except ScenarioError as error:
            left = error
    raise first


def changes(text: str, name: str, usable: Scenario) -> list[str]:
    """What of a text's groups is not in its usable part, and what takes its place, a line each.

    Single values are left to the problems.
    """
    data, _, _ = parse(text, name)
    taken, said = usable.data(), []
    for group, given in data.items() if isinstance(data, dict) else ():
        if not isinstance(given, dict) or not isinstance(now := taken.get(group), dict):
            continue
        kind, before = now.get("kind", now.get("name")), given.get("kind", given.get("name"))
        if before is not None and before != kind:
            said.append(f"{group}: {kind}, with its defaults, takes the place of {before}, which is left out")
            continue
        for key, items in given.items():
            left = now.get(key)
            if isinstance(items, list) and isinstance(left, list) and len(left) < len(items):
                said.append(f"{group}.{key}: {len(left)} of {len(items)} are used, the others are left out")
    return said


def _innermost(data: dict[str, Any], path: Path) -> Path:
    """A path, or that of the innermost group that should hold it; empty for the whole text."""
    group: Any = data
    for at, step in enumerate(path):
        if not _has(group, step):
            return path if path == ("barchan",) else path[:at]
        group = group[step]
    return path


def _in_order(path: Path) -> list[str]:
    return [f"{step:09}" if isinstance(step, int) else step for step in path]


def _drop(data: dict[str, Any], path: Path) -> None:
    """Remove what is at a path; another format's number becomes today's."""
    if path == ("barchan",):
        data["barchan"] = Scenario.model_fields["barchan"].default
        return
    group: Any = data
    for step in path[:-1]:
        group = group[step]
    del group[path[-1]]


def _has(group: Any, step: str | int) -> bool:
    if isinstance(group, list):
        return isinstance(step, int) and step < len(group)
    return isinstance(group, dict) and step in group
