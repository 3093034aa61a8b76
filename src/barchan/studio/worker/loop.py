"""The process of one simulation: it carries out requests, does steps, and sends frames."""

import json
import os
import signal
from collections.abc import Callable
from multiprocessing.connection import Connection, wait
from typing import TYPE_CHECKING, Any

from barchan.errors import ScenarioError
from barchan.studio.protocol import ANSWERED, Request, is_state, message, read_request, state_head

if TYPE_CHECKING:
    from barchan.studio.worker.handlers import Answer
    from barchan.studio.worker.run import StudioRun

LOOK_AGAIN = 0.05
"""Seconds between two looks at answers that are owed, for a run at rest."""

NICENESS = 10
"""How far measuring stands back behind the model and the browser."""

FULL_WAIT = 0.05
"""Seconds between two looks at a run that waits for its measures."""


def run_measurer(connection: Connection) -> None:
    """Measure the states that a worker sends until it closes the connection; load nothing until woken."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    if hasattr(os, "nice"):
        os.nice(NICENESS)
    try:
        connection.recv_bytes()
        from barchan.studio.worker.measuring import Measuring

        measuring = Measuring()
        connection.send_bytes(b"ready")
        while True:
            connection.send_bytes(json.dumps(measuring.answer(connection.recv_bytes())).encode())
    except (EOFError, BrokenPipeError, ConnectionResetError):
        return


def run_worker(connection: Connection, name: str, measurer: Connection | None = None) -> None:
    """Be the worker at this end of a connection until it is closed; ``measurer`` measures its states."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the server's: it ends its workers itself
    Worker(connection, name, measurer).serve()


class Worker:
    """Takes requests from its connection and answers on it."""

    def __init__(
        self,
        connection: Connection,
        name: str,
        measurer: Connection | None = None,
        answer: Callable[[bytes], None] | None = None,
    ) -> None:
        """Wait for a scenario; ``answer`` takes what is sent, where it does not go back by the connection."""
        from barchan.studio.worker.commands import RunCommands
        from barchan.studio.worker.desk import Desk
        from barchan.studio.worker.frame_sender import FrameSender
        from barchan.studio.worker.owed import OwedAnswers

        self.connection = connection
        self.name = name
        self.answer = answer or connection.send_bytes
        self.frames = FrameSender(name, self.answer)
        self.desk = Desk(measurer)
        self.owed = OwedAnswers(self.send, lambda request, error: self._refuse(request, reason(error), []))
        self.commands = RunCommands(self.frames, self.send, self.answer, self.desk)
        self.commands.break_off = self.owed.break_off

    def serve(self) -> None:
        """Carry requests out and do steps until the connection is closed."""
        from barchan.kernels.core.compile_notice import told_of_compilation
        from barchan.kernels.core.threads import asked_for, thread_count

        one_for_the_browser = asked_for(max(1, thread_count() - 1))
        with one_for_the_browser, told_of_compilation(self._tell_of_compilation):
            try:
                while True:
                    self.receive()
                    self.work()
            except (EOFError, BrokenPipeError, ConnectionResetError):
                return

    def _tell_of_compilation(self, functions: int) -> None:
        self.send("compiling", functions=functions)

    def send(self, kind: str, **content: Any) -> None:
        """Send a control message."""
        self.answer(message(kind, run=self.name, **content))

    def receive(self) -> None:
        """Carry out the requests that have come; wait for some where there is nothing else to do."""
        measured = [self.desk.connection] if self.desk.connection is not None else []
        if not self.connection.poll():
            wait([self.connection, *measured], self._patience())
        while self.connection.poll():
            self.on_data(self.connection.recv_bytes())

    def _patience(self) -> float | None:
        run = self.commands.run
        if run is None:
            return None
        if self.desk.full:
            return FULL_WAIT
        if run.busy:
            return run.speed.wait()
        due = self.frames.wait()
        return min(LOOK_AGAIN, due or LOOK_AGAIN) if self.owed else due

    def on_data(self, data: bytes) -> None:
        """Carry out a request, or continue from the state that the server has kept."""
        if is_state(data):
            self.on_request({"command": "resume", "state": data, "number": state_head(data)[0]})
        else:
            self.on_request(read_request(data))

    def on_request(self, request: Request) -> None:
        """Carry out one request; one that cannot be carried out is answered, never fatal."""
        try:
            result = self.commands.carry_out(request)
        except ScenarioError as error:
            self._refuse(request, "; ".join(map(str, error.problems)), [vars(p) for p in error.problems])
        except ANSWERED as error:
            self._refuse(request, reason(error), [])
        else:
            self._answer(request, result)

    def _answer(self, request: Request, result: "Answer") -> None:
        """Answer a request, or note that its answer is not there yet."""
        if result is not None and not isinstance(result, dict):
            self.owed.add(request, result)
        elif request.get("id") is not None:
            self.send("done", id=request["id"], **(result or {}))

    def _refuse(self, request: Request, text: str, problems: list[dict[str, Any]]) -> None:
        named = {"id": request.get("id"), "command": request["command"]}
        self.send("refused", **named, text=text, problems=problems)

    def work(self) -> None:
        """Do some steps, then send a frame if one is due and can be taken."""
        run = self.commands.run
        if run is None:
            return
        if not run.busy or run.live.steps_done:
            self.desk.wake()
        if self.desk.collect() and not run.busy:
            self.frames.stale = True  # measures go with frames
        self.owed.pay()
        if run.busy:
            if self.frames.is_first and self.frames.credit:
                self.frames.send(run)  # the first steps may wait for their kernels to be compiled
            arrived = self._advance(run)
            self.frames.stale = True
            if arrived:
                if self.frames.credit:  # those who compare two runs see both at every meeting
                    self.frames.send(run)
                self.commands.arrive()
        if not (run.busy and run.brief):  # on the way to a meeting two runs are at different steps
            self.frames.send_if_due(run)

    def _advance(self, run: "StudioRun") -> bool:
        """Do some steps; a run whose steps fail is paused at the last state that is whole."""
        try:
            return run.advance_chunk()
        except ANSWERED as error:
            step = run.live.steps_done
            run.recover()
            self.commands.describe()
            text = f"the run is paused at step {run.live.steps_done}: after step {step} {reason(error)}"
            self._refuse({"command": "run"}, text, [])
            return False


def reason(error: Exception) -> str:
    """The text of an error; memory that was not to be had is named with its amount where that is known."""
    text = str(error)
    if isinstance(error, LookupError):
        return f"this is a fault of the program ({type(error).__name__}: {text}); please report it"
    if isinstance(error, MemoryError):
        return f"more memory was needed than is free{f' ({text})' if text else ''}"
    return text or type(error).__name__
