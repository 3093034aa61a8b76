"""JSON text to data, with the line of every key, and nothing accepted in silence."""

import json
import re
from collections.abc import Callable, Iterator, Mapping
from collections.abc import Set as AbstractSet
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from typing import Any

from barchan.errors import Problem, ScenarioError

Path = tuple[str | int, ...]

_TOKEN = re.compile(r'"(?:[^"\\]|\\.)*"|[{}\[\]:,]|[^\s{}\[\]:,"]+')

MOST_LEVELS = 50
"""Levels of groups and lists in one another: more than twice as many as a scenario can have."""

TOO_DEEP = f"has groups or lists more than {MOST_LEVELS} deep in one another; no scenario has"

_STEP = re.compile(r"([^.\[\]]+)|\[(\d+)\]")

_CONSTANTS = ("NaN", "Infinity", "-Infinity")
"""Words that Python accepts in JSON beyond the standard."""


def parse(text: str, name: str) -> tuple[Any, dict[Path, int], list[Problem]]:
    """The data in a JSON text, the line of each key and item, and the problems of the text itself."""
    problems: list[Problem] = []
    try:
        data = json.loads(text)
    except json.JSONDecodeError as error:
        place = f"{name}:{error.lineno}:{error.colno}"
        return None, {}, [Problem("", f"not valid JSON: {error.msg}", place)]
    except ValueError as error:
        return None, {}, [Problem("", f"not valid JSON: {error}", name)]
    except RecursionError:
        return None, {}, [Problem("", TOO_DEEP, name)]
    if is_too_deep(data):
        return None, {}, [Problem("", TOO_DEEP, name)]
    tokens = list(_tokens(text))
    for token, line in tokens:
        if token in _CONSTANTS:
            problems.append(Problem("", f"not valid JSON: {token} is not a number here", f"{name}:{line}"))
    if problems:
        return None, {}, problems
    lines, repeated = _lines(tokens)
    for path, line in repeated:
        problems.append(Problem(dotted(path), "given twice", f"{name}:{line}"))
    return data, lines, problems


def dotted(path: Path) -> str:
    """A path as users write it: ``sand.parts[0].mean``."""
    text = ""
    for step in path:
        text += f"[{step}]" if isinstance(step, int) else f".{step}" if text else step
    return text


def is_too_deep(data: Any) -> bool:
    """Whether groups and lists lie more than ``MOST_LEVELS`` deep in one another."""
    level = [data]
    for _ in range(MOST_LEVELS + 1):
        inner = [
            one
            for group in level
            if isinstance(group, dict | list)
            for one in (group.values() if isinstance(group, dict) else group)
        ]
        level = list({id(one): one for one in inner}.values())
    return bool(level)


def _tokens(text: str) -> Iterator[tuple[str, int]]:
    """The tokens of a JSON text, each with its line."""
    line, counted = 1, 0
    for found in _TOKEN.finditer(text):
        line += text.count("\n", counted, found.start())
        counted = found.start()
        yield found.group(), line


@dataclass(frozen=True, eq=False)
class SourceMap:
    """The place of each key of a scenario: a line of a file, or the command line.

    Places are no part of a scenario's data, so any two source maps are equal.
    """

    name: str = ""
    lines: Mapping[Path, int] = field(default_factory=dict)
    given: AbstractSet[Path] = frozenset()
    """Keys that were given on the command line or as arguments."""
    place_of_given: Callable[[Path], str] = dotted
    """The place of a key that was given."""
    notes: tuple[str, ...] = ()
    """What was left out on reading."""

    def __eq__(self, other: object) -> bool:
        """Whether the other is a source map too."""
        return isinstance(other, SourceMap)

    __hash__ = None  # type: ignore[assignment]

    def of(self, path: Path) -> str:
        """``file:line`` or ``command line``; empty if unknown."""
        if any(path[: len(g)] == g or (path and g[: len(path)] == path) for g in self.given):
            return self.place_of_given(path)
        known = (self.lines[path[:n]] for n in range(len(path), 0, -1) if path[:n] in self.lines)
        line = next(known, 0)
        return f"{self.name}:{line}" if line else ""

    @contextmanager
    def locating_errors(self) -> Iterator[None]:
        """Add the places of keys to errors raised within."""
        try:
            yield
        except ScenarioError as error:
            problems = [p if p.place else replace(p, place=self.of(path_of(p.key))) for p in error.problems]
            raise ScenarioError(problems, self.name or "scenario") from None


def path_of(key: str) -> Path:
    """The path that ``dotted`` wrote: ``sand.parts[0].mean``."""
    return tuple(int(index) if index else word for word, index in _STEP.findall(key))


def _lines(tokens: list[tuple[str, int]]) -> tuple[dict[Path, int], list[tuple[Path, int]]]:
    """The line of every key and list item, from the tokens of a valid JSON text and their lines."""
    lines: dict[Path, int] = {}
    repeated: list[tuple[Path, int]] = []
    stack: list[list[str | int]] = []  # the current key or index of every open object or list
    for at, (token, line) in enumerate(tokens):
        following = tokens[at + 1][0] if at + 1 < len(tokens) else ""
        if token in "{[":
            if stack and isinstance(stack[-1][0], int):
                lines[tuple(level[0] for level in stack)] = line
            stack.append([0] if token == "[" else [""])
        elif token in "}]":
            stack.pop()
        elif token == "," and isinstance(stack[-1][0], int):
            stack[-1][0] += 1
        elif following == ":" and stack:
            stack[-1][0] = json.loads(token)
            path = tuple(level[0] for level in stack)
            if path in lines:
                repeated.append((path, line))
            lines[path] = line
        elif token not in ":," and stack and isinstance(stack[-1][0], int):
            lines[tuple(level[0] for level in stack)] = line
    return lines, repeated
