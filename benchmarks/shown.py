"""How soon the studio shows something: the frame of a pause, and the first pictures of a page that is opened.

The frame is taken without a browser, so the time to draw it comes on top. The page is opened in a Chromium
that draws without a graphics card; where there is none, or no Playwright, that table is left out.
"""

import json
import statistics
import struct
import tempfile
import time
from collections.abc import Callable, Iterator
from multiprocessing import Pipe, get_context
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

from barchan.entry import load
from barchan.studio.pictures import RUN, opened
from barchan.studio.protocol import MAGIC, is_frame
from barchan.studio.worker.loop import run_measurer, run_worker

SIDES = {256: 0.1, 1024: 0.3}
"""Rows and columns, and the seconds from a pause to its frame that are asked."""

PAUSES, SPELL = 20, 0.7
"""Pauses of each field, and the seconds that a run goes on before the first; longer before each next."""

PAGES, PATIENCE, LOOK_AGAIN = 5, 60.0, 0.02
"""Pages that are opened, the seconds that one may take, and those between two looks at it."""

WINDOW = (1280, 720)
"""Pixels of the page."""

ASKED_OF_A_PAGE = 3.0
"""Seconds from opening the page to a picture that moves."""


def report() -> Iterator[str]:
    """The tables, line by line."""
    yield ""
    yield "| from a pause to its frame, `barchans` | ms | asked |"
    yield "|---|---|---|"
    for side, asked in SIDES.items():
        yield f"| {side}² | {_spread([1000 * seconds for seconds in pauses(side)], 0)} | {1000 * asked:.0f} |"
    try:
        pages = [_opening() for _ in range(PAGES + 1)][1:]  # the first one may compile
    except ImportError:
        return
    yield ""
    size = f"{WINDOW[0]} × {WINDOW[1]} pixels"
    yield f"| from opening the page, {size} drawn without a graphics card | s | asked |"
    yield "|---|---|---|"
    yield f"| first surface | {_spread([first for first, _ in pages], 1)} | |"
    moves = _spread([second for _, second in pages], 1)
    yield f"| second frame: the picture moves | {moves} | {ASKED_OF_A_PAGE:g} |"


def pauses(side: int) -> list[float]:
    """Seconds from asking a worker for a pause to its frame of the run at rest, while it is measured."""
    context, (ours, theirs) = get_context("spawn"), Pipe()
    measured, measuring = Pipe()
    processes = [
        context.Process(target=run_worker, args=(theirs, "run", measured), daemon=True),
        context.Process(target=run_measurer, args=(measuring,), daemon=True),
    ]
    for process in processes:
        process.start()
    for end in (theirs, measured, measuring):
        end.close()
    scenario = load("barchans", rows=side, columns=side, seed=1, steps=10**9).data()
    with ours:
        _send(ours, "attach")
        _send(ours, "start", scenario=scenario, number=1, running=True)
        _send(ours, "limit", rate=None)
        _until(ours, lambda status: status["step"] > 1)  # kernels are compiled
        found = [_pause(ours, SPELL * (1.0 + number / PAUSES)) for number in range(PAUSES)]
    for process in processes:
        process.join()
    return found


def _pause(worker: Connection, spell: float) -> float:
    """Let a run go on for so many seconds, then pause it."""
    _send(worker, "run")
    end = time.perf_counter() + spell
    _until(worker, lambda status: status["running"] and time.perf_counter() > end)
    began = time.perf_counter()
    _send(worker, "pause")
    return _until(worker, lambda status: not status["running"]) - began


def _until(worker: Connection, wanted: Callable[[dict[str, Any]], bool]) -> float:
    """Take frames until the status of one is as wanted; the moment when it came."""
    while True:
        data = worker.recv_bytes()
        if not is_frame(data):
            continue
        came = time.perf_counter()
        _send(worker, "confirm")
        (length,) = struct.unpack_from("<I", data, len(MAGIC))
        begin = len(MAGIC) + 4
        if wanted(json.loads(data[begin : begin + length])["status"]):
            return came


def _send(worker: Connection, command: str, **content: Any) -> None:
    worker.send_bytes(json.dumps({"command": command, **content}).encode())


def _opening() -> tuple[float, float]:
    """Seconds from opening a page to the first surface, and to the one after it."""
    with tempfile.TemporaryDirectory() as folder, opened(Path(folder), WINDOW) as (page, began):
        first = _seen(page, f"window.barchan && {RUN}?.ready")
        step = page.evaluate(f"{RUN}.status.step")
        return first - began, _seen(page, f"{RUN}.status.step > {step}") - began


def _seen(page: Any, expression: str) -> float:
    """The moment when an expression holds in a page."""
    end = time.perf_counter() + PATIENCE
    while time.perf_counter() < end:
        if page.evaluate(expression):
            return time.perf_counter()
        time.sleep(LOOK_AGAIN)
    raise SystemExit(f"after {PATIENCE:g} s the page did not show: {expression}")


def _spread(values: list[float], digits: int) -> str:
    least, middle, most = min(values), statistics.median(values), max(values)
    return f"{middle:.{digits}f} ({least:.{digits}f}–{most:.{digits}f})"
