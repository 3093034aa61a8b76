"""Runs on disk that no studio holds: it ended unexpectedly, or another run took their place."""

import shutil
from collections.abc import Collection
from dataclasses import asdict, dataclass, field
from io import FileIO
from pathlib import Path
from typing import Any

from barchan.errors import BarchanError
from barchan.holding import HeldError, hold, holder_of
from barchan.replacing import PARTIAL
from barchan.studio.server.autosave_folder import ASIDE, LOCK, STATES
from barchan.studio.server.security import is_plain_name
from barchan.studio.server.together import Together, read_together

MOST = 10
"""Studios that ended unexpectedly of which runs are kept; beyond, the oldest go."""

LARGEST = 2 << 30
"""Bytes that all of them may take; beyond, the oldest go, but never the newest."""


@dataclass
class Adopted:
    """The folder of a studio that has ended, held by this one."""

    folder: Path
    runs: Together
    lock: FileIO

    def release(self) -> None:
        """Leave it to the next studio."""
        self.lock.close()

    def discard(self) -> None:
        """Delete it."""
        self.release()
        shutil.rmtree(self.folder, ignore_errors=True)


@dataclass
class Found:
    """What studios have left."""

    runs: dict[str, Together] = field(default_factory=dict)
    """Whole states, the newest first, by the name of the studio's folder."""
    broken: list[str] = field(default_factory=list)
    """What is wrong with those that are damaged, each with its file."""

    def data(self, here: Collection[str] = ()) -> dict[str, Any]:
        """As the page takes it; ``here`` are names of runs that the studio itself has left aside."""
        listed = [
            {
                "name": name,
                "saved": one.saved,
                "aside": ASIDE in name,
                "here": name in here,
                "runs": [asdict(member) for member in one.members],
            }
            for name, one in self.runs.items()
        ]
        return {"unfinished": listed, "broken": self.broken}


class Unfinished:
    """The folders of studios that have ended; those of studios that run are left alone."""

    def __init__(self, home: Path | None) -> None:
        """Look into ``home``; without one there is nothing."""
        self._home = home

    def look(self) -> Found:
        """What there is, after too many or too large ones were deleted."""
        found = Found()
        size = 0
        for at, folder in enumerate(self._ended()):
            own = sum(path.stat().st_size for path in folder.rglob("*") if path.is_file())
            size += own
            if at and (at >= MOST or size > LARGEST):
                self._delete(folder)
                continue
            try:
                runs = _newest_in(folder)
            except BarchanError as error:
                found.broken.append(str(error))
            else:
                if runs is None:
                    self._delete(folder)
                else:
                    found.runs[folder.name] = runs
        return found

    def open(self, name: str) -> Adopted:
        """Hold what a studio has left; raises BarchanError where it is not there, damaged, or in use."""
        folder = self._folder(name)
        try:
            lock = hold(folder / LOCK)
        except HeldError as error:
            raise BarchanError(f"this run is open in another studio, process {error.owner}") from None
        except OSError as error:
            raise BarchanError(f"{folder}: {error.strerror or error}") from None
        try:
            runs = _newest_in(folder)
            if runs is None:
                raise BarchanError(f"{folder}: no run is kept there")
        except BaseException:
            lock.close()
            raise
        return Adopted(folder, runs, lock)

    def discard(self, name: str) -> None:
        """Delete what a studio has left; raises BarchanError as ``open`` does."""
        self.open(name).discard()

    def _folder(self, name: str) -> Path:
        if self._home is None or not is_plain_name(name) or not (self._home / name).is_dir():
            raise BarchanError("this run is not kept any more")
        return self._home / name

    def _ended(self) -> list[Path]:
        """The folders that no studio holds, the newest first."""
        if self._home is None or not self._home.is_dir():
            return []
        folders = [path for path in self._home.iterdir() if (path / LOCK).is_file()]
        return sorted((one for one in folders if holder_of(one / LOCK) is None), key=_age, reverse=True)

    def _delete(self, folder: Path) -> None:
        try:
            with hold(folder / LOCK):
                shutil.rmtree(folder, ignore_errors=True)
        except (HeldError, OSError):
            return  # another studio has just taken it


def _age(folder: Path) -> tuple[str, bool, int]:
    """What later studios have more of; of one studio runs set aside come behind, the last one first."""
    studio, aside, number = folder.name.partition(ASIDE)
    return studio, not aside, int(number.removeprefix("-") or 0)


def _newest_in(folder: Path) -> Together | None:
    """The newest whole state in a folder, None where none was ever written.

    Raises BarchanError where all that were written are damaged.
    """
    states = (path for path in folder.iterdir() if path.is_dir() and path.suffix != PARTIAL)
    error: BarchanError | None = None
    for path in sorted((path for path in states if path.name != STATES), reverse=True):
        try:
            return read_together(path)
        except BarchanError as damaged:
            error = error or damaged
    if error is not None:
        raise error
    return None
