"""The run whose place two that are compared, or another run, have taken, and the way back to it."""

from typing import TYPE_CHECKING, Any

from barchan.studio.protocol import Request, numbered

if TYPE_CHECKING:
    from barchan.studio.server.session import Session


class Aside:
    """Its worker holds the whole run, with its past; the server a state of it, in case that this is lost."""

    def __init__(self, session: "Session") -> None:
        """None yet."""
        self._session = session
        self.state: bytes | None = None
        """The state of the run that was set aside."""
        self.of_it = False
        """Whether the run in its place came of it: two that are compared."""

    def begun(self, name: str, request: Request, aside: dict[str, Any] | None) -> None:
        """The first worker has begun what was requested; ``aside`` is what it says of the run set aside."""
        self._session.workers[name].holds_aside = aside is not None
        if aside is not None:
            self.of_it = aside["of_it"]
            if aside["new"]:
                self.state = self._session.kept.newest(name)
            if aside["changed"]:
                self._session.autosave.aside_changed(displaced=aside["displaced"])
        elif not request.get("changed"):
            self.state = None
            self._session.autosave.aside_changed()

    def take_back(self, name: str, request: Any = None) -> None:
        """Let a worker return to the run that was set aside; what ``request`` asked for is answered then."""
        if self._session.worker(name).holds_aside:
            self._session.start_run(name, {"command": "take_back", "id": request})
            return
        if self.state is not None:
            start = self._session.starts.add(name, None)
            self._session.worker(name).send_bytes(numbered(self.state, start.number))
            self.state = None
        self._session.tell("done", id=request, aside=None)
