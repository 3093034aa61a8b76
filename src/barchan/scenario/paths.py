"""The files that a scenario names, by its keys ``path``."""

from collections.abc import Callable
from pathlib import Path
from typing import Any


def with_paths(data: Any, change: Callable[[str], str]) -> Any:
    """A copy of plain data in which every ``path`` is what ``change`` makes of it."""
    if isinstance(data, list):
        return [with_paths(item, change) for item in data]
    if not isinstance(data, dict):
        return data
    return {
        key: change(value) if key == "path" and isinstance(value, str) else with_paths(value, change)
        for key, value in data.items()
    }


def anchored(data: Any, folder: Path) -> Any:
    """A copy of plain data in which every ``path`` starts at ``folder``; absolute ones stay."""
    return with_paths(data, lambda path: str(folder / path))
