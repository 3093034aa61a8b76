"""The complete state of a run as bytes, which the server keeps in case that the worker is lost."""

import pickle
import struct
from dataclasses import dataclass
from typing import Any

from barchan.simulation import State
from barchan.studio.protocol import STATE_HEAD, STATE_MAGIC
from barchan.studio.worker.bookmarks import Bookmark, Bookmarks, marks_of
from barchan.studio.worker.desk import Desk
from barchan.studio.worker.history import History
from barchan.studio.worker.run import StudioRun, resumed

MOST = 256 << 20
"""Bytes of a state that are kept outside the worker; larger ones would fill the server and the pipe to it."""


@dataclass(frozen=True)
class Newest:
    """All that a run goes on from, as it was at one moment."""

    state: State
    every: int
    rows: list[dict[str, Any]]
    bookmarks: list[Bookmark]


def newest_of(run: StudioRun) -> State | None:
    """The newest state of a run; None where it is larger than ``MOST``."""
    state = run.live.state()
    return None if sum(array.nbytes for array in state.arrays.values()) > MOST else state


def to_bytes(run: StudioRun, number: int) -> bytes | None:
    """The newest state of a run, with the ``number`` of the start that it goes back to.

    None where it is larger than ``MOST``.
    """
    state = newest_of(run)
    if state is None:
        return None
    newest = Newest(state, run.history.every, list(run.measures.rows), run.bookmarks_here())
    content = pickle.dumps(newest, pickle.HIGHEST_PROTOCOL)
    return STATE_MAGIC + struct.pack(STATE_HEAD, number, state.step) + content


def from_bytes(data: bytes, desk: Desk | None = None) -> StudioRun:
    """The run whose state ``to_bytes`` gave, paused; of its past only the measures are left."""
    head = len(STATE_MAGIC) + struct.calcsize(STATE_HEAD)
    newest: Newest = pickle.loads(memoryview(data)[head:])  # noqa: S301 - a worker of this session wrote it
    run = resumed(newest.state, History(newest.every, marks=marks_of(newest.bookmarks)), desk, newest.rows)
    run.bookmarks = Bookmarks(newest.bookmarks)
    return run
