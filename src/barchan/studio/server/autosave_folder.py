"""The folder on disk in which a studio keeps the newest state of its runs."""

import os
import shutil
import threading
from collections.abc import Collection, Mapping
from contextlib import suppress
from datetime import UTC, datetime
from io import FileIO
from pathlib import Path
from typing import Any

from barchan.holding import hold
from barchan.replacing import PARTIAL
from barchan.studio.server.together import Member, name_together

STATES = "states"
"""The folder of states that stay as they are while the newest one moves on: of branches, and of the past."""

LOCK = "writer.lock"
"""The file that a studio holds for as long as its folder is its own."""

ASIDE = "-aside"
"""How the name of the folder ends of the run that is set aside; of later ones there is a number behind."""


class AutosaveFolder:
    """A folder that one process holds: each state takes the place of the one before by one renaming."""

    def __init__(self, home: Path, ending: str = "", studio: str = "") -> None:
        """A new folder of ``home``, made when the first state is to be written.

        Its name is that of the studio, by default of the moment and the process, and ``ending``.
        """
        began = datetime.now(UTC).strftime("%Y%m%d-%H%M%S")
        self.path = home / f"{studio or f'{began}-{os.getpid()}'}{ending}"
        self._lock: FileIO | None = None
        self._count = 0
        self._newest: Path | None = None
        self._members: dict[str, Member] = {}
        self._files: dict[str, Collection[str]] = {}
        """The files in ``states`` that the newest state needs, by run."""
        self._forsaken = False
        self._placing = threading.Lock()
        """Held while states take their places, which is done in another thread than the rest."""

    @property
    def holds_state(self) -> bool:
        """Whether a state has taken its place."""
        return self._newest is not None

    @property
    def states(self) -> Path:
        """Where files are written that stay as they are, before a state that needs them takes its place."""
        return self.path / STATES

    def next(self) -> Path:
        """A folder for the next state to be written into; raises OSError where none can be made."""
        if self._lock is None:
            self.path.mkdir(parents=True, exist_ok=True)
            self._lock = hold(self.path / LOCK)
        self._count += 1
        partial = self.path / f"{self._count:06d}{PARTIAL}"
        try:
            partial.mkdir()
        except OSError:
            self.close()  # somebody has deleted the folder: it is made again for the next state
            self._forget()
            raise
        return partial

    def commit(
        self,
        partial: Path,
        written: dict[str, dict[str, Any] | None],
        files: Mapping[str, Collection[str]] | None = None,
    ) -> bool:
        """Let what was written take the place of the state before; returns whether it is whole.

        ``written`` holds title, model, step and steps by run, None for a run that is as it was in the state
        before. ``files`` names what each run needs of ``states``, where all others are deleted. Runs that are
        not at one step are not kept: two that are compared belong together. Nor is anything once the folder
        was forsaken.
        """
        with self._placing:
            return not self._forsaken and self._commit(partial, written, files or {})

    def _commit(
        self,
        partial: Path,
        written: dict[str, dict[str, Any] | None],
        files: Mapping[str, Collection[str]],
    ) -> bool:
        members = {}
        for run, data in written.items():
            member = self._members.get(run) if data is None else Member(folder=run, **data)
            if member is None or (data is None and not self._carry_over(run, partial)):
                return False
            members[run] = member
        if len({member.step for member in members.values()}) != 1:
            return False
        name_together(partial, list(members.values()), sealed=True)
        final = partial.with_name(partial.name.removesuffix(PARTIAL))
        if self.states.is_dir():
            _to_disk(self.states)  # its files are there already
        _to_disk(partial, *partial.rglob("*"))
        if self._forsaken:
            return False
        partial.replace(final)
        _to_disk(self.path)
        before, self._newest, self._members = self._newest, final, members
        known = self._files
        self._files = {run: (files if data else known).get(run, ()) for run, data in written.items()}
        if before is not None:
            shutil.rmtree(before, ignore_errors=True)
        self._delete_unneeded()
        return True

    def _delete_unneeded(self) -> None:
        needed = {name for names in self._files.values() for name in names}
        for path in self.states.glob("*"):
            if path.name not in needed:
                with suppress(OSError):
                    path.unlink()

    def _carry_over(self, run: str, partial: Path) -> bool:
        """Take a run over from the state before; returns whether it was there."""
        if self._newest is None or not (self._newest / run).is_dir():
            return False
        shutil.copytree(self._newest / run, partial / run)
        return True

    def close(self) -> None:
        """Leave the folder to the next studio."""
        if self._lock is not None:
            self._lock.close()
            self._lock = None

    def forsake(self) -> None:
        """Offer nothing of it from now on, at once, and wait for nothing: it is to be discarded.

        By one renaming the state counts as half written, also where the process ends before it is deleted.
        """
        self._forsaken = True
        self._give_up_newest()

    def empty(self) -> None:
        """Delete the state, until there is another one."""
        with self._placing:
            self._give_up_newest()
            self._delete_states()

    def _give_up_newest(self) -> None:
        newest = self._newest
        self._forget()
        if newest is not None:
            with suppress(OSError):
                newest.replace(newest.with_name(f"{newest.name}{PARTIAL}"))

    def _forget(self) -> None:
        self._newest, self._members, self._files = None, {}, {}

    def _delete_states(self) -> None:
        for state in (path for path in self.path.glob("*") if path.is_dir()):
            shutil.rmtree(state, ignore_errors=True)

    def discard(self) -> None:
        """Delete the folder, which is held until nothing is left in it that could be offered."""
        self.forsake()
        with self._placing:
            self.forsake()  # once more, for a state that has just taken its place
            self._delete_states()
            self.close()
            shutil.rmtree(self.path, ignore_errors=True)


def _to_disk(*paths: Path) -> None:
    """Let the system write files, and what folders hold, to disk, so that no renaming is ahead of them."""
    if not hasattr(os, "O_DIRECTORY"):  # a folder cannot be opened there
        return
    for path in paths:
        handle = os.open(path, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)
