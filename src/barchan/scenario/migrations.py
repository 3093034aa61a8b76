"""Configuration files of earlier formats, brought up to date on reading."""

from collections.abc import Callable
from typing import Any

from barchan.scenario.definition import FORMAT

Data = dict[str, Any]

RENAMED_SINCE_1: dict[str, str] = {
    "run.until.still": "run.until.idle_steps",
    "model.release_angle": "model.static_repose_angle",
    "model.firm_repose_angle": "model.stabilised_repose_angle",
    "model.firm_cover": "model.stabilised_cover",
}
"""Keys of format 1 and what they are called now."""

RENAMED_VALUES_SINCE_1: dict[str, dict[str, str]] = {}
"""By keys as they are called now: words of format 1 that a parameter took, and what they are called now."""


def current_key(key: str) -> str:
    """The key that a key of any earlier format stands for now."""
    return RENAMED_SINCE_1.get(key, key)


def _to_2(data: Data) -> Data:
    """Standard words for keys, and one group of keys for each closure of a grain model."""
    for old, new in RENAMED_SINCE_1.items():
        _move(data, old.split("."), new.split("."))
    for key, words in RENAMED_VALUES_SINCE_1.items():
        *groups, last = key.split(".")
        group = _group(data, groups)
        if group is not None and isinstance(group.get(last), str):
            group[last] = words.get(group[last], group[last])
    return data


STEPS: dict[int, Callable[[Data], Data]] = {1: _to_2}
"""For each earlier format, what turns its data into the next one's."""


def migrate(data: Data) -> tuple[Data, str]:
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


def _group(data: Any, groups: list[str]) -> Data | None:
    """The group of keys at a path; None where there is none."""
    for name in groups:
        data = data.get(name) if isinstance(data, dict) else None
    return data if isinstance(data, dict) else None


def _move(data: Data, old: list[str], new: list[str]) -> None:
    """Move the value of one key to another, whose groups are made as needed."""
    group = _group(data, old[:-1])
    if group is None or old[-1] not in group:
        return
    value = group.pop(old[-1])
    for name in new[:-1]:
        data = data.setdefault(name, {})
    data[new[-1]] = value
