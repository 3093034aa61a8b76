"""The session's folder: saved runs, and uploaded files."""

import os
import re
import unicodedata
from pathlib import Path
from typing import Any

from barchan.errors import BarchanError, Problem, ScenarioError
from barchan.ground.reading import READERS
from barchan.studio.server.security import is_plain_name, is_reserved
from barchan.studio.server.together import is_together
from barchan.wind.records.reading import SUFFIXES

UPLOADS = "studio-uploads"

EXPORTS = "studio-exports"

QUOTA = 1 << 30
"""Bytes of all uploaded files."""

LONGEST_STEM = 60
"""Characters of an uploaded file's name, without its suffix, that are kept."""

HEIGHTS = tuple(READERS)
"""Suffixes of files that can be ground."""

RECORDS = tuple(SUFFIXES)
"""Suffixes of files that can be a wind record."""

KINDS = tuple(dict.fromkeys((*HEIGHTS, *RECORDS)))
"""Files that can be one of both: data, never programs."""


class Workspace:
    """A folder beyond which nothing that a browser names is opened."""

    def __init__(self, folder: Path) -> None:
        """Use a folder; it is created when something is kept."""
        self.folder = folder.resolve()
        self._trusted: set[Path] = set()
        self._new: set[Path] = set()
        """Uploads that were sent once, of which nothing else can be made yet."""

    def trust(self, data: Any) -> None:
        """Let the files that a scenario from the command line names be opened."""
        self._trusted |= {Path(path).resolve() for _, path in _paths(data)}

    def check(self, data: Any) -> None:
        """Raise ScenarioError where data name a file that is not the session's."""
        wrong = [
            Problem(key, f"is outside the studio's folder; allowed: files in {self.folder / UPLOADS}", path)
            for key, path in _paths(data)
            if not self._is_ours(Path(path))
        ]
        if wrong:
            raise ScenarioError(wrong)

    def _is_ours(self, path: Path) -> bool:
        where = path.resolve()
        return where in self._trusted or where.is_relative_to(self.folder / UPLOADS)

    def keep(self, name: str, content: bytes) -> Path:
        """Keep an uploaded file under a plain name; raises BarchanError for a kind that is not allowed."""
        plain = plain_file_name(name)
        if Path(plain).suffix not in KINDS:
            raise BarchanError(f"'{name}' is of an unknown kind; allowed: {', '.join(KINDS)}")
        uploads = self.folder / UPLOADS
        held = sum(file.stat().st_size for file in uploads.iterdir()) if uploads.is_dir() else 0
        if held + len(content) > QUOTA:
            raise BarchanError(
                f"{uploads} would hold more than {QUOTA >> 20} MB; allowed: less. Delete what is not used"
            )
        path = uploads / plain
        path.parent.mkdir(parents=True, exist_ok=True)
        number = 1
        while path.exists() and path.read_bytes() != content:
            number += 1
            path = path.with_name(f"{Path(plain).stem}-{number}{Path(plain).suffix}")
        (self._new.discard if path.exists() else self._new.add)(path)
        path.write_bytes(content)
        return path

    def discard(self, name: str) -> None:
        """Delete an upload that was refused, unless it was sent before and so may be in use."""
        path = self.folder / UPLOADS / name
        if path in self._new:
            self._new.remove(path)
            path.unlink(missing_ok=True)

    def plainly(self, text: str, problems: list[dict[str, Any]]) -> tuple[str, list[dict[str, Any]]]:
        """A refusal as the page tells it: uploads are named without the server's folders."""
        folder = f"{self.folder / UPLOADS}{os.sep}"

        def plain(said: Any) -> Any:
            return said.replace(folder, "") if isinstance(said, str) else said

        return plain(text), [{name: plain(said) for name, said in one.items()} for one in problems]

    def run(self, name: str) -> Path:
        """The folder of the run of that name; raises BarchanError for any other than a plain name."""
        if not is_plain_name(name):
            raise BarchanError(f"'{name}' cannot be a run's name; allowed: letters, digits, dots, dashes")
        if is_reserved(name):
            raise BarchanError(f"'{name}' cannot be a run's name: it is reserved; allowed: any other")
        return self.folder / name

    def new_run(self, name: str) -> Path:
        """The folder for a run to be saved under a name; raises BarchanError where it is in use."""
        folder = self.run(name)
        if folder.is_file() or (folder.is_dir() and any(folder.iterdir())):
            raise BarchanError(f"'{name}' is in use in {self.folder}; choose another name")
        return folder

    def new_export(self, name: str) -> Path:
        """A file of that name in a new folder for exports; raises BarchanError for any but a plain name."""
        if not is_plain_name(name):
            raise BarchanError(f"'{name}' cannot be a file's name; allowed: letters, digits, dots, dashes")
        home = self.folder / EXPORTS
        used = [int(path.name) for path in home.iterdir() if path.name.isdigit()] if home.is_dir() else []
        return home / str(max(used, default=0) + 1) / name

    def export(self, number: str, name: str) -> Path:
        """An exported file; raises BarchanError where there is none of that name."""
        path = self.folder / EXPORTS / number / name
        if not (number.isdigit() and is_plain_name(name) and path.is_file()):
            raise BarchanError(f"no exported file {number}/{name}")
        return path

    def runs(self) -> list[str]:
        """Names of the runs that can be opened, among them of those that were saved together."""
        from barchan.archive.folder import CHECKPOINT, SCENARIO  # brings zarr, which no first page needs

        if not self.folder.is_dir():
            return []
        found = [path for path in self.folder.iterdir() if is_plain_name(path.name)]
        whole = [p for p in found if (p / SCENARIO).is_file() and (p / CHECKPOINT).is_file()]
        return sorted(path.name for path in (*whole, *filter(is_together, found)))


def plain_file_name(name: str) -> str:
    """A file's name without folders, in letters, digits, dots and dashes, its suffix in small letters.

    Letters lose their accents; ``naïve dunes (1).PNG`` becomes ``naive-dunes-1.png``.
    """
    letters = unicodedata.normalize("NFKD", re.split(r"[/\\]", name)[-1])
    stem, dot, suffix = "".join(c for c in letters if not unicodedata.combining(c)).rpartition(".")
    words = re.findall(r"[A-Za-z0-9_]+", stem)
    return f"{'-'.join(words)[:LONGEST_STEM] or 'file'}{dot}{suffix.lower()}"


def _paths(data: Any, key: str = "") -> list[tuple[str, str]]:
    """Keys and values of every ``path`` in data."""
    if isinstance(data, list):
        return [found for at, item in enumerate(data) for found in _paths(item, f"{key}[{at}]")]
    if not isinstance(data, dict):
        return []
    found = []
    for name, item in data.items():
        inner = f"{key}.{name}" if key else str(name)
        if name == "path" and item is not None:
            found.append((inner, str(item)))
        else:
            found += _paths(item, inner)
    return found
