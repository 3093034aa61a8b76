"""Files as reports name them: without their folders, and copies of one file by one name."""

import hashlib
from collections.abc import Iterable, Iterator
from functools import lru_cache
from pathlib import Path
from typing import Any

from barchan.archive.named_files import digest_of
from barchan.scenario.paths import with_paths

_SHORT = 8
"""Digits of a digest that tell files of one name apart."""


def paths_in(data: Any) -> list[str]:
    """Every ``path`` in plain data, in order."""
    found: list[str] = []

    def note(path: str) -> str:
        found.append(path)
        return path

    with_paths(data, note)
    return found


def file_names(paths: Iterable[str]) -> dict[str, str]:
    """A name for each path: that of its file, which copies of the same content share.

    Where files of one name have unlike contents, the beginning of its SHA-256 digest stands behind each.
    """
    contents = {path: _content(path) for path in paths}
    of_name: dict[str, set[str]] = {}
    for path, content in contents.items():
        of_name.setdefault(Path(path).name, set()).add(content)
    return {path: _told(Path(path).name, content, of_name) for path, content in contents.items()}


def with_file_names(data: Iterable[Any]) -> Iterator[Any]:
    """Copies of plain data in which every ``path`` is the name of its file, as ``file_names`` has it."""
    every = list(data)
    names = file_names(path for one in every for path in paths_in(one))
    return (with_paths(one, names.__getitem__) for one in every)


def _told(name: str, content: str, of_name: dict[str, set[str]]) -> str:
    return name if len(of_name[name]) == 1 else f"{name} ({content[:_SHORT]})"


def _content(path: str) -> str:
    """The digest of a file; of one that is not there that of its path."""
    try:
        found = Path(path).stat()
        return _digest(path, found.st_mtime_ns, found.st_size)
    except OSError:
        return hashlib.sha256(path.encode()).hexdigest()


@lru_cache(maxsize=64)
def _digest(path: str, _changed: int, _size: int) -> str:
    return digest_of(Path(path))
