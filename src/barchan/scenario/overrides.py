"""Single values set over a scenario's data, on the command line or as arguments in Python."""

import json
from collections.abc import Iterable, Iterator, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from pathlib import Path as FilePath
from typing import Any

from barchan.errors import Problem
from barchan.lattice import Lattice
from barchan.parameters import NOTE, variants
from barchan.scenario.definition import Run, Scenario
from barchan.scenario.listing import all_keys
from barchan.scenario.messages import nearest, owner_of
from barchan.scenario.paths import anchored
from barchan.scenario.source_map import Path, dotted

Override = tuple[str, str]
"""A dotted key and the text given for it, as on a command line."""

_SHORT = {
    name: group
    for group, parameters in (("run", Run), ("lattice", Lattice))
    for name in parameters.model_fields
    if name not in (NOTE, "kind")
}
"""Keys that may be given without the name of their group, and the group of each."""


@dataclass(frozen=True)
class Origin:
    """Where values are given, and how a key is written there."""

    word: str
    prefix: str
    dot: str

    def written(self, key: str) -> str:
        """A dotted key as it is written there."""
        return self.prefix + key.replace(".", self.dot)

    def place(self, path: Path) -> str:
        """The place of a key, for messages."""
        return self.word if self.prefix else f"{self.word} {self.written(dotted(path))}"


COMMAND_LINE = Origin("command line", "--", ".")
ARGUMENT = Origin("argument", "", "__")


@dataclass(frozen=True)
class Given:
    """A value given for a key."""

    path: Path
    value: Any


def value_of(text: str) -> Any:
    """A value that was given as text: as JSON where it is, as the text itself elsewhere."""
    try:
        return json.loads(text, parse_constant=str)
    except (ValueError, RecursionError):
        return text


def given_values(overrides: Sequence[Override], origin: Origin) -> tuple[list[Given], list[Problem]]:
    """The keys and values that are given; a ``path`` starts in the working folder.

    ``seed``, ``rows`` and other keys of ``run`` and ``lattice`` need no group; a variant's name may stand for
    its group, as in ``--model ripples``.
    """
    found, problems = [], []
    for key, text in overrides:
        path = full_path(key)
        if path is None:
            hint = hint_for(key, origin)
            problems.append(Problem(key, f"is no key of a scenario{hint}", origin.place((key,))))
            continue
        path, value = _variant_named(path, _typed(path, value_of(text)))
        value = anchored({path[-1]: value}, FilePath.cwd())[path[-1]]
        found.append(Given(path, value))
    return found, problems


def full_path(key: str) -> Path | None:
    """The path of a key as a user gives it; None where no group of a scenario begins like this."""
    path: tuple[str, ...] = tuple(key.replace("-", "_").split("."))
    if path[0] in Scenario.model_fields:
        return path
    return (_SHORT[path[0]], *path) if len(path) == 1 and path[0] in _SHORT else None


def hint_for(key: str, origin: Origin, options: Iterable[str] = ()) -> str:
    """``; did you mean …?`` with the complete keys whose last part is the one given, or nearest to it."""
    name = key.replace("-", "_").split(".")[-1]
    by_name: dict[str, list[str]] = {}
    for known in all_keys():
        keys = by_name.setdefault(known.key.rpartition(".")[2], [])
        if known.key not in keys and "[" not in known.key:
            keys.append(known.key)
    if by_name.get(name):
        meant = [origin.written(full).replace("_", "-" if origin.prefix else "_") for full in by_name[name]]
        return f"; did you mean {' or '.join(meant[:_MOST_HINTS])}?"
    words = [*Scenario.model_fields, *_SHORT, *options]
    close = nearest(origin.written(name), map(origin.written, words))
    return close or nearest(name, by_name)


_MOST_HINTS = 4


def _typed(path: Path, value: Any) -> Any:
    """Text where a key of the scenario itself takes text, whatever JSON makes of it."""
    field = Scenario.model_fields.get(str(path[0])) if len(path) == 1 else None
    if field is not None and field.annotation is str and not isinstance(value, str):
        return json.dumps(value)
    return value


def _variant_named(path: Path, value: Any) -> tuple[Path, Any]:
    """A group's variant given by its name alone, as its kind."""
    field = Scenario.model_fields.get(str(path[0]))
    kinds = [] if field is None or len(path) > 1 else variants(field.annotation)
    tag = kinds[0].kind_key if kinds else ""
    return ((*path, tag), value) if tag and isinstance(value, str) else (path, value)


def set_value(data: dict[str, Any], given: Given, origin: Origin) -> list[Problem]:
    """Set one value in plain data."""
    group: Any = data
    for at, step in enumerate(given.path[:-1]):
        inner = group.setdefault(step, {}) if isinstance(group, dict) else None
        if inner is None and isinstance(group, dict):
            inner = group[step] = {}
        if not isinstance(inner, dict):
            path = given.path[: at + 1]
            return [Problem(dotted(path), "is not a group of keys", origin.place(given.path))]
        group = inner
    group[given.path[-1]] = given.value
    return []


@dataclass(frozen=True)
class Switch:
    """A group that is given another variant than the source has."""

    group: Path
    old: str
    new: str

    def note(self, dropped: Sequence[str]) -> str:
        """What was left out because of it."""
        keys = ", ".join(dropped)
        return f"{dotted(self.group)} is {self.new} instead of {self.old}: left out {keys}, of no use there"


def switches(data: dict[str, Any], given: Sequence[Given]) -> Iterator[Switch]:
    """The groups of ``data`` whose variant changes by what is given."""
    for one in given:
        group = _at(data, one.path[:-1])
        if not isinstance(group, dict) or not isinstance(one.value, str):
            continue
        _, field = owner_of(Scenario, data, one.path[:-1])
        kinds = [] if field is None else [kind for kind in variants(field.annotation) if kind.kind_key]
        if not kinds or kinds[0].kind_key != one.path[-1]:
            continue
        old = group.get(one.path[-1], default_kind(field, kinds[0].kind_key))
        names = [kind.model_fields[kind.kind_key].default for kind in kinds]
        if old != one.value and one.value in names:
            yield Switch(one.path[:-1], str(old), one.value)


def default_kind(field: Any, tag: str) -> str | None:
    """The variant that a group of several has by default; None where it has none."""
    default = field.get_default(call_default_factory=True)
    return getattr(default, tag, None)


def _at(data: Any, path: Path) -> Any:
    for step in path:
        data = data.get(step) if isinstance(data, dict) else None
    return data


def leave_behind(
    data: dict[str, Any], switched: Switch, wrong: Iterable[Path], given: AbstractSet[Path]
) -> list[str]:
    """Drop the keys of a switched group at which the new variant fails and that nobody gave; their names."""
    dropped = []
    depth = len(switched.group)
    for path in wrong:
        inside = path[:depth] == switched.group and len(path) > depth
        if not inside or any(path[: len(g)] == g or g[: len(path)] == path for g in given):
            continue
        owner = _at(data, path[:-1])
        if isinstance(owner, dict) and path[-1] in owner:
            del owner[path[-1]]
            dropped.append(dotted(path[depth:]))
    return dropped
