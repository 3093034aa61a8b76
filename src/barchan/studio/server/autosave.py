"""When the runs of a studio are kept on disk, in case that it ends unexpectedly."""

import asyncio
import shutil
import time
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from barchan.errors import BarchanError
from barchan.studio.server.autosave_aside import AutosaveAside
from barchan.studio.server.autosave_folder import AutosaveFolder

if TYPE_CHECKING:
    from barchan.studio.server.joint_answers import Answers
    from barchan.studio.server.session import Session
    from barchan.studio.server.unfinished import Adopted

EVERY = 20.0
"""Seconds from one state on disk to the next."""

REST = 50.0
"""States that take long come less often: the next after as many times the seconds that the last one took."""

SOON = 0.5
"""Seconds from a pause to the state on disk, which so comes behind the picture."""

WHOLE = (
    "The run is not kept on disk: {why}. "
    "If the studio ended unexpectedly now, the run would be lost; save it."
)

PARTS = (
    "The run is kept on disk without some of its other branches and earlier states: {why}. "
    "If the studio ended unexpectedly now, these would be lost."
)


class Autosave:
    """Keeps the newest state of all runs in a folder, whole; nothing where there is no ``home`` for it."""

    def __init__(self, session: "Session", home: Path | None) -> None:
        """Keep states in a new folder of ``home``."""
        self._session = session
        self.folder = None if home is None else AutosaveFolder(home)
        self.aside = None if home is None else AutosaveAside(session, home)
        self._adopted: list[Adopted] = []
        self._forsaken = False
        self._known: dict[str, str | None] = {}
        self._writing = False
        self._began = 0.0
        self._pause = EVERY
        self._said: set[str] = set()
        self._timer: asyncio.TimerHandle | None = None

    def begin(self, seconds: float | None = None) -> None:
        """Keep the next state after some seconds, and others from then on."""
        self._stop()
        if self.folder is not None:
            wait = self._pause if seconds is None else seconds
            self._timer = asyncio.get_running_loop().call_later(wait, self._keep)

    def soon(self) -> None:
        """Keep the state, because the run has come to rest."""
        if self._timer is not None and not self._writing:
            self.begin(SOON)

    def aside_changed(self, *, displaced: bool = False) -> None:
        """Another run was set aside, for which one before it may have lost its place, or none is any more."""
        if self.aside is not None:
            self.aside.follow(displaced=displaced)
        self.soon()

    def adopt(self, adopted: "Adopted") -> None:
        """Runs of an earlier studio go on here: its folder is deleted as soon as they are kept here."""
        self._adopted.append(adopted)

    def forsake(self) -> None:
        """The user ends the studio: what is on disk is not for the next one, and goes with this one."""
        self._forsaken = True
        for folder in self._folders:
            folder.forsake()

    def close(self) -> None:
        """Leave what is on disk to the next studio, or delete it where the user has ended this one."""
        self._stop()
        for adopted in self._adopted:
            if self._forsaken:
                adopted.discard()
            else:
                adopted.release()
        for folder in self._folders:
            if self._forsaken:
                folder.discard()
            else:
                folder.close()
        if self._forsaken:
            for name in self.left:
                with suppress(BarchanError):  # it was opened, or is open in another studio
                    self._session.unfinished.discard(name)

    @property
    def left(self) -> list[str]:
        """Names of runs that were set aside here and whose place another one has taken."""
        return [] if self.aside is None else self.aside.left

    @property
    def _folders(self) -> list[AutosaveFolder]:
        aside = [] if self.aside is None else [self.aside.folder]
        return aside if self.folder is None else [self.folder, *aside]

    def _stop(self) -> None:
        if self._timer is not None:
            self._timer.cancel()
        self._timer = None

    def _keep(self) -> None:
        """Let all workers write their states, of two runs where they meet."""
        self.begin()
        runs = [name for name in self._session.workers if name in self._session.scenarios]
        if self._writing or not runs or len(runs) < len(self._session.workers):
            return
        assert self.folder is not None
        try:
            partial = self.folder.next()
        except OSError as error:
            self._say(error.strerror or str(error))
            return
        self._writing = True
        if self._session.lockstep is None:
            self._ask(runs, partial)
        else:
            self._session.lockstep.meet(lambda: self._ask(runs, partial))

    def _ask(self, runs: list[str], partial: Path) -> None:
        self._began = time.perf_counter()
        assert self.folder is not None
        command = {"command": "keep_in", "states": str(self.folder.states)}
        parts: dict[str, dict[str, Any]] = {
            run: {**command, "folder": str(partial / run), "known": self._known.get(run)}
            for run in runs
            if run in self._session.workers
        }
        self._session.joint.ask(
            parts, lambda answers: self._written(partial, answers), lambda why, _: self._failed(partial, why)
        )

    def _failed(self, partial: Path, why: str) -> None:
        self._give_up(partial)
        if all(worker.process.is_alive() for worker in self._session.workers.values()):
            self._say(why)

    def _give_up(self, partial: Path) -> None:
        self._writing = False
        shutil.rmtree(partial, ignore_errors=True)

    def _written(self, partial: Path, answers: "Answers") -> None:
        """All workers have answered: put what they wrote into place, beside the loop that serves."""
        if not any(answer["written"] for answer in answers.values()):
            self._give_up(partial)
            return
        assert self.folder is not None
        members = {run: answer.get("member") for run, answer in answers.items()}
        files = {run: answer.get("files", ()) for run, answer in answers.items()}
        loop = asyncio.get_running_loop()
        committing = loop.run_in_executor(None, self.folder.commit, partial, members, files)
        committing.add_done_callback(lambda done: self._committed(done, partial, answers))

    def _committed(self, done: "asyncio.Future[bool]", partial: Path, answers: "Answers") -> None:
        if done.cancelled() or done.exception() is not None or not done.result():
            self._known = {}
            self._give_up(partial)
            if not done.cancelled() and (error := done.exception()) is not None:
                self._say(str(error))
            return
        self._writing = False
        self._known = {run: answer["fingerprint"] for run, answer in answers.items()}
        self._pause = max(EVERY, REST * (time.perf_counter() - self._began))
        lacking = {answer["lacking"] for answer in answers.values() if answer.get("lacking")}
        for why in lacking:
            self._say(why, PARTS)
        if not lacking:
            self._said.clear()
            while self._adopted:
                self._adopted.pop().discard()

    def _say(self, why: str, what: str = WHOLE) -> None:
        """Let the page know once what would be lost with the studio."""
        text = what.format(why=why)
        if text not in self._said:
            self._said.add(text)
            self._session.tell("refused", id=None, command="keep_in", text=text, problems=[])
