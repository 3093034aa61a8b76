"""The axes of an ensemble: a key of the scenario and the values that it takes."""

import json
import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from barchan.errors import Problem, ScenarioError
from barchan.scenario.overrides import Origin, full_path, hint_for, value_of
from barchan.scenario.source_map import dotted

_SPACED = re.compile(r"(lin|log)\((.*)\)", re.DOTALL)

FORM = "--vary KEY=1,3,5, KEY=lin(FROM,TO,NUMBER) or KEY=log(FROM,TO,NUMBER)"

VARY = Origin("--vary", "", ".")

MOST_VALUES = 10_000

APART = {
    "run.seed": "seeds are stated by --seeds and --first-seed",
    "run.threads": "results do not depend on the number of threads",
}
"""Keys that no axis can have, and why."""


@dataclass(frozen=True)
class Axis:
    """A key of the scenario and the values that it takes, or the interval that they are drawn from."""

    key: str
    values: tuple[Any, ...]
    spacing: str = ""
    """``lin`` or ``log`` where the values cover an interval; empty where they are single ones."""

    @property
    def low(self) -> float:
        """Lower end of its interval."""
        return float(self.values[0])

    @property
    def high(self) -> float:
        """Upper end of its interval."""
        return float(self.values[-1])

    def at(self, share: float) -> float:
        """The value at a share (0 to 1) of its interval."""
        if self.spacing == "log":
            return float(self.low * (self.high / self.low) ** share)
        return self.low + (self.high - self.low) * share


def value_label(value: Any) -> str:
    """A value of an axis in a word or two: a whole group by its name or kind and its other values."""
    if isinstance(value, list):
        return json.dumps(value)
    if not isinstance(value, dict):
        return str(value)
    named = [str(value[tag]) for tag in ("name", "kind") if tag in value]
    others = [f"{key} {value_label(v)}" for key, v in value.items() if key not in ("name", "kind")]
    return " ".join([*named, *others])


def parse_axes(texts: Sequence[str]) -> tuple[Axis, ...]:
    """Axes from texts as ``model.hop_length=1,3,5``; see ``FORM``.

    Raises ScenarioError with every problem found.
    """
    axes, problems = read_axes(texts)
    if problems:
        raise ScenarioError(problems, "command line")
    return axes


def read_axes(texts: Sequence[str]) -> tuple[tuple[Axis, ...], list[Problem]]:
    """Those of the texts that are axes, and what is wrong with the others."""
    axes: list[Axis] = []
    problems: list[Problem] = []
    for text in texts:
        try:
            axis = _axis(text)
            if axis.key in (known.key for known in axes):
                raise _AxisError(axis.key, "is varied twice")
            axes.append(axis)
        except _AxisError as wrong:
            problems.append(Problem(wrong.key, wrong.message, VARY.word))
    return tuple(axes), problems


class _AxisError(Exception):
    def __init__(self, key: str, message: str) -> None:
        super().__init__(message)
        self.key, self.message = key, message


def _axis(text: str) -> Axis:
    name, equals, given = text.partition("=")
    if not equals or not name.strip() or not given.strip():
        raise _AxisError(text, f"is no axis; allowed: {FORM}")
    path = full_path(name.strip())
    if path is None:
        raise _AxisError(name, f"is no key of a scenario{hint_for(name.strip(), VARY)}")
    key = dotted(("model", "name") if path == ("model",) and not given.startswith("{") else path)
    if key in APART:
        raise _AxisError(key, f"cannot be varied; {APART[key]}")
    spaced = _SPACED.fullmatch(given.strip())
    if spaced:
        return Axis(key, _spaced(key, spaced[1], spaced[2]), spaced[1])
    values = tuple(value_of(part.strip()) for part in _parts(given))
    if "" in values:
        raise _AxisError(key, f"has an empty value in '{given}'")
    if len({json.dumps(value) for value in values}) < len(values):
        raise _AxisError(key, f"has the same value twice in '{given}'")
    return Axis(key, values)


def _parts(text: str) -> list[str]:
    """Values with commas between, where commas within brackets and quotes part nothing."""
    parts, depth, quoted = [""], 0, False
    for letter in text:
        quoted ^= letter == '"'
        depth += 0 if quoted else (letter in "[{(") - (letter in "]})")
        if letter == "," and depth == 0 and not quoted:
            parts.append("")
        else:
            parts[-1] += letter
    return parts


def _spaced(key: str, spacing: str, inside: str) -> tuple[Any, ...]:
    """The values that ``lin(…)`` and ``log(…)`` stand for; whole numbers where all are."""
    numbers = [value_of(part.strip()) for part in inside.split(",")]
    sound = all(isinstance(n, int | float) and not isinstance(n, bool) and math.isfinite(n) for n in numbers)
    if len(numbers) not in (2, 3) or not sound:
        raise _AxisError(
            key,
            f"is {spacing}({inside}); allowed: {spacing}(FROM,TO,NUMBER), NUMBER left out for "
            "the designs latin and sobol",
        )
    low, high, count = numbers[0], numbers[1], numbers[2] if len(numbers) == 3 else 2
    if not isinstance(count, int) or not 2 <= count <= MOST_VALUES:
        raise _AxisError(key, f"has {count} values; allowed: a whole number from 2 to {MOST_VALUES}")
    if low == high or (spacing == "log" and min(low, high) <= 0):
        more = "above 0 and " if spacing == "log" else ""
        raise _AxisError(key, f"is {spacing}({inside}); allowed: ends {more}unlike each other")
    axis = Axis(key, (low, high), spacing)
    values = [axis.at(k / (count - 1)) for k in range(count)]
    values[-1] = float(high)
    whole = all(isinstance(n, int) for n in (low, high)) and all(v == round(v) for v in values)
    return tuple(round(v) if whole else float(f"{v:.12g}") for v in values)
