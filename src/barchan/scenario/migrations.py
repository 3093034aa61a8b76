"""Configuration files of earlier formats, brought up to date on reading."""

from collections.abc import Callable
from typing import Any

from barchan.scenario.definition import FORMAT

STEPS: dict[int, Callable[[dict[str, Any]], dict[str, Any]]] = {}
"""For each earlier format, what turns its data into the next one's."""


def migrate(data: dict[str, Any]) -> tuple[dict[str, Any], str]:
    """The data in today's format, and what is wrong with its version, if anything."""
    if "barchan" not in data:
        return data, f'is missing: the format\'s version, "barchan": {FORMAT}'
    version = data["barchan"]
    if not isinstance(version, int) or isinstance(version, bool) or version < 1:
        return {**data, "barchan": FORMAT}, f"is {version!r}; allowed: a format version from 1 to {FORMAT}"
    if version > FORMAT:
        text = f"is {version}, written by a newer Barchan; this one reads formats up to {FORMAT}"
        return {**data, "barchan": FORMAT}, text
    while version < FORMAT:
        data = {**STEPS[version](data), "barchan": version + 1}
        version += 1
    return data, ""
