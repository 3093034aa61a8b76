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
class _Saved:
    state: State
    every: int
    rows: list[dict[str, Any]]
    bookmarks: list[Bookmark]


def to_bytes(run: StudioRun, number: int) -> bytes | None:
    """The newest state of a run, with the ``number`` of the start that it goes back to.

    None where it is larger than ``MOST``.
    """
    state = run.live.state()
    if sum(array.nbytes for array in state.arrays.values()) > MOST:
        return None
    saved = _Saved(state, run.history.every, run.measures.rows, run.bookmarks_here())
    content = pickle.dumps(saved, pickle.HIGHEST_PROTOCOL)
    return STATE_MAGIC + struct.pack(STATE_HEAD, number, state.step) + content


def from_bytes(data: bytes, desk: Desk | None = None) -> StudioRun:
    """The run whose state ``to_bytes`` gave, paused; of its past only the measures are left."""
    head = len(STATE_MAGIC) + struct.calcsize(STATE_HEAD)
    saved: _Saved = pickle.loads(memoryview(data)[head:])  # noqa: S301 - a worker of this session wrote it
    return continued(saved.state, saved.every, saved.rows, saved.bookmarks, desk)


def continued(
    state: State, every: int, rows: list[dict[str, Any]], bookmarks: list[Bookmark], desk: Desk | None = None
) -> StudioRun:
    """A run that goes on from a state, paused; of its past the measures ``rows`` are left.

    States are kept every ``every`` steps from there on.
    """
    run = resumed(state, History(every, marks=marks_of(bookmarks)), desk)
    run.measures.rows = rows
    run.bookmarks = Bookmarks(bookmarks)
    run.measures.resend()
    return run
