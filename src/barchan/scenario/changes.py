"""A scenario whose values were changed says so where it names itself."""

import json
from pathlib import Path as FilePath
from typing import Any

from barchan.scenario.definition import Scenario
from barchan.scenario.source_map import Path, dotted

UNTITLED = "Untitled scenario"
"""Names a scenario without a title once it was changed."""

_CHANGED = "changed: "

_CUT = "…"
"""Ends words that are too long."""

_UNCHANGED = "(without these changes) "
"""Stands before ``look_for`` of a scenario whose values were changed since."""

_LONGEST = 2000
"""Characters of what to look for at most."""

_WORDS = (("title", ", ", 200), ("citation", "; ", 1000))
"""Keys of the words that list what was changed, what stands before the list, and their longest length."""

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
        name: _longer(getattr(scenario, name), told, separator, limit, scenario)
        for name, separator, limit in _WORDS
        if getattr(scenario, name) and (name,) not in scenario.source_map.given
    }
    if scenario.look_for and ("look_for",) not in scenario.source_map.given:
        words["look_for"] = _expected(scenario, before)
    if scenario.model.name != before.model.name and ("question",) not in scenario.source_map.given:
        words["question"] = ""
    return scenario.model_copy(update=words)


def changed_from(scenario: Scenario, before: Scenario) -> Scenario:
    """The scenario with the words of ``before``, and every value in which it differs told in them.

    Where those name changes already, each key stands once, with the value in force. Without a difference
    the words are those of ``before``. An empty title becomes that of an untitled scenario that was changed;
    other empty words stay empty.
    """
    told = _listed(scenario, _different(scenario.data(), before.data()))
    words = {
        name: _longer(own, told, separator, limit, scenario) if told else own
        for name, separator, limit in _WORDS
        if (own := getattr(before, name) or (UNTITLED if told and name == "title" else ""))
    }
    question = before.question if scenario.model.name == before.model.name else ""
    named = scenario.model_copy(update={**words, "look_for": before.look_for, "question": question})
    return (
        named.model_copy(update={"look_for": _expected(named, before)}) if told and before.look_for else named
    )


def _different(now: Any, then: Any, at: Path = ()) -> list[Path]:
    """Paths at which data differ; of a group that became one of another kind only that."""
    if not isinstance(now, dict) or not isinstance(then, dict):
        return [at] if now != then else []
    kind = next((key for key in ("kind", "name") if key in now and now[key] != then.get(key)), None)
    if kind is not None:
        return [(*at, kind)]
    keys = [key for key in now if at or key not in _OWN_WORDS]
    return [path for key in keys for path in _different(now[key], then.get(key), (*at, key))]


def _expected(scenario: Scenario, before: Scenario) -> str:
    """``look_for`` once values differ from those that it was written for."""
    if scenario.model.name != before.model.name:
        return ""
    text = scenario.look_for
    return text if text.startswith(_UNCHANGED) else f"{_UNCHANGED}{text}"[:_LONGEST]


def _told(scenario: Scenario, before: Scenario) -> list[str]:
    now, then = scenario.data(), before.data()
    given = sorted(scenario.source_map.given, key=str)
    different = [path for path in given if path[0] not in _OWN_WORDS and _at(now, path) != _at(then, path)]
    return _listed(scenario, different)


def _listed(scenario: Scenario, paths: list[Path]) -> list[str]:
    """Keys, each with its value."""
    now = scenario.data()
    return [f"{dotted(path)}{_shown(path, _at(now, path))}" for path in paths]


def _still(listed: str, scenario: Scenario) -> list[str]:
    """Changes that words list already, with the values in force; none of keys that are gone."""
    now = scenario.data()
    changes: list[str] = []
    for piece in listed.split(", "):
        if not changes or _path(piece)[0] in now:
            changes.append(piece)
        else:
            changes[-1] += f", {piece}"
    found = []
    for change in changes:
        path = _path(change)
        group = _at(now, path[:-1])
        if path[0] not in now or change.endswith(_CUT):
            found.append(change)
        elif isinstance(group, dict) and path[-1] in group:
            found += _listed(scenario, [path])
    return found


def _path(change: str) -> Path:
    """The key of a change, of which the value follows."""
    return tuple(change.partition(" ")[0].split("."))


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


def _longer(words: str, told: list[str], separator: str, limit: int, scenario: Scenario) -> str:
    own, already, listed = words.partition(_CHANGED)
    before = _still(listed, scenario) if already else []
    changes = {change.partition(" ")[0]: change for change in (*before, *told)}
    text = f"{own if already else own + separator}{_CHANGED}{', '.join(changes.values())}"
    return text if len(text) <= limit else f"{text[: limit - 1]}{_CUT}"
