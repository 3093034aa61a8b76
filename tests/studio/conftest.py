"""A server with a small field, and a browser's end of the connection to it."""

import json
import threading
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import pytest
import uvicorn
from websockets.sync.client import ClientConnection, connect

from barchan.scenario import Scenario, validate
from barchan.studio.server.app import application
from barchan.studio.server.launch import configured, listener
from barchan.studio.server.security import Guard
from barchan.studio.server.session import Session
from barchan.studio.server.workspace import Workspace
from tests.studio.frames import read_frame

PATIENCE = 60.0


def small(**parts) -> Scenario:
    data = {
        "barchan": 5,
        "lattice": {"rows": 32, "columns": 48},
        "run": {"steps": 100, "seed": 7, "save_every": 10},
        **parts,
    }
    return validate(data)


@pytest.fixture
def scenario() -> Scenario:
    return small()


class Browser:
    """Sends and receives as the page would."""

    def __init__(self, connection: ClientConnection, confirms: bool = True) -> None:
        self.connection = connection
        self.confirms = confirms
        self.frames = []
        self.messages = []

    def send(self, command: str, **content) -> None:
        self.connection.send(json.dumps({"command": command, **content}))

    def receive(self):
        """The next frame's header and fields, or a message and None."""
        data = self.connection.recv(timeout=PATIENCE)
        if isinstance(data, str):
            self.messages.append(json.loads(data))
            return self.messages[-1], None
        header, fields = read_frame(data)
        self.frames.append((header, fields))
        if self.confirms:
            self.send("confirm", run=header["run"])
        return header, fields

    def drain(self, seconds: float) -> None:
        """Receive until nothing comes for some seconds, which raises TimeoutError."""
        while True:
            self.connection.recv(timeout=seconds)

    def flood(self, count: int) -> None:
        for _ in range(count):
            self.send("saved")
        self.drain(10.0)

    def until(self, wanted):
        """Receive until something is as wanted."""
        for _ in range(5000):
            header, fields = self.receive()
            if wanted(header, fields):
                return header, fields
        raise AssertionError("never came")

    def until_message(self, kind: str, **content):
        def wanted(header, _):
            return header.get("type") == kind and content.items() <= header.items()

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

    def connection(self, token: str | None = None, **options) -> ClientConnection:
        url = f"ws://127.0.0.1:{self.port}/connection?token={self.guard.token if token is None else token}"
        return connect(url, max_size=None, compression=None, proxy=None, **options)

    @contextmanager
    def browser(self, confirms: bool = True):
        with self.connection() as connection:
            yield Browser(connection, confirms)


@contextmanager
def serving(
    folder: Path,
    scenario: Scenario | None = None,
    archive: Path | None = None,
    port: int = 0,
    home: Path | None = None,
):
    """A server in a thread; it keeps its runs in ``home``."""
    socket = listener("127.0.0.1", port)
    guard = Guard(socket.getsockname()[1])
    session = Session(Workspace(folder), scenario, archive, home)
    config = configured(application(session, guard))
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
