"""Configuration files and presets: reading, overriding, validating."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import replace
from importlib.resources import files
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from barchan.errors import Problem, ScenarioError
from barchan.scenario.definition import Scenario
from barchan.scenario.from_ground import measure, spelt_out
from barchan.scenario.messages import nearest, problems_of
from barchan.scenario.migrations import migrate
from barchan.scenario.source_map import Path as KeyPath
from barchan.scenario.source_map import SourceMap, parse, path_of

Override = tuple[str, str]
"""A dotted key and the text given for it, as on a command line."""


def preset_names() -> list[str]:
    """Names of the shipped scenarios."""
    folder = files("barchan.presets")
    return sorted(f.name.removesuffix(".json") for f in folder.iterdir() if f.name.endswith(".json"))


def load_scenario(source: str | Path | Mapping[str, Any], overrides: Sequence[Override] = ()) -> Scenario:
    """A scenario from a preset's name, a JSON file or plain data, with single values overridden.

    A ``path`` within a file starts where the file lies, elsewhere in the working folder.
    Raises ScenarioError with every problem found: unknown keys, wrong types, values out of range.
    """
    if isinstance(source, Mapping):
        return validate(dict(source), overrides=overrides)
    name, text = _find(str(source))
    data, lines, problems = parse(text, name)
    if data is None and problems:
        raise ScenarioError(problems, name)
    _anchor(data, Path(source).absolute().parent)
    return validate(data, name, lines, overrides, problems)


def validate(
    data: Any,
    name: str = "scenario",
    lines: Mapping[KeyPath, int] | None = None,
    overrides: Sequence[Override] = (),
    problems: Sequence[Problem] = (),
) -> Scenario:
    """A scenario from plain data; ``lines`` holds the line of each key in the file ``name``."""
    found = list(problems)
    if not isinstance(data, dict):
        raise ScenarioError([Problem("", "must be a JSON object { … }", name)], name)
    data = {key: value for key, value in json.loads(json.dumps(data)).items() if key != "$schema"}
    data, trouble = migrate(data)
    found += [Problem("barchan", trouble, name)] if trouble else []
    spelt_out(data)
    given: set[KeyPath] = set()
    for key, text in overrides:
        path = tuple(key.replace("-", "_").split("."))
        given.add(path)
        found += _override(data, path, text)
        spelt_out(data)

    _name_variants(data)

    source_map = SourceMap(name, lines or {}, given)
    found += [replace(p, place=source_map.of(path_of(p.key))) for p in measure(data, given)]
    try:
        scenario = Scenario.model_validate_json(json.dumps(data))
    except ValidationError as error:
        found += problems_of(error, Scenario, data, source_map.of)
        raise ScenarioError(found, name) from None
    if found:
        raise ScenarioError(found, name)
    return scenario.with_source_map(source_map)


def _name_variants(data: dict[str, Any]) -> None:
    """Where a group of several variants does not say which one it is, it is the one that is the default."""
    for name, field in Scenario.model_fields.items():
        default = field.get_default(call_default_factory=True)
        tag = getattr(default, "kind_key", "")
        if tag and isinstance(data.get(name), dict) and tag not in data[name]:
            data[name] = {tag: getattr(default, tag), **data[name]}


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


def _anchor(data: Any, folder: Path) -> None:
    """Let every ``path`` in a file's data start where the file lies."""
    inner = data if isinstance(data, list) else data.values() if isinstance(data, dict) else ()
    for item in inner:
        _anchor(item, folder)
    if isinstance(data, dict) and isinstance(data.get("path"), str):
        data["path"] = str(folder / data["path"])


def value_of(text: str) -> Any:
    """A value that was given as text: as JSON where it is, as the text itself elsewhere."""
    try:
        return json.loads(text, parse_constant=str)
    except json.JSONDecodeError:
        return text


def _override(data: dict[str, Any], path: KeyPath, text: str) -> list[Problem]:
    """Set one value in plain data."""
    group: Any = data
    for at, step in enumerate(path[:-1]):
        inner = group.setdefault(step, {}) if isinstance(group, dict) else None
        if inner is None and isinstance(group, dict):
            inner = group[step] = {}
        if not isinstance(inner, dict):
            return [Problem(".".join(map(str, path[: at + 1])), "is not a group of keys", "command line")]
        group = inner
    value = value_of(text)
    field = Scenario.model_fields.get(str(path[0])) if len(path) == 1 else None
    if field is not None and field.annotation is str and not isinstance(value, str):
        value = text
    group[path[-1]] = value
    return []
