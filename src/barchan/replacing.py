"""Files that appear complete or not at all."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

PARTIAL = ".partial"
"""Stands before the suffix of a file that is being written."""


@contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """A file beside ``path`` to write to; it takes the place of ``path``, or is removed on failure.

    It has the suffix of ``path``. Raises OSError where it cannot be put in its place.
    """
    partial = path.with_name(path.stem + PARTIAL + path.suffix)
    try:
        yield partial
        partial.replace(path)
    except BaseException:
        partial.unlink(missing_ok=True)
        raise
