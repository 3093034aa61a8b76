"""Which members need kernels of their own: kernels are compiled for choices, not for numbers."""

import json
from collections.abc import Iterable
from typing import Any

from barchan.ensembles.plan import Member

_WORDS = ("title", "citation", "look_for", "question", "note")

QUARTER = 90.0
"""Degrees between lattice axes; along these kernels are simpler."""


def one_of_each(members: Iterable[Member]) -> list[Member]:
    """The first member of each set that differ in numbers only."""
    first: dict[str, Member] = {}
    for member in members:
        data = {key: value for key, value in member.scenario.items() if key not in _WORDS}
        first.setdefault(json.dumps(_choices(data), sort_keys=True), member)
    return list(first.values())


def _choices(data: Any, key: str = "") -> Any:
    """Plain data with numbers replaced by what kernels ask of them."""
    if isinstance(data, dict):
        return {name: _choices(value, name) for name, value in data.items()}
    if isinstance(data, list):
        return sorted({json.dumps(_choices(item, key), sort_keys=True) for item in data})
    if isinstance(data, bool) or not isinstance(data, int | float):
        return data
    return "along an axis" if key == "direction" and data % QUARTER == 0 else "a number"
