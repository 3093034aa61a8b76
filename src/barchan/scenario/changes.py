"""A scenario whose values were changed says so where it names itself."""

import json
from pathlib import Path as FilePath
from typing import Any

from barchan.scenario.definition import Scenario
from barchan.scenario.source_map import Path, dotted

_CHANGED = "changed: "

_UNCHANGED = "(without these changes) "
"""Stands before ``look_for`` of a scenario whose values were changed since."""

_LONGEST = 2000
"""Characters of what to look for at most."""

_OWN_WORDS = ("title", "citation", "look_for", "question", "note", "run")
"""Keys whose values do not make another scenario: its own words, and how long it runs."""


def with_changes_told(scenario: Scenario, before: Scenario) -> Scenario:
    """The scenario with the given values that differ from those of ``before`` in its title and citation.

    ``look_for`` is marked as that of the scenario before; it and ``question`` are left out where the model is
    another one.
    Words that were given themselves stay, and so do empty ones.
    """
    told = _told(scenario, before)
    if not told:
        return scenario
    words = {
        name: _longer(getattr(scenario, name), told, separator, limit)
        for name, separator, limit in (("title", ", ", 200), ("citation", "; ", 1000))
        if getattr(scenario, name) and (name,) not in scenario.source_map.given
    }
    if scenario.look_for and ("look_for",) not in scenario.source_map.given:
        words["look_for"] = _expected(scenario, before)
    if scenario.model.name != before.model.name and ("question",) not in scenario.source_map.given:
        words["question"] = ""
    return scenario.model_copy(update=words)


def _expected(scenario: Scenario, before: Scenario) -> str:
    """``look_for`` once values differ from those that it was written for."""
    if scenario.model.name != before.model.name:
        return ""
    text = scenario.look_for
    return text if text.startswith(_UNCHANGED) else f"{_UNCHANGED}{text}"[:_LONGEST]


def _told(scenario: Scenario, before: Scenario) -> str:
    now, then = scenario.data(), before.data()
    given = sorted(scenario.source_map.given, key=str)
    different = [path for path in given if path[0] not in _OWN_WORDS and _at(now, path) != _at(then, path)]
    return ", ".join(f"{dotted(path)}{_shown(path, _at(now, path))}" for path in different)


def _at(data: Any, path: Path) -> Any:
    for step in path:
        data = data.get(step) if isinstance(data, dict) else None
    return data


def _shown(path: Path, value: Any) -> str:
    """A value after its key; whole groups are named by their key alone, files without their folder."""
    if isinstance(value, dict | list):
        return ""
    if path[-1] == "path":
        return f" {FilePath(str(value)).name}"
    if isinstance(value, float):
        return f" {value:g}"
    return f" {value if isinstance(value, str) else json.dumps(value)}"


def _longer(words: str, told: str, separator: str, limit: int) -> str:
    already = _CHANGED in words
    text = f"{words}, {told}" if already else f"{words}{separator}{_CHANGED}{told}"
    return text if len(text) <= limit else f"{text[: limit - 1]}…"
