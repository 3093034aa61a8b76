"""Configuration files and presets: reading, overriding, validating."""

import json
from collections.abc import Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import replace
from importlib.resources import files
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from barchan.errors import Problem, ScenarioError
from barchan.scenario.changes import with_changes_told
from barchan.scenario.definition import Scenario
from barchan.scenario.from_ground import measure, spelt_out
from barchan.scenario.from_record import as_long_as_record, without_record
from barchan.scenario.messages import nearest, problems_of, wrong_paths
from barchan.scenario.migrations import migrate
from barchan.scenario.overrides import (
    COMMAND_LINE,
    Origin,
    Override,
    Switch,
    default_kind,
    given_values,
    leave_behind,
    set_value,
    switches,
)
from barchan.scenario.paths import anchored
from barchan.scenario.source_map import TOO_DEEP, SourceMap, is_too_deep, parse, path_of
from barchan.scenario.source_map import Path as KeyPath


def preset_names() -> list[str]:
    """Names of the shipped scenarios."""
    folder = files("barchan.presets")
    return sorted(f.name.removesuffix(".json") for f in folder.iterdir() if f.name.endswith(".json"))


def load_scenario(
    source: str | Path | Mapping[str, Any],
    overrides: Sequence[Override] = (),
    origin: Origin = COMMAND_LINE,
) -> Scenario:
    """A scenario from a preset's name, a JSON file or plain data, with single values overridden.

    A ``path`` within a file starts where the file lies, elsewhere in the working folder. Title and citation
    of a scenario whose values are overridden say so. Raises ScenarioError with every problem found: unknown
    keys, wrong types, values out of range.
    """
    lines: Mapping[KeyPath, int] = {}
    problems: list[Problem] = []
    if isinstance(source, Mapping):
        name, data = "scenario", anchored(dict(source), Path.cwd())
    else:
        name, text = _find(str(source))
        data, lines, problems = parse(text, name)
        if data is None and problems:
            raise ScenarioError(problems, name)
        data = anchored(data, Path(source).absolute().parent)
    if not overrides:
        return validate(data, name, lines, problems=problems)
    scenario = validate(data, name, lines, overrides, problems, origin)
    try:
        before = validate(data, name)
    except ScenarioError:
        return scenario
    return with_changes_told(scenario, before)


def validate(
    data: Any,
    name: str = "scenario",
    lines: Mapping[KeyPath, int] | None = None,
    overrides: Sequence[Override] = (),
    problems: Sequence[Problem] = (),
    origin: Origin = COMMAND_LINE,
) -> Scenario:
    """A scenario from plain data; ``lines`` holds the line of each key in the file ``name``.

    An override that chooses another variant of a group drops those keys of the data that it does not have.
    """
    found = list(problems)
    if not isinstance(data, dict):
        raise ScenarioError([Problem("", "must be a JSON object { … }", name)], name)
    data = {key: value for key, value in _plain(data, name).items() if key != "$schema"}
    data, trouble = migrate(data)
    found += [Problem("barchan", trouble, name)] if trouble else []
    spelt_out(data)
    given, unknown = given_values(overrides, origin)
    found += unknown
    switched = list(switches(data, given))
    for one in given:
        found += set_value(data, one, origin)
        spelt_out(data)

    _name_variants(data)

    paths = frozenset(one.path for one in given)
    source_map = SourceMap(name, lines or {}, paths, origin.place)
    found += [replace(p, place=source_map.of(path_of(p.key))) for p in measure(data, paths)]
    as_record = without_record(data)
    left: dict[Switch, list[str]] = {}
    while True:
        try:
            scenario = Scenario.model_validate_json(json.dumps(data))
            break
        except ValidationError as error:
            if not _left_behind(data, switched, wrong_paths(error, data), paths, left):
                found += problems_of(error, Scenario, data, source_map.of)
                raise ScenarioError(found, name) from None
    if found:
        raise ScenarioError(found, name)
    notes = tuple(switch.note(keys) for switch, keys in left.items())
    scenario = scenario.with_source_map(replace(source_map, notes=notes))
    return as_long_as_record(scenario) if as_record else scenario


def _left_behind(
    data: dict[str, Any],
    switched: Sequence[Switch],
    wrong: Sequence[KeyPath],
    given: AbstractSet[KeyPath],
    left: dict[Switch, list[str]],
) -> bool:
    """Whether keys that a switched variant does not have were dropped from the data; noted in ``left``."""
    dropped = {switch: leave_behind(data, switch, wrong, given) for switch in switched}
    for switch, keys in dropped.items():
        if keys:
            left.setdefault(switch, []).extend(keys)
    return any(dropped.values())


def _plain(data: dict[str, Any], name: str) -> dict[str, Any]:
    """A deep copy of plain data; raises ScenarioError where it is no plain data."""
    try:
        if is_too_deep(data):
            raise ScenarioError([Problem("", TOO_DEEP, name)], name)
        plain: dict[str, Any] = json.loads(json.dumps(data))
    except (TypeError, ValueError) as error:
        raise ScenarioError([Problem("", f"cannot be written as JSON: {error}", name)], name) from None
    return plain


def _name_variants(data: dict[str, Any]) -> None:
    """Where a group of several variants does not say which one it is, it is the one that is the default."""
    for name, field in Scenario.model_fields.items():
        tag = getattr(field.get_default(call_default_factory=True), "kind_key", "")
        if tag and isinstance(data.get(name), dict) and tag not in data[name]:
            data[name] = {tag: default_kind(field, tag), **data[name]}


def _find(source: str) -> tuple[str, str]:
    """A preset's or a file's name and text."""
    if source in preset_names():
        return f"preset {source}", files("barchan.presets").joinpath(f"{source}.json").read_text("utf-8")
    path = Path(source)
    if path.is_file():
        try:
            return str(path), path.read_text("utf-8")
        except (OSError, UnicodeDecodeError) as error:
            raise ScenarioError([Problem("", f"cannot be read: {error}", source)], source) from None
    known = ", ".join(preset_names())
    message = f"no preset and no file of this name{nearest(source, preset_names())}; presets: {known}"
    raise ScenarioError([Problem("", message)], f"'{source}'")
