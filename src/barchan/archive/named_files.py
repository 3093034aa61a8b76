"""The files that a run's scenario and events name, kept in the run's folder so that they travel with it."""

import hashlib
import json
import shutil
from pathlib import Path
from typing import Any

from barchan.errors import ArchiveError
from barchan.scenario.paths import with_paths

FILES, INDEX = "files", "files.json"

LARGEST_COPY = 1 << 30
"""Bytes up to which a file is copied; a larger one stays where it is, and only its digest is noted."""

_BESIDE = (".prj", ".hdr", ".tfw", ".pgw", ".jgw", ".bpw", ".wld")
"""Endings of files that say where a raster of the same name lies."""

_SHORT = 12
"""Digits of the digest that name the folder of a copy."""


class NamedFiles:
    """The files that a run names, and where each lies in its folder."""

    def __init__(self, folder: Path) -> None:
        """The files of the run in a folder, as far as there are any."""
        self.folder = folder
        index = folder / INDEX
        self.digests: dict[str, str] = json.loads(index.read_text("utf-8")) if index.is_file() else {}
        self._kept: dict[Path, str] = {}

    def kept(self, data: Any) -> Any:
        """A copy of plain data in which each file is named by its place in the run's folder.

        A file that is not there yet is copied and its digest noted. A file that does not exist keeps its
        name. Raises OSError where it cannot be copied.
        """
        return with_paths(data, self._place)

    def _place(self, path: str) -> str:
        file = Path(path).absolute()
        if file.is_relative_to(self.folder.absolute() / FILES):
            return file.relative_to(self.folder.absolute()).as_posix()
        if file not in self._kept:
            self._kept[file] = self._keep(file) if file.is_file() else path
        return self._kept[file]

    def _keep(self, file: Path) -> str:
        digest = digest_of(file)
        if file.stat().st_size > LARGEST_COPY:
            place = str(file)
        else:
            place = f"{FILES}/{digest[:_SHORT]}/{file.name}"
            _copy(file, self.folder / place)
            for suffix in _BESIDE:
                if file.with_suffix(suffix).is_file() and file.suffix != suffix:
                    _copy(file.with_suffix(suffix), (self.folder / place).with_suffix(suffix))
        self.digests[place] = digest
        _write(self.folder / INDEX, json.dumps(self.digests, indent=2) + "\n")
        return place


def check_files(folder: Path) -> None:
    """Raise ArchiveError where a file that the run in a folder names is missing or was changed."""
    for place, digest in NamedFiles(folder).digests.items():
        file = folder / place
        if not file.is_file():
            raise ArchiveError(f"{folder}: {file}, which the run was made with, is missing")
        if digest_of(file) != digest:
            raise ArchiveError(
                f"{folder}: {file} is not the file that the run was made with; its digest differs"
            )


def _copy(file: Path, to: Path) -> None:
    to.parent.mkdir(parents=True, exist_ok=True)
    partial = to.with_name(to.name + ".partial")
    shutil.copyfile(file, partial)
    partial.replace(to)


def digest_of(file: Path) -> str:
    """The SHA-256 digest of a file's content; raises OSError where it cannot be read."""
    with file.open("rb") as content:
        return hashlib.file_digest(content, "sha256").hexdigest()


def _write(path: Path, text: str) -> None:
    partial = path.with_name(path.name + ".partial")
    partial.write_text(text, "utf-8")
    partial.replace(path)
