"""The run that is set aside, kept on disk as a run of its own in case that the studio ends unexpectedly."""

import asyncio
import shutil
from pathlib import Path
from typing import TYPE_CHECKING

from barchan.studio.server.autosave_folder import ASIDE, AutosaveFolder
from barchan.studio.server.session_commands import FIRST

if TYPE_CHECKING:
    from barchan.studio.server.joint_answers import Answers
    from barchan.studio.server.session import Session


WHOLE = (
    "The run that is set aside is not kept on disk: {why}. "
    "If the studio ended unexpectedly now, it would be lost."
)

PARTS = (
    "The run that is set aside is kept on disk without some of its branches and earlier states: {why}. "
    "If the studio ended unexpectedly now, these would be lost."
)


class AutosaveAside:
    """Writes it once, for it stands still, into a folder of its own.

    The folder is deleted when the run is shown again. Where another one is set aside in its place it stays on
    disk, held by nobody, until somebody opens it or the user ends the studio.
    """

    def __init__(self, session: "Session", home: Path) -> None:
        """Keep it in a folder of ``home``."""
        self.folder = AutosaveFolder(home, ASIDE)
        self.left: list[str] = []
        """Names of the folders of runs whose place another one has taken."""
        self._session = session
        self._displaced = False
        """Whether another one has taken the place of the run in the folder."""
        self._changes = 0
        """How often another run, or none, was set aside."""
        self._writing = False

    def follow(self, *, displaced: bool) -> None:
        """Another run was set aside, which has ``displaced`` one before it, or none is any more."""
        self._changes += 1
        self._displaced |= displaced
        if not self._writing:
            self._leave_displaced()
            self._keep()

    def _leave_displaced(self) -> None:
        if not self._displaced:
            return
        self._displaced = False
        if self.folder.holds_state:
            path = self.folder.path
            self.folder.close()
            self.left.append(path.name)
            studio, *_ = path.name.partition(ASIDE)
            self.folder = AutosaveFolder(path.parent, f"{ASIDE}-{len(self.left)}", studio)

    def _keep(self) -> None:
        worker = self._session.workers.get(FIRST)
        if worker is None or not worker.holds_aside:
            self.folder.empty()
            return
        try:
            partial = self.folder.next()
        except OSError as error:
            self._say(error.strerror or str(error))
            return
        self._writing = True
        states = str(self.folder.states)
        part = {FIRST: {"command": "keep_aside_in", "folder": str(partial / FIRST), "states": states}}
        changes = self._changes
        self._session.joint.ask(
            part,
            lambda answers: self._written(partial, changes, answers),
            lambda why, _: self._ended(partial, changes, why),
        )

    def _written(self, partial: Path, changes: int, answers: "Answers") -> None:
        """Put it into place, beside the loop that serves, unless another one was set aside meanwhile."""
        member = answers[FIRST].get("member")
        stale = changes != self._changes and not self._displaced
        if stale or member is None:
            if not stale:
                self.folder.empty()  # nobody would miss it, and the one before has ended
            self._ended(partial, changes)
            return
        files = {FIRST: answers[FIRST]["files"]}
        committing = asyncio.get_running_loop().run_in_executor(
            None, self.folder.commit, partial, {FIRST: member}, files
        )
        lacking = answers[FIRST]["lacking"]
        committing.add_done_callback(lambda done: self._committed(done, partial, changes, lacking))

    def _committed(self, done: "asyncio.Future[bool]", partial: Path, changes: int, lacking: str) -> None:
        error = None if done.cancelled() else done.exception()
        if error is None and lacking:
            self._ended(partial, changes, lacking, PARTS)
        else:
            self._ended(partial, changes, "" if error is None else str(error))

    def _ended(self, partial: Path, changes: int, why: str = "", what: str = WHOLE) -> None:
        self._writing = False
        shutil.rmtree(partial, ignore_errors=True)
        self._leave_displaced()
        if changes != self._changes:
            self._keep()
        elif why and all(worker.process.is_alive() for worker in self._session.workers.values()):
            self._say(why, what)

    def _say(self, why: str, what: str = WHOLE) -> None:
        self._session.tell("refused", id=None, command="keep_in", text=what.format(why=why), problems=[])
