"""How a parameter is declared: default, unit, bounds, meaning and source, once and for all.

Command line, configuration files, studio, documentation and validation read them from here.
"""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from types import UnionType
from typing import Any, ClassVar, Literal, Union, get_args, get_origin

from pydantic import BaseModel, ConfigDict, Field
from pydantic.fields import FieldInfo
from pydantic_core import InitErrorDetails, PydanticCustomError

__all__ = ["Declaration", "Parameters", "declarations", "mistake", "parameter"]

NOTE = "note"

GIVEN, NOT_GIVEN = "given", "not given"
"""For ``acts_with``: the parameter acts where another one is given, or where it is not."""


def parameter(
    default: Any = ...,
    *,
    unit: str,
    meaning: str,
    source: str = "",
    live: bool = False,
    group: str = "",
    scale: Literal["linear", "log"] = "linear",
    acts_with: Mapping[str, Any] | None = None,
    **bounds: Any,
) -> Any:
    """Declare a parameter of a ``Parameters`` class.

    ``unit`` is an SI unit, a model's own (``cells``, ``slabs``, ``steps``) or ``-`` for a pure number or a
    choice; ``source`` is the publication or document its default comes from; ``live`` parameters may
    change during a run; ``group`` and ``scale`` serve display. ``acts_with`` names a key of the same group
    and the value with which alone this parameter acts: one of its choices, a list of them, ``GIVEN`` or
    ``NOT_GIVEN``; the meaning says so. ``bounds`` are ``ge``, ``gt``, ``le``, ``lt``, ``min_length`` and
    other constraints of pydantic's ``Field``; where a ``pattern`` is one of them, ``examples`` tell it.
    """
    extra: dict[str, Any] = {"unit": unit, "source": source, "live": live, "group": group, "scale": scale}
    if acts_with is not None:
        extra["acts_with"] = dict(acts_with)
        meaning = f"{meaning} It acts {condition(acts_with)}."
    factory = {"default_factory": default} if callable(default) else {"default": default}
    return Field(description=meaning, json_schema_extra=extra, **factory, **bounds)


def condition(acts_with: Mapping[str, Any]) -> str:
    """Where a parameter acts, in words: ``where neighbourhood is 'moore'``."""
    return " and ".join(f"where {key} is {_wanted(value)}" for key, value in acts_with.items())


def _wanted(value: Any) -> str:
    if value in (GIVEN, NOT_GIVEN):
        return str(value)
    return " or ".join(repr(one) for one in (value if isinstance(value, list) else [value]))


def idle_keys(group: "Parameters", prefix: str = "") -> Iterator[tuple[str, Any, str]]:
    """Parameters that differ from their default and do not act in a group, or in the groups within it.

    Each with its dotted key, its value, and where it would act.
    """
    for name, field in type(group).model_fields.items():
        value = getattr(group, name)
        for at, inner in enumerate(value if isinstance(value, list) else [value]):
            if isinstance(inner, Parameters):
                place = f"{name}[{at}]" if isinstance(value, list) else name
                yield from idle_keys(inner, f"{prefix}{place}.")
        acts_with = _extra(field).get("acts_with", {})
        changed = not field.is_required() and value != field.get_default(call_default_factory=True)
        if changed and not all(_holds(getattr(group, key), wanted) for key, wanted in acts_with.items()):
            yield f"{prefix}{name}", value, condition(acts_with)


def _holds(value: Any, wanted: Any) -> bool:
    if wanted in (GIVEN, NOT_GIVEN):
        return (value is None) == (wanted == NOT_GIVEN)
    return value in wanted if isinstance(wanted, list) else bool(value == wanted)


def redeclared(base: type[BaseModel], name: str, default: Any, source: str) -> Any:
    """The parameter ``name`` of ``base`` with another default (or what makes it), from another source."""
    inherited = base.model_fields[name]
    extra = {**_extra(inherited), "source": source}
    factory = {"default_factory": default} if callable(default) else {"default": default}
    return inherited.merge_field_infos(inherited, **factory, json_schema_extra=extra)


def mistake(place: tuple[str | int, ...], message: str) -> InitErrorDetails:
    """An error at a key of a group, for validators that report several at once."""
    error = PydanticCustomError("value_error", "{error}", {"error": message})
    return InitErrorDetails(type=error, loc=place, input=None)


class Parameters(BaseModel):
    """A group of declared parameters: frozen, strict in types, closed to unknown keys."""

    model_config = ConfigDict(
        frozen=True,
        extra="forbid",
        strict=True,
        allow_inf_nan=False,
        validate_default=True,
        serialize_by_alias=True,
    )

    kind_key: ClassVar[str] = ""
    """The key that distinguishes the variants of this group, where there are any."""

    note: str | list[str] | None = Field(
        default=None, description="A comment, kept but not used.", repr=False
    )

    def __hash__(self) -> int:
        """Of all but the note, with lists taken as tuples."""
        values = (tuple(value) if isinstance(value, list) else value for name, value in self if name != NOTE)
        return hash(tuple(values))


@dataclass(frozen=True)
class Declaration:
    """A declared parameter as others show it."""

    key: str
    type: str
    default: Any
    unit: str
    bounds: str
    meaning: str
    source: str
    live: bool
    group: str
    scale: str
    required: bool


def declarations(parameters: type[Parameters], prefix: str = "") -> Iterator[Declaration]:
    """All parameters of a class and of the groups within it, keys dotted, in order of declaration.

    Where a group has several variants the keys of each follow one another, each begins with its kind.
    """
    for name, field in parameters.model_fields.items():
        if name == NOTE:
            continue
        key = f"{prefix}{name}"
        inner = variants(field.annotation)
        if inner and not _extra(field):
            for group in inner:
                yield from declarations(group, f"{key}.")
            continue
        extra = _extra(field)
        yield Declaration(
            key=key,
            type=type_name(field.annotation),
            default=None if field.is_required() else _plain(field.get_default(call_default_factory=True)),
            unit=extra.get("unit", "-"),
            bounds=allowed(field),
            meaning=field.description or "",
            source=extra.get("source", ""),
            live=extra.get("live", False),
            group=extra.get("group", ""),
            scale=extra.get("scale", "linear"),
            required=field.is_required(),
        )
        for group in inner:
            yield from declarations(group, f"{key}[].")


def _plain(value: Any) -> Any:
    """A default as a scenario file would hold it, without notes."""
    if isinstance(value, list):
        return [_plain(item) for item in value]
    return value.model_dump(exclude={NOTE}) if isinstance(value, Parameters) else value


def _extra(field: FieldInfo) -> dict[str, Any]:
    return field.json_schema_extra if isinstance(field.json_schema_extra, dict) else {}


def variants(annotation: Any) -> list[type[Parameters]]:
    """The classes of parameters that an annotation allows."""
    if isinstance(annotation, type) and issubclass(annotation, Parameters):
        return [annotation]
    return [found for inner in get_args(annotation) for found in variants(inner)]


def type_name(annotation: Any) -> str:
    """A type in words a user knows: ``whole number``, ``yes or no``, the list of choices."""
    plain = {float: "number", int: "whole number", bool: "true or false", str: "text"}
    if annotation in plain:
        return plain[annotation]
    if annotation is type(None):
        return "null"
    origin, args = get_origin(annotation), get_args(annotation)
    if isinstance(annotation, type) and issubclass(annotation, Parameters):
        return "group { … }"
    if origin is Literal:
        return " | ".join(repr(choice) for choice in args)
    if origin in (Union, UnionType):
        return " | ".join(dict.fromkeys(type_name(arg) for arg in args))
    if origin in (list, tuple):
        return f"list of {type_name(args[0])}"
    if hasattr(annotation, "__metadata__"):
        parts = [p for m in annotation.__metadata__ for p in _bounds(getattr(m, "metadata", [m]))]
        return _bounded(type_name(args[0]), parts)
    return getattr(annotation, "__name__", str(annotation))


_SIGNS = (
    ("gt", ">"),
    ("ge", "≥"),
    ("lt", "<"),
    ("le", "≤"),
    ("min_length", "with length ≥"),
    ("max_length", "with length ≤"),
)


def allowed(field: FieldInfo) -> str:
    """The values a parameter may take, in words: type, choices, bounds, and examples where it has any."""
    parts = [part for constraint in field.metadata for part in _bounds([constraint])]
    if field.examples:
        parts.append(f"such as {' or '.join(map(repr, field.examples))}")
    text, *rest = type_name(field.annotation).split(" | ")
    return " | ".join([_bounded(text, parts), *rest])


def _bounds(constraints: Iterable[Any]) -> list[str]:
    return [
        f"{sign} {getattr(constraint, name)}"
        for constraint in constraints
        for name, sign in _SIGNS
        if hasattr(constraint, name)
    ]


def _bounded(text: str, parts: list[str]) -> str:
    return f"{text} {' and '.join(parts)}" if parts else text
