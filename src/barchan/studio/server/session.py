"""The session: one or two simulations, and the browser that shows them."""

import asyncio
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

from barchan.errors import BarchanError, ScenarioError
from barchan.models import models
from barchan.scenario import Scenario, validate
from barchan.studio.commands import Handlers, command_of
from barchan.studio.protocol import PROTOCOL, Request, is_frame, message
from barchan.studio.server.lockstep import Lockstep
from barchan.studio.server.queries import QUERIES
from barchan.studio.server.worker_handle import WorkerHandle
from barchan.studio.server.workspace import Workspace

FIRST, SECOND = "a", "b"

SESSION: Handlers[Callable[["Session", Request], None]] = Handlers("session")


class Session:
    """Workers, the browser that is connected, and the messages between them."""

    def __init__(
        self, workspace: Workspace, scenario: Scenario | None = None, archive: Path | None = None
    ) -> None:
        """Prepare a session that begins with a scenario or an archive."""
        self.workspace = workspace
        self.workers: dict[str, WorkerHandle] = {}
        self.scenarios: dict[str, dict[str, Any]] = {}
        """The scenario of each worker, as changes during the run have left it."""
        self.lockstep: Lockstep | None = None
        self.outbox: asyncio.Queue[bytes] | None = None
        if archive is not None:
            self.first: Request = {"command": "open_folder", "folder": str(archive)}
        else:
            data = (scenario or Scenario()).seeded().data()
            workspace.trust(data)
            self.first = {"command": "start", "scenario": data, "running": True}

    def start(self) -> None:
        """Start the first worker."""
        self._worker(FIRST).forward(self.first)

    def close(self) -> None:
        """End all workers."""
        for worker in self.workers.values():
            worker.close()
        self.workers.clear()

    def attach(self) -> asyncio.Queue[bytes]:
        """A browser came; returns the queue of data for it. An earlier browser is dismissed."""
        if self.outbox is not None:
            self.outbox.put_nowait(b"")
        self.outbox = asyncio.Queue()
        running = self.lockstep is not None and self.lockstep.running
        self._send("hello", protocol=PROTOCOL, runs=list(self.workers), running=running)
        for worker in self.workers.values():
            worker.send("attach")
            if not worker.process.is_alive():
                self._send("lost", run=worker.name, code=worker.process.exitcode)
        return self.outbox

    def detach(self, outbox: asyncio.Queue[bytes]) -> None:
        """A browser went."""
        if self.outbox is outbox:
            self.outbox = None

    def on_message(self, text: str) -> None:
        """Carry out a request of the browser; one that cannot be carried out is answered with the reason."""
        request: Request = {}
        try:
            data = json.loads(text)
            if not isinstance(data, dict):
                raise BarchanError("a message must be an object that names a command")
            request = data
            self._carry_out(request)
        except ScenarioError as error:
            self._refuse(request, str(error), [vars(problem) for problem in error.problems])
        except (BarchanError, LookupError, TypeError, ValueError) as error:
            self._refuse(request, str(error) or type(error).__name__, [])

    def _send(self, kind: str, **content: Any) -> None:
        if self.outbox is not None:
            self.outbox.put_nowait(message(kind, **content))

    def _refuse(self, request: Request, text: str, problems: list[dict[str, Any]]) -> None:
        named = {"id": request.get("id"), "command": request.get("command")}
        self._send("refused", **named, text=text, problems=problems)

    def _carry_out(self, request: Request) -> None:
        # Workers check by themselves whether they have a run.
        command = command_of(request.get("command"))
        if command.internal:
            raise BarchanError(f"unknown command '{command.name}'")
        if command.owner == "worker":
            self._pass_on(request)
        elif command.owner == "query":
            self._send("done", id=request.get("id"), **QUERIES[command.name](self.workspace, request))
        else:
            command_of(command.name, has_run=FIRST in self.scenarios)
            SESSION[command.name](self, request)

    def _pass_on(self, request: Request) -> None:
        """Let the worker that is named, or where none is named all of them, carry a request out."""
        if self.lockstep is not None and request["command"] == "run":
            self.lockstep.run(request.get("steps"))
        elif self.lockstep is not None and request["command"] == "pause":
            self.lockstep.pause()
        else:
            self.workspace.check(request)
            named = request.get("run")
            for name in [named] if named is not None else list(self.workers):
                self.workers[name].forward({**request, "run": None})

    def _worker(self, name: str) -> WorkerHandle:
        """The worker of that name, a new one where there is none or it was lost."""
        worker = self.workers.get(name)
        if worker is None or not worker.process.is_alive():
            worker = self.workers[name] = WorkerHandle(name, self._on_worker_data, self._on_worker_exit)
            if self.outbox is not None:
                worker.send("attach")
        return worker

    def _on_worker_data(self, worker: WorkerHandle, data: bytes) -> None:
        """Pass a worker's message or frame on to the browser, and note what concerns all workers."""
        if self.workers.get(worker.name) is not worker:
            return
        if not is_frame(data):
            content = json.loads(data)
            if content["type"] == "scenario":
                self.scenarios[worker.name] = content["scenario"]
            elif content["type"] == "arrived" and self.lockstep is not None:
                self.lockstep.arrived(worker.name)
        if self.outbox is not None:
            self.outbox.put_nowait(data)

    def _on_worker_exit(self, worker: WorkerHandle) -> None:
        """A worker ended by itself."""
        if self.workers.get(worker.name) is worker:
            worker.process.join()
            if self.lockstep is not None:
                self.lockstep.pause()
            self._send("lost", run=worker.name, code=worker.process.exitcode)

    @SESSION.handles("create")
    def _create(self, request: Request) -> None:
        """Start a scenario; where there are two workers in the other one, too, with its own model."""
        self.workspace.check(request["scenario"])
        data = validate(request["scenario"]).seeded().data()
        name = SECOND if self.lockstep is not None and request.get("run") == SECOND else FIRST
        begun = {name: data}
        answering = _answer_of(name, request)
        if self.lockstep is not None:
            other = FIRST if name == SECOND else SECOND
            begun[other] = {**data, "model": self.scenarios[other]["model"]}
        self._begin(begun, bool(request.get("running", True)), answering)

    def _begin(
        self, scenarios: dict[str, dict[str, Any]], running: bool, answering: dict[str, Request] | None = None
    ) -> None:
        """Start these scenarios, in lockstep where there are two; the named workers answer the request."""
        alone = len(scenarios) == 1
        self.scenarios = scenarios
        for name, data in scenarios.items():
            answer = (answering or {}).get(name, {})
            self._worker(name).send("start", **answer, scenario=data, running=running and alone)
        self.lockstep = None if alone else Lockstep(self.workers, self._on_lockstep)
        if self.lockstep is not None and running:
            self.lockstep.run()

    def _on_lockstep(self, running: bool) -> None:
        self._send("lockstep", running=running)

    @SESSION.handles("compare")
    def _compare(self, request: Request) -> None:
        """Run another model beside, on the same ground, under the same wind, from the same seed."""
        first = self.scenarios[FIRST]
        if request["model"] not in models():
            raise BarchanError(f"no model '{request['model']}'; allowed: {', '.join(models())}")
        second = validate({**first, "model": {"name": request["model"]}}).data()
        self._begin({FIRST: first, SECOND: second}, True, _answer_of(SECOND, request))
        self._send("runs", runs=list(self.workers))

    @SESSION.handles("alone")
    def _alone(self, _: Request) -> None:
        """End the second simulation."""
        self.lockstep = None
        worker = self.workers.pop(SECOND, None)
        if worker is not None:
            worker.close()
        self.scenarios.pop(SECOND, None)
        self._send("runs", runs=list(self.workers))

    @SESSION.handles("revive")
    def _revive(self, _: Request) -> None:
        """Start lost workers again, from the beginning of their scenarios."""
        if self.scenarios:
            self._begin(dict(self.scenarios), running=True)
        else:
            self.start()

    @SESSION.handles("save")
    def _save(self, request: Request) -> None:
        """Save a run as an archive in the session's folder."""
        folder = self.workspace.run(str(request["name"]))
        worker = self.workers[request.get("run") or FIRST]
        worker.send("save_folder", folder=str(folder), id=request.get("id"))

    @SESSION.handles("open")
    def _open(self, request: Request) -> None:
        """Continue an archive of the session's folder."""
        folder = self.workspace.run(str(request["name"]))
        if folder.name not in self.workspace.runs():
            raise BarchanError(f"no run '{folder.name}' in {self.workspace.folder}")
        self._alone(request)
        self._worker(FIRST).send("open_folder", folder=str(folder), id=request.get("id"))


def _answer_of(name: str, request: Request) -> dict[str, Request]:
    """The id of a request that a worker answers when it has begun, by the worker's name."""
    return {name: {"id": request["id"]}} if request.get("id") is not None else {}
