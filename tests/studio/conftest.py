"""A server with a small field, and a browser's end of the line to it."""

import json
import threading
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import pytest
import uvicorn
from websockets.sync.client import ClientConnection, connect

from barchan.scenario import Scenario, validate
from barchan.studio.protocol import read_frame
from barchan.studio.server.app import application
from barchan.studio.server.launch import listener
from barchan.studio.server.security import Guard
from barchan.studio.server.session import Session
from barchan.studio.server.workspace import Store

PATIENCE = 60.0


def small(**parts) -> Scenario:
    data = {
        "barchan": 2,
        "lattice": {"rows": 32, "columns": 48},
        "run": {"steps": 100, "seed": 7, "save_every": 10},
        **parts,
    }
    return validate(data)


@pytest.fixture
def scenario() -> Scenario:
    return small()


class Browser:
    """Says and hears what the page would."""

    def __init__(self, line: ClientConnection, confirms: bool = True) -> None:
        self.line = line
        self.confirms = confirms
        self.frames = []
        self.told = []

    def say(self, do: str, **order) -> None:
        self.line.send(json.dumps({"do": do, **order}))

    def hear(self):
        """The next frame's header and fields, or what is told and None."""
        data = self.line.recv(timeout=PATIENCE)
        if isinstance(data, str):
            self.told.append(json.loads(data))
            return self.told[-1], None
        header, fields = read_frame(data)
        self.frames.append((header, fields))
        if self.confirms:
            self.say("confirm", run=header["run"])
        return header, fields

    def drain(self, seconds: float) -> None:
        """Listen until nothing comes for so long, which raises TimeoutError."""
        while True:
            self.line.recv(timeout=seconds)

    def flood(self, count: int) -> None:
        for _ in range(count):
            self.say("saved")
        self.drain(10.0)

    def until(self, wanted):
        """Listen until something is as wanted."""
        for _ in range(5000):
            header, fields = self.hear()
            if wanted(header, fields):
                return header, fields
        raise AssertionError("never came")

    def until_told(self, what: str, **content):
        def wanted(header, _):
            return header.get("tell") == what and content.items() <= header.items()

        return self.until(wanted)[0]

    def until_frame(self, wanted=lambda _: True):
        return self.until(lambda header, fields: fields is not None and wanted(header["status"]))


@dataclass
class Served:
    session: Session
    guard: Guard
    port: int
    folder: Path

    @property
    def address(self) -> str:
        return f"http://127.0.0.1:{self.port}"

    def line(self, token: str | None = None, **options) -> ClientConnection:
        url = f"ws://127.0.0.1:{self.port}/line?token={self.guard.token if token is None else token}"
        return connect(url, max_size=None, compression=None, proxy=None, **options)

    @contextmanager
    def browser(self, confirms: bool = True):
        with self.line() as line:
            yield Browser(line, confirms)


@contextmanager
def serving(folder: Path, scenario: Scenario | None = None, archive: Path | None = None):
    """A server in a thread."""
    socket = listener("127.0.0.1", 0)
    guard = Guard(socket.getsockname()[1])
    session = Session(Store(folder), scenario, archive)
    config = uvicorn.Config(
        application(session, guard),
        log_level="warning",
        ws="websockets-sansio",
        ws_per_message_deflate=False,
        timeout_graceful_shutdown=1,
    )
    server = uvicorn.Server(config)
    thread = threading.Thread(target=server.run, args=([socket],), daemon=True)
    thread.start()
    try:
        yield Served(session, guard, guard.port, folder)
    finally:
        server.should_exit = True
        thread.join(20)
        socket.close()


@pytest.fixture
def served(tmp_path, scenario):
    with serving(tmp_path, scenario) as server:
        yield server
