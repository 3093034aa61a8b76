"""Runs the tutorials when the documentation is built, for the pictures that their code makes.

A page names its pictures as ``../_static/tutorials/NAME``; its code saves ``NAME`` in the working directory.
A page is run again when its text or the version of Barchan changes.
"""

import contextlib
import hashlib
import io
import re
import sys
import tempfile
from importlib.metadata import version
from pathlib import Path
from shutil import copyfile
from typing import Any

from code_blocks import run_page
from sphinx.application import Sphinx
from sphinx.errors import ExtensionError

_PICTURE = re.compile(r"!\[[^\]]*\]\(\.\./_static/tutorials/([\w.-]+)\)")


def setup(app: Sphinx) -> dict[str, Any]:
    """Make the pictures before sources are read."""
    app.connect("builder-inited", make_pictures)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def make_pictures(app: Sphinx) -> None:
    """Run every tutorial that has no pictures of its present text yet."""
    source = Path(app.srcdir)
    kept = source / "_static" / "tutorials"
    kept.mkdir(parents=True, exist_ok=True)
    for page in sorted((source / "tutorials").glob("*.md")):
        stamp = kept / f"{page.stem}.sha256"
        present = hashlib.sha256(f"{version('barchan')}\n{page.read_text('utf-8')}".encode()).hexdigest()
        if pictures(page) and not (stamp.is_file() and stamp.read_text("utf-8") == present):
            _run(page, kept)
            stamp.write_text(present, "utf-8")


def pictures(page: Path) -> list[str]:
    """Names of the pictures that the code of a page makes."""
    return _PICTURE.findall(page.read_text("utf-8"))


def _silence() -> contextlib.redirect_stdout[io.StringIO]:
    return contextlib.redirect_stdout(io.StringIO())


def _run(page: Path, kept: Path) -> None:
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder), _silence():
        sys.path.insert(0, folder)
        try:
            run_page(page, Path(folder))
        finally:
            sys.path.remove(folder)
        for name in pictures(page):
            if not Path(name).is_file():
                raise ExtensionError(f"{page.name} names {name}, which its code does not make")
            copyfile(name, kept / name)
