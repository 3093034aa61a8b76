"""Errors of pydantic in the words of a scenario's user."""

import difflib
import json
from collections.abc import Callable, Iterable
from functools import lru_cache
from typing import Any

from pydantic import BaseModel, ValidationError

from barchan.errors import Problem
from barchan.parameters import NOTE, allowed, declarations, variants
from barchan.scenario.source_map import Path, dotted

LONGEST = 60
"""Characters of a value that a message shows."""


def nearest(name: str, names: Iterable[str]) -> str:
    """``; did you mean 'x'?`` for the name nearest to a mistyped one, or nothing."""
    if len(name) > LONGEST:  # the search takes time with the square of the length
        return ""
    found = difflib.get_close_matches(name, list(names), n=1, cutoff=0.5)
    return f"; did you mean '{found[0]}'?" if found else ""


def problems_of(
    error: ValidationError, root: type[BaseModel], data: Any, place: Callable[[Path], str]
) -> list[Problem]:
    """Every problem of a validation error, each with key, value, allowed values and place."""
    found: dict[Path, Problem] = {}
    for item in error.errors(include_url=False):
        if "found" in item.get("ctx", {}):
            for path, message in item["ctx"]["found"]:
                found.setdefault(path, Problem(dotted(path), message, place(path)))
            continue
        path = _path_of(item, data)
        owner, field = owner_of(root, data, path)
        message = _message(item, owner, field)
        if item["type"] == "extra_forbidden":
            message = _elsewhere(root, path, owner) or message
        if item["type"] == "union_tag_not_found":
            message += _kinds(owner_of(root, data, path[:-1])[1], str(path[-1]))
        found.setdefault(path, Problem(dotted(path), message, place(path)))
    return [
        problem for path, problem in found.items() if not any(path[:n] in found for n in range(len(path)))
    ]


def wrong_paths(error: ValidationError, data: Any) -> list[Path]:
    """The keys at which data are not valid by themselves, whatever else they hold."""
    items = error.errors(include_url=False)
    return [_path_of(item, data) for item in items if "found" not in item.get("ctx", {})]


def _path_of(item: Any, data: Any) -> Path:
    path = _path_in(data, item["loc"])
    if item["type"] == "missing":
        path += (item["loc"][-1],)
    if item["type"].startswith("union_tag"):
        path += (item["ctx"]["discriminator"].strip("'"),)
    return path


def _path_in(data: Any, location: tuple[str | int, ...]) -> Path:
    """The path in the data itself: without the names that pydantic puts in for variants and types."""
    path: list[str | int] = []
    for step in location:
        known = step in data if isinstance(data, dict) else isinstance(data, list) and isinstance(step, int)
        if known:
            path.append(step)
            data = data[step]
    return tuple(path)


def owner_of(root: type[BaseModel], data: Any, path: Path) -> tuple[type[BaseModel] | None, Any]:
    """The group a path's last key belongs to, and the field's declaration there, if any."""
    owner: type[BaseModel] | None = root
    field = None
    for at, step in enumerate(path):
        if isinstance(step, int):
            data = data[step] if isinstance(data, list) and step < len(data) else None
            continue
        field = owner.model_fields.get(step) if owner is not None else None
        data = data.get(step) if isinstance(data, dict) else None
        if at < len(path) - 1:
            owner = _group_of(field.annotation, data) if field is not None else None
    return owner, field


def _group_of(annotation: Any, data: Any) -> type[BaseModel] | None:
    """The class of parameters that the data at hand is validated as."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return annotation
    sample = data[0] if isinstance(data, list) and data else data
    candidates = [c for c in (_group_of(a, data) for a in getattr(annotation, "__args__", ())) if c]
    for candidate in candidates:
        key = getattr(candidate, "kind_key", "")
        if key and isinstance(sample, dict) and candidate.model_fields[key].default == sample.get(key):
            return candidate
    return candidates[0] if candidates else None


def _kinds(field: Any, tag: str) -> str:
    """The kinds of a group that does not say which it is."""
    found = [] if field is None else variants(field.annotation)
    names = [str(kind.model_fields[tag].default) for kind in found if tag in kind.model_fields]
    return f"; allowed: {', '.join(names)}" if names else ""


def _message(item: Any, owner: type[BaseModel] | None, field: Any) -> str:
    kind, value, context = item["type"], item["input"], item.get("ctx", {})
    if kind == "extra_forbidden":
        names = [n for n in owner.model_fields if n != NOTE] if owner is not None else []
        name = str(item["loc"][-1])
        return f"unknown key{nearest(name, names)}; known here: {', '.join(names)}"
    if kind == "union_tag_invalid":
        tags = [tag.strip().strip("'") for tag in context["expected_tags"].split(",")]
        tag = context["tag"]
        return f"is '{tag}'{nearest(tag, tags)}; allowed: {', '.join(tags)}"
    if kind == "union_tag_not_found":
        return "is missing"
    if kind == "missing":
        return f"is missing; allowed: {allowed(field)}" if field is not None else "is missing"
    if kind == "value_error":
        return str(context["error"])
    if field is not None:
        choices = allowed(field).replace("'", "").split(" | ")
        hint = nearest(value, choices) if isinstance(value, str) and len(choices) > 1 else ""
        return f"is {value_text(value)}{hint}; allowed: {allowed(field)}"
    return str(item["msg"])


def _elsewhere(root: type[BaseModel], path: Path, owner: type[BaseModel] | None) -> str:
    """The place of a key that is unknown where it stands and known elsewhere; empty where it is nowhere."""
    name = str(path[-1])
    if owner is root:
        inner = _groups_with(root, name)
        return f"unknown key; it belongs to {' or '.join(inner)}" if inner else ""
    if name in root.model_fields:
        group = "a group" if variants(root.model_fields[name].annotation) else "a key"
        return f"unknown key here; '{name}' is {group} of its own, beside {path[0]}"
    inner = _groups_with(root, name)
    if not inner or dotted(path[:-1]) in inner:
        return ""
    return f"unknown key here; it belongs to {' or '.join(inner)}"


def _groups_with(root: type[BaseModel], name: str) -> list[str]:
    """The groups of a scenario that have a key of that name, as dotted paths; variants count once."""
    return list(_groups_by_key(root).get(name, ()))


@lru_cache(maxsize=8)
def _groups_by_key(root: type[BaseModel]) -> dict[str, dict[str, None]]:
    """For each last part of a key the groups that have it; made once: files may hold thousands of errors."""
    found: dict[str, dict[str, None]] = {}
    for top, field in root.model_fields.items():
        for group in variants(field.annotation):
            for declared in declarations(group, f"{top}."):
                owner, _, name = declared.key.rpartition(".")
                found.setdefault(name, {})[owner] = None
    return found


def value_text(value: Any) -> str:
    """A value of plain data as its user wrote it, long ones cut."""
    text = repr(value) if isinstance(value, str) else json.dumps(value, ensure_ascii=False, default=repr)
    return text if len(text) <= LONGEST else f"{text[:LONGEST]}…"
