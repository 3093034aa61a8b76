"""Messages of workers: what they say to the browsers, and what the session makes of it."""

import json
from typing import TYPE_CHECKING, Any

from barchan.studio.protocol import Request, is_frame, is_state, message
from barchan.studio.server.joint_answers import is_joint
from barchan.studio.server.session_commands import ENDS_SECOND, FIRST, SECOND
from barchan.studio.server.worker_handle import WorkerHandle

if TYPE_CHECKING:
    from barchan.studio.server.session import Session


class WorkerMessages:
    """Takes what workers send, and notes when one of them ends by itself."""

    def __init__(self, session: "Session") -> None:
        """Serve a session."""
        self.session = session

    def on_data(self, worker: WorkerHandle, data: bytes) -> None:
        """Pass a worker's message or frame on to the browser, and note what concerns all workers."""
        session, pair = self.session, self.session.lockstep
        if session.workers.get(worker.name) is not worker:
            return
        if is_state(data):
            session.kept.take(worker.name, data)
            return
        if is_frame(data):
            session.audience.on_frame(worker.name, data)
            return
        content = json.loads(data)
        if content["type"] == "refused":
            said = session.workspace.plainly(content["text"], content["problems"])
            content["text"], content["problems"] = said
            data = message("refused", **{name: one for name, one in content.items() if name != "type"})
        if content["type"] == "begun":
            self._on_begun(worker.name, content)
            return
        if session.reports.takes(content) or session.joint.takes(content):
            return
        if content["type"] == "scenario":
            session.scenarios[worker.name] = content["scenario"]
            if pair is not None:
                pair.stands(worker.name, content["step"], content["end"])
            session.workspace.trust(content["scenario"])
        elif content["type"] == "arrived":
            if pair is not None:
                pair.arrived(worker.name, content["step"], content["order"])
            else:
                session.autosave.soon()
        elif content["type"] == "refused" and content["command"] == "run" and pair is not None:
            pair.stopped(worker.name)
        session.audience.on_message(worker.name, content["type"], data)

    def on_exit(self, worker: WorkerHandle) -> None:
        """A worker ended by itself."""
        session = self.session
        if session.workers.get(worker.name) is worker:
            worker.process.join()
            session.reports.lose(worker.name)
            session.joint.lose(worker.name)
            session.pair_again()
            session.audience.to_all(self.loss(worker))
            if (missed := session.starts.lost(worker.name)) is not None:
                session.start_run(worker.name, missed)

    def loss(self, worker: WorkerHandle) -> bytes:
        """The message that a worker has ended by itself."""
        session = self.session
        kept = session.kept.common_step(list(session.workers))
        return message("lost", run=worker.name, code=worker.process.exitcode, kept=kept)

    def _on_begun(self, name: str, content: dict[str, Any]) -> None:
        """A worker has begun a run, or refused to."""
        session = self.session
        start = session.starts.answered(name, content["number"])
        start_request: Request = (start.request if start is not None else None) or {}
        if content["ok"]:
            session.origins[name] = content["origin"]
            if name == FIRST and start_request:
                session.aside.begun(name, start_request, content["aside"])
            session.kept.begun(name, content["number"], resumed=start is not None and start.request is None)
            if start_request.get(ENDS_SECOND) and session.starts.scenario(name) is None:
                session.end_second()  # unless two are to begin by now
        elif name == SECOND and SECOND not in session.scenarios and not is_joint(start_request):
            session.end_second()
            session.aside.take_back(FIRST)
