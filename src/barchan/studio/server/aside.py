"""The run whose place two that are compared, or another scenario, have taken, and the way back to it."""

from typing import TYPE_CHECKING

from barchan.studio.protocol import Request, numbered

if TYPE_CHECKING:
    from barchan.studio.server.session import Session

ENDING = ("open_folder", "take_back")
"""Commands after which no run is set aside any more."""


class Aside:
    """Its worker holds the whole run, with its past; the server a state of it, in case that this is lost."""

    def __init__(self, session: "Session") -> None:
        """None yet."""
        self._session = session
        self.state: bytes | None = None
        """The state of the run that was set aside."""
        self._swaps = False
        """Whether the run in its place is set aside in turn when it is taken back: it did not come of it."""

    def begun(self, name: str, request: Request) -> None:
        """The first worker has begun what was requested."""
        worker = self._session.workers[name]
        if request.get("aside"):
            self._swaps = not request.get("changed")
            worker.holds_aside, self.state = True, self._session.kept.newest(name)
        elif request["command"] == "take_back" and self._swaps:
            self.state = self._session.kept.newest(name)
        elif request["command"] in ENDING or not request.get("changed"):
            worker.holds_aside, self.state = False, None

    def take_back(self, name: str) -> None:
        """Let a worker return to the run that was set aside, if one was."""
        if self._session.worker(name).holds_aside:
            self._session.start_run(name, {"command": "take_back"})
        elif self.state is not None:
            start = self._session.starts.add(name, None)
            self._session.worker(name).send_bytes(numbered(self.state, start.number))
            self.state = None
