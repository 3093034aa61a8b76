"""The session: one or two simulations, the browser that commands them, and those that watch."""

import asyncio
import json
from pathlib import Path
from typing import Any

from barchan.errors import BarchanError, ScenarioError
from barchan.scenario import Scenario
from barchan.studio.commands import COMMANDS, command_of
from barchan.studio.protocol import (
    ANSWERED,
    PROTOCOL,
    Request,
    is_frame,
    is_state,
    message,
    numbered,
    read_request,
)
from barchan.studio.server.aside import Aside
from barchan.studio.server.audience import Audience, Viewer
from barchan.studio.server.autosave import Autosave
from barchan.studio.server.films import Films
from barchan.studio.server.joint_answers import JointAnswers, is_joint
from barchan.studio.server.kept_states import KeptStates
from barchan.studio.server.lockstep import Lockstep
from barchan.studio.server.pairs import open_together
from barchan.studio.server.queries import QUERIES
from barchan.studio.server.reports import Reports
from barchan.studio.server.session_commands import FIRST, SECOND, SESSION
from barchan.studio.server.starts import Starts
from barchan.studio.server.together import is_together, read_together
from barchan.studio.server.unfinished import Unfinished
from barchan.studio.server.worker_handle import WorkerHandle
from barchan.studio.server.workspace import Workspace
from barchan.version import __version__


class Session:
    """Workers, the browsers that are connected, and the messages between them."""

    def __init__(
        self,
        workspace: Workspace,
        scenario: Scenario | None = None,
        archive: Path | None = None,
        home: Path | None = None,
    ) -> None:
        """Prepare a session that begins with a scenario, an archive, or two that were saved together.

        Its runs are kept in ``home`` in case that the studio ends unexpectedly.
        """
        self.workspace = workspace
        self.workers: dict[str, WorkerHandle] = {}
        self.scenarios: dict[str, dict[str, Any]] = {}
        """The scenario of each worker, as changes during the run have left it."""
        self.starts = Starts()
        self.kept = KeptStates()
        self.aside = Aside(self)
        self.lockstep: Lockstep | None = None
        self._keeping: asyncio.TimerHandle | None = None
        self.audience = Audience()
        self.reports = Reports(self)
        self.films = Films(workspace)
        self.joint = JointAnswers(self)
        self.unfinished = Unfinished(home)
        self.autosave = Autosave(self, home)
        self._opened: list[Path] = []
        if archive is not None:
            self._opened = read_together(archive).folders if is_together(archive) else [archive]
            self.first: Request = {"command": "open_folder", "folder": str(self._opened[0])}
        else:
            data = (scenario or Scenario()).seeded().data()
            workspace.trust(data)
            self.first = {"command": "start", "scenario": data, "running": True}

    def start(self) -> None:
        """Start the first worker, both for two that were saved together."""
        if len(self._opened) > 1:
            open_together(self, self._opened)
        else:
            self.start_run(FIRST, self.first)
        self._keep()
        self.autosave.begin()

    def close(self) -> None:
        """End all workers."""
        if self._keeping is not None:
            self._keeping.cancel()
        self.autosave.close()
        self.films.give_up()
        for worker in self.workers.values():
            worker.close()
        self.workers.clear()

    def attach(self, commands: bool = True) -> Viewer:
        """A browser came; one that commands replaces an earlier one. Returns where its data wait."""
        viewer = Viewer(commands)
        first = self.audience.join(viewer)
        running = self.lockstep is not None and self.lockstep.running
        hello = {
            "protocol": PROTOCOL,
            "version": __version__,
            "runs": list(self.workers),
            "running": running,
        }
        viewer.send(message("hello", **hello, watching=not commands))
        for worker in self.workers.values():
            if first:  # what was sent to those before may be long ago
                self.audience.forget(worker.name)
                worker.send("attach")
            if not worker.process.is_alive():
                viewer.send(self._loss(worker))
        if not first:
            self.audience.show(viewer)
        self.audience.count()
        return viewer

    def detach(self, viewer: Viewer) -> None:
        """A browser went."""
        self.audience.leave(viewer)

    def on_message(self, viewer: Viewer, text: str) -> None:
        """Carry out a request of a browser; one that cannot be carried out is answered with the reason."""
        request: Request = {}
        try:
            request = read_request(text)
            if request.get("command") == "confirm":
                self._confirm(viewer, request.get("run"))
            elif viewer is not self.audience.owner:
                raise BarchanError("this window only watches; another one commands the run")
            else:
                self._carry_out(request)
        except ScenarioError as error:
            viewer.refuse(request, str(error), [vars(problem) for problem in error.problems])
        except ANSWERED as error:
            viewer.refuse(request, str(error) or type(error).__name__, [])

    def tell(self, kind: str, **content: Any) -> None:
        """Send the browser that commands a message, where there is one."""
        self.audience.to_owner(message(kind, **content))

    def _confirm(self, viewer: Viewer, run: Any) -> None:
        """A browser has drawn a frame; workers make the next ones at the pace of the fastest browser."""
        for name, worker in self.workers.items():
            if run in (name, None):
                for _ in range(self.audience.confirm(viewer, name)):
                    worker.send("confirm")

    def _carry_out(self, request: Request) -> None:
        # Workers check by themselves whether they have a run.
        command = command_of(request.get("command"))
        if command.internal:
            raise BarchanError(f"unknown command '{command.name}'")
        if command.owner == "worker":
            self._pass_on(request)
        elif command.owner == "query":
            self.tell("done", id=request.get("id"), **QUERIES[command.name](self.workspace, request))
        else:
            command_of(command.name, has_run=FIRST in self.scenarios)
            SESSION[command.name](self, request)

    def _pass_on(self, request: Request) -> None:
        """Let the worker that is named, or where none is named all of them, carry a request out."""
        pair, command = self.lockstep, COMMANDS[request["command"]]
        if pair is not None and command.name == "run":
            pair.run(request.get("steps"), request.get("until"))
            return
        if pair is not None and command.name == "pause":
            pair.pause()
            return
        self.workspace.check(request)
        named = request.get("run")
        workers = [self.workers[name] for name in ([named] if named is not None else self.workers)]

        def pass_on() -> None:
            for worker in workers:
                worker.forward({**request, "run": None})
            if command.name == "pause":
                self.autosave.soon()

        if pair is None or command.pair == "any time":
            pass_on()
        else:  # to look at the newest state, of step null, nothing is paused
            pair.meet(pass_on, command.pair == "pause" and request.get("step", 0) is not None)

    def worker(self, name: str) -> WorkerHandle:
        """The worker of that name, a new one where there is none or it was lost."""
        worker = self.workers.get(name)
        if worker is None or not worker.process.is_alive():
            worker = self.workers[name] = WorkerHandle(name, self._on_worker_data, self._on_worker_exit)
            if self.audience.viewers:
                worker.send("attach")
        return worker

    def start_run(self, name: str, request: Request) -> None:
        """Let a worker begin a run."""
        start = self.starts.add(name, request, request.get("scenario"))
        assert start.request is not None
        self.worker(name).forward(start.request)

    def _keep(self) -> None:
        """Let the workers send their states, to be kept, now and again and again."""
        if self.lockstep is not None:
            self.lockstep.keep()
        else:
            for worker in self.workers.values():
                worker.send("keep")
        self._keeping = asyncio.get_running_loop().call_later(self.kept.pause, self._keep)

    def _on_worker_data(self, worker: WorkerHandle, data: bytes) -> None:
        """Pass a worker's message or frame on to the browser, and note what concerns all workers."""
        if self.workers.get(worker.name) is not worker:
            return
        if is_state(data):
            self.kept.take(worker.name, data)
            return
        if is_frame(data):
            self.audience.on_frame(worker.name, data)
            return
        content = json.loads(data)
        if content["type"] == "begun":
            self._on_begun(worker.name, content)
            return
        if self.reports.takes(content) or self.joint.takes(content):
            return
        if content["type"] == "scenario":
            self.scenarios[worker.name] = content["scenario"]
            self.workspace.trust(content["scenario"])
        elif content["type"] == "arrived" and self.lockstep is not None:
            self.lockstep.arrived(worker.name, content["step"], content["order"])
        elif content["type"] == "arrived":
            self.autosave.soon()
        elif content["type"] == "refused" and content["command"] == "run" and self.lockstep is not None:
            self.lockstep.stopped(worker.name)
        self.audience.on_message(worker.name, content["type"], data)

    def _on_worker_exit(self, worker: WorkerHandle) -> None:
        """A worker ended by itself."""
        if self.workers.get(worker.name) is worker:
            worker.process.join()
            self.reports.lose(worker.name)
            self.joint.lose(worker.name)
            self.pair_again()
            self.audience.to_all(self._loss(worker))
            if (missed := self.starts.lost(worker.name)) is not None:
                self.start_run(worker.name, missed)

    def pair_again(self) -> None:
        """Pause two runs; neither waits for steps of the other any more, whose process may be lost."""
        if self.lockstep is not None:
            self.lead(Lockstep(self.workers, self.on_lockstep))

    def lead(self, pair: Lockstep) -> None:
        """Let two runs be led together from now on, paused."""
        self._end_lockstep()
        self.lockstep = pair
        pair.pause()

    def _loss(self, worker: WorkerHandle) -> bytes:
        """The message that a worker has ended by itself."""
        kept = self.kept.common_step(list(self.workers))
        return message("lost", run=worker.name, code=worker.process.exitcode, kept=kept)

    def _on_begun(self, name: str, content: dict[str, Any]) -> None:
        """A worker has begun a run, or refused to."""
        start = self.starts.answered(name, content["number"])
        start_request: Request = (start.request if start is not None else None) or {}
        if content["ok"]:
            if name == FIRST and start_request:
                self.aside.begun(name, start_request)
            self.kept.begun(name, content["number"], resumed=start is not None and start.request is None)
        elif name == SECOND and SECOND not in self.scenarios and not is_joint(start_request):
            self.end_second()
            self.aside.take_back(FIRST)

    def begin(
        self, scenarios: dict[str, dict[str, Any]], running: bool, answering: dict[str, Request] | None = None
    ) -> None:
        """Start these scenarios, in lockstep where there are two.

        ``answering`` adds to the requests of the workers that it names.
        """
        alone = len(scenarios) == 1
        self._end_lockstep()
        for name, data in scenarios.items():
            answer = (answering or {}).get(name, {})
            self.start_run(
                name, {"command": "start", **answer, "scenario": data, "running": running and alone}
            )
        self.lockstep = None if alone else Lockstep(self.workers, self.on_lockstep)
        if self.lockstep is not None and running:
            self.lockstep.run(min(int(data["run"]["steps"]) for data in scenarios.values()))

    def resume(self, step: int) -> None:
        """Let all runs continue from the states that are kept after a step."""
        states = {name: self.kept.at(name, step) for name in self.workers}
        self.pair_again()
        for name, state in states.items():
            start = self.starts.add(name, None)
            self.worker(name).send_bytes(numbered(state, start.number))

    def on_lockstep(self, running: bool) -> None:
        """Two runs that are led together started or stopped."""
        if not running:
            self.autosave.soon()
        self.audience.to_all(message("lockstep", running=running))

    def _end_lockstep(self) -> None:
        if self.lockstep is not None:
            self.lockstep.leave()
        self.lockstep = None

    def report_runs(self) -> None:
        """Let the browsers know the names of the runs."""
        self.audience.to_all(message("runs", runs=list(self.workers)))

    def end_second(self) -> None:
        """End the second simulation."""
        self._end_lockstep()
        self.reports.lose(SECOND)
        self.joint.lose(SECOND)
        worker = self.workers.pop(SECOND, None)
        if worker is not None:
            worker.close()
        self.scenarios.pop(SECOND, None)
        self.kept.forget(SECOND)
        self.audience.forget(SECOND)
        self.report_runs()
