"""The session: one or two simulations, the browser that commands them, and those that watch."""

import asyncio
from pathlib import Path
from typing import Any

from barchan.scenario import Scenario
from barchan.studio.protocol import PROTOCOL, Request, message, numbered
from barchan.studio.server.aside import Aside
from barchan.studio.server.audience import Audience, Viewer
from barchan.studio.server.autosave import Autosave
from barchan.studio.server.browser_requests import BrowserRequests
from barchan.studio.server.films import Films
from barchan.studio.server.joint_answers import JointAnswers
from barchan.studio.server.kept_states import KeptStates
from barchan.studio.server.lockstep import Lockstep
from barchan.studio.server.pairs import open_together
from barchan.studio.server.reports import Reports
from barchan.studio.server.session_commands import FIRST, SECOND
from barchan.studio.server.starts import Starts
from barchan.studio.server.together import is_together, read_together
from barchan.studio.server.unfinished import Unfinished
from barchan.studio.server.worker_handle import WorkerHandle
from barchan.studio.server.worker_messages import WorkerMessages
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
        asked: bool = True,
    ) -> None:
        """Prepare a session that begins with a scenario, an archive, or two that were saved together.

        ``asked`` is whether somebody asked for the scenario. Its runs are kept in ``home`` in case that the
        studio ends unexpectedly.
        """
        self.workspace = workspace
        self.workers: dict[str, WorkerHandle] = {}
        self.scenarios: dict[str, dict[str, Any]] = {}
        """The scenario of each worker, as changes during the run have left it."""
        self.origins: dict[str, dict[str, Any]] = {}
        """The scenario that was loaded into each worker, of which its own came by changes on the page."""
        self.starts = Starts()
        self.kept = KeptStates()
        self.aside = Aside(self)
        self.lockstep: Lockstep | None = None
        self._keeping: asyncio.TimerHandle | None = None
        self.audience = Audience()
        self.reports = Reports(self)
        self.films = Films(workspace)
        self.joint = JointAnswers(self)
        self.requests = BrowserRequests(self)
        self.messages = WorkerMessages(self)
        self.unfinished = Unfinished(home)
        self.autosave = Autosave(self, home)
        self._opened: list[Path] = []
        if archive is not None:
            self._opened = read_together(archive).folders if is_together(archive) else [archive]
            self.first: Request = {"command": "open_folder", "folder": str(self._opened[0])}
        else:
            data = (scenario or Scenario()).seeded().data()
            workspace.trust(data)
            self.first = {"command": "start", "scenario": data, "running": True, "unasked": not asked}

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
        self.films.give_up()
        for worker in self.workers.values():
            worker.close()
        self.workers.clear()
        self.autosave.close()  # when no worker writes into its folder any more

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
                viewer.send(self.messages.loss(worker))
        if not first:
            self.audience.show(viewer)
        self.audience.count()
        return viewer

    def detach(self, viewer: Viewer) -> None:
        """A browser went."""
        self.audience.leave(viewer)

    def tell(self, kind: str, **content: Any) -> None:
        """Send the browser that commands a message, where there is one."""
        self.audience.to_owner(message(kind, **content))

    def worker(self, name: str) -> WorkerHandle:
        """The worker of that name, a new one where there is none or it was lost."""
        worker = self.workers.get(name)
        if worker is None or not worker.process.is_alive():
            worker = self.workers[name] = WorkerHandle(name, self.messages.on_data, self.messages.on_exit)
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

    def pair_again(self) -> None:
        """Pause two runs; neither waits for steps of the other any more, whose process may be lost."""
        if self.lockstep is not None:
            self.lead(Lockstep(self.workers, self.on_lockstep))

    def lead(self, pair: Lockstep) -> None:
        """Let two runs be led together from now on, paused."""
        self._end_lockstep()
        self.lockstep = pair
        pair.pause()

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
        if self.lockstep is not None:
            self.lockstep.ends = {name: int(data["run"]["steps"]) for name, data in scenarios.items()}
            if running:
                self.lockstep.run()

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
        self.origins.pop(SECOND, None)
        self.kept.forget(SECOND)
        self.audience.forget(SECOND)
        self.report_runs()

    def left_on_disk(self) -> dict[str, Any]:
        """Runs that no studio holds, as the page takes them."""
        return self.unfinished.look().data(self.autosave.left)
