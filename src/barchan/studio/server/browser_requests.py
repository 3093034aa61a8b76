"""Requests of browsers: who may ask, and who carries them out."""

from typing import TYPE_CHECKING, Any

from barchan.errors import BarchanError, ScenarioError
from barchan.studio.commands import COMMANDS, command_of
from barchan.studio.protocol import ANSWERED, Request, read_request
from barchan.studio.server.audience import Viewer
from barchan.studio.server.queries import QUERIES
from barchan.studio.server.session_commands import FIRST, SESSION

if TYPE_CHECKING:
    from barchan.studio.server.session import Session


class BrowserRequests:
    """Takes the requests of browsers to the session, to its workers, or to those that answer questions."""

    def __init__(self, session: "Session") -> None:
        """Serve a session."""
        self.session = session

    def carry_out(self, viewer: Viewer, text: str) -> None:
        """Carry out a request of a browser; one that cannot be carried out is answered with the reason."""
        request: Request = {}
        try:
            request = read_request(text)
            if request.get("command") == "confirm":
                self._confirm(viewer, request.get("run"))
            elif viewer is not self.session.audience.owner:
                raise BarchanError("this window only watches; another one commands the run")
            else:
                self._do(request)
        except ScenarioError as error:
            self._refuse(viewer, request, str(error), [vars(problem) for problem in error.problems])
        except ANSWERED as error:
            self._refuse(viewer, request, str(error) or type(error).__name__, [])

    def _refuse(self, viewer: Viewer, request: Request, text: str, problems: list[dict[str, Any]]) -> None:
        viewer.refuse(request, *self.session.workspace.plainly(text, problems))

    def _confirm(self, viewer: Viewer, run: Any) -> None:
        """A browser has drawn a frame; workers make the next ones at the pace of the fastest browser."""
        for name, worker in self.session.workers.items():
            if run in (name, None):
                for _ in range(self.session.audience.confirm(viewer, name)):
                    worker.send("confirm")

    def _do(self, request: Request) -> None:
        # Workers check by themselves whether they have a run.
        command = command_of(request.get("command"))
        if command.internal:
            raise BarchanError(f"unknown command '{command.name}'")
        if command.owner == "worker":
            self._pass_on(request)
        elif command.owner == "query":
            self.session.tell(
                "done", id=request.get("id"), **QUERIES[command.name](self.session.workspace, request)
            )
        else:
            command_of(command.name, has_run=FIRST in self.session.scenarios)
            SESSION[command.name](self.session, request)

    def _pass_on(self, request: Request) -> None:
        """Let the worker that is named, or where none is named all of them, carry a request out."""
        pair, command = self.session.lockstep, COMMANDS[request["command"]]
        if pair is not None and command.name == "run":
            pair.run(request.get("steps"), request.get("until"))
            return
        if pair is not None and command.name == "pause":
            pair.pause()
            return
        if pair is not None and command.name == "restart":
            pair.restart()
        self.session.workspace.check(request)
        named = request.get("run")
        workers = [
            self.session.workers[name] for name in ([named] if named is not None else self.session.workers)
        ]

        def pass_on() -> None:
            for worker in workers:
                worker.forward({**request, "run": None})
            if command.name == "pause":
                self.session.autosave.soon()

        if pair is None or command.pair == "any time":
            pass_on()
        else:  # to look at the newest state, of step null, nothing is paused
            pair.meet(pass_on, command.pair == "pause" and request.get("step", 0) is not None)
