"""Starting the server and the browser, and ending both."""

import asyncio
import signal
import socket
import threading
import webbrowser
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from ipaddress import ip_address
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING

from barchan.errors import BarchanError
from barchan.scenario import Scenario
from barchan.studio.protocol import LARGEST_MESSAGE
from barchan.studio.server import gallery
from barchan.studio.server.page_version import check_page
from barchan.studio.server.security import EVERYWHERE, LOOPBACK, Guard
from barchan.studio.server.session import Session
from barchan.studio.server.unfinished import Found
from barchan.studio.server.user_data import data_folder
from barchan.studio.server.workspace import Workspace

if TYPE_CHECKING:
    import uvicorn
    from starlette.types import ASGIApp

PORT = 8127
"""The usual port: browsers keep preferences and bookmarks by address and port."""

AUTOSAVES = "studio-autosave"
"""The folder, among the user's data, of runs that are kept in case that a studio ends unexpectedly."""

SOMEWHERE = "192.0.2.1"
"""An address beyond any network of one's own: one of those kept for examples."""


@dataclass(frozen=True)
class Studio:
    """The scenario or archive to start with, and the address to serve at."""

    folder: Path
    scenario: Scenario | None = None
    archive: Path | None = None
    host: str = "127.0.0.1"
    port: int | None = None
    """0: any free one; None: the usual one, so that what the browser keeps is found again, or a free one."""
    gallery: bool = False
    """Whether the page opens with the gallery of presets."""
    asked: bool = True
    """Whether somebody asked for the scenario, or for a value of it."""


def serve(
    studio: Studio,
    ready: Callable[[str], None],
    open_browser: bool = True,
    left: Callable[[Found], None] = lambda _: None,
) -> None:
    """Serve until interrupted; ``ready`` is called with the address. All workers end with the server.

    ``left`` is called with the runs that earlier studios have left because they ended unexpectedly.
    Raises BarchanError where the address is taken, or the page was not built or speaks another protocol.
    """
    from barchan.studio.server.app import CLIENT, application

    check_page(CLIENT)
    sock = usual_listener(studio.host) if studio.port is None else listener(studio.host, studio.port)
    port = sock.getsockname()[1]
    guard = Guard(port, tuple({*LOOPBACK, studio.host, *names_of(studio.host)}))
    home = data_folder() / AUTOSAVES
    session = Session(Workspace(studio.folder), studio.scenario, studio.archive, home, studio.asked)
    config = configured(application(session, guard))
    shown = "127.0.0.1" if studio.host in EVERYWHERE else studio.host
    address = f"{guard.address(shown)}/?token={guard.token}"
    address += "#gallery" if studio.gallery else ""
    ready(address)
    gallery.prepare()
    if open_browser:
        webbrowser.open(address)
    threading.Thread(target=lambda: left(session.unfinished.look()), daemon=True, name="unfinished").start()
    try:
        asyncio.run(_server(config, session.autosave.forsake).serve([sock]))
    except KeyboardInterrupt:
        session.autosave.forsake()
    finally:
        with uninterrupted():
            session.close()
            sock.close()


def _server(config: "uvicorn.Config", interrupted: Callable[[], None]) -> "uvicorn.Server":
    """A server that says when the user ends it: before it closes anything, and whatever else may come then.

    A system that shuts down, or a terminal that is closed, sends another signal than Ctrl-C.
    """
    import uvicorn

    class Server(uvicorn.Server):
        def handle_exit(self, sig: int, frame: FrameType | None) -> None:
            if sig == signal.SIGINT:
                interrupted()
            super().handle_exit(sig, frame)

    return Server(config)


@contextmanager
def uninterrupted() -> Iterator[None]:
    """Carry something out whole, although Ctrl-C is pressed once more meanwhile."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


def configured(app: "ASGIApp") -> "uvicorn.Config":
    """How an application is served."""
    import uvicorn

    return uvicorn.Config(
        app,
        log_level="warning",
        server_header=False,
        ws="websockets-sansio",
        ws_max_size=LARGEST_MESSAGE,
        ws_per_message_deflate=False,
        timeout_graceful_shutdown=1,
    )


def usual_listener(host: str) -> socket.socket:
    """A socket that listens at the usual port, or at a free one where that is taken.

    Raises BarchanError where it cannot listen at all.
    """
    try:
        return listener(host, PORT)
    except BarchanError:
        return listener(host, 0)


def listener(host: str, port: int) -> socket.socket:
    """A socket that listens; raises BarchanError where it cannot."""
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    sock = socket.socket(family, socket.SOCK_STREAM)
    try:
        sock.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        sock.bind((host, port))
        sock.listen()
    except OSError as error:
        sock.close()
        raise BarchanError(f"cannot serve at {host}:{port}: {error.strerror or error}") from None
    return sock


def names_of(host: str) -> list[str]:
    """Names under which others reach a server that listens on all addresses."""
    if host not in EVERYWHERE:
        return []
    name = socket.gethostname()
    try:
        found = [str(info[4][0]) for info in socket.getaddrinfo(name, None)]
    except OSError:
        found = []  # a computer need not know its own name
    return [name, *(one for one in [*found, *_outward()] if not ip_address(one.split("%")[0]).is_loopback)]


def _outward() -> list[str]:
    """The address of this computer in its network: that of the way out, on which nothing is sent."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        try:
            sock.connect((SOMEWHERE, 9))
            return [str(sock.getsockname()[0])]
        except OSError:
            return []
