"""The thread that a view's run lives in: a worker of the studio, asked through a pipe, answering by calls."""

import json
import threading
from collections.abc import Callable
from concurrent.futures import Future
from multiprocessing import Pipe
from typing import Any

from barchan.errors import BarchanError
from barchan.studio.commands import COMMANDS
from barchan.studio.protocol import Request, is_frame
from barchan.studio.worker.loop import Worker, reason
from barchan.studio.worker.run import StudioRun

NAME = "a"
"""The name of the run in messages: a view has one."""

PATIENCE = 60.0
"""Seconds that an answer is waited for: kernels may have to be compiled meanwhile."""

Take = Callable[[bytes], None]
Say = Callable[[dict[str, Any]], None]


class Host:
    """Runs a run, paused at first, until it is closed."""

    def __init__(self, run: StudioRun, take_frame: Take, say: Say) -> None:
        """Give frames to ``take_frame`` and messages to ``say``, both called by the thread of the run."""
        self._take_frame, self._say = take_frame, say
        self._requests, self._ours = Pipe(duplex=False)
        self._waiting: dict[str, Future[dict[str, Any]]] = {}
        self._closing = threading.Lock()
        self._last = 0
        self.worker = Worker(self._requests, NAME, answer=self._on_data)
        self.worker.commands.take(run, running=False)
        self._thread = threading.Thread(target=self._work, name="barchan view", daemon=True)
        self._thread.start()

    @property
    def run(self) -> StudioRun:
        """The run, which the thread may be changing."""
        return self.worker.commands.current

    def send(self, request: Request) -> None:
        """Let a request be carried out; its answer, or refusal, comes as a message.

        Raises BarchanError for an unknown command and once the view is closed.
        """
        name = request.get("command")
        if name not in COMMANDS or COMMANDS[name].owner != "worker" or _is_inner(name):
            raise BarchanError(f"a view has no command '{name}'")
        data = json.dumps(request, allow_nan=False).encode()
        with self._closing:
            if self._ours.closed:
                raise BarchanError("the view is closed")
            self._ours.send_bytes(data)

    def ask(self, command: str, **content: Any) -> dict[str, Any]:
        """Carry a command out and wait for it; raises BarchanError where it is refused."""
        self._last += 1
        asked = f"python-{self._last}"
        answer = self._waiting[asked] = Future()
        self.send({"command": command, "id": asked, **content})
        return answer.result(PATIENCE)

    def close(self) -> None:
        """End the thread after the steps it is at, and let go of the run."""
        with self._closing:
            self._ours.close()
        if threading.current_thread() is not self._thread:
            self._thread.join()
        for waiting in self._waiting.values():
            waiting.set_exception(BarchanError("the view is closed"))
        self._waiting.clear()
        self.worker.commands.run = None

    def _work(self) -> None:
        try:
            self.worker.serve()
        except Exception as error:  # a thread that ends in silence would leave a view that never answers
            self._say({"type": "refused", "text": f"the view has ended: {reason(error)}", "problems": []})
            raise
        finally:
            self._requests.close()

    def _on_data(self, data: bytes) -> None:
        if is_frame(data):
            return self._take_frame(data)
        message = json.loads(data)
        waiting = self._waiting.pop(str(message.get("id")), None)
        if waiting is None:
            self._say(message)
        elif message["type"] == "refused":
            waiting.set_exception(BarchanError(message["text"]))
        else:
            waiting.set_result(message)
        return None


def _is_inner(name: str) -> bool:
    """Whether only the studio's server gives a command; views attach themselves."""
    return COMMANDS[name].internal and name != "attach"
