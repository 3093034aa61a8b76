"""The complete state of a run as bytes, which the server keeps in case that the worker is lost."""

import pickle
import struct
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from barchan.simulation import State
from barchan.studio.protocol import STATE_HEAD, STATE_MAGIC
from barchan.studio.worker.desk import Desk
from barchan.studio.worker.run import StudioRun
from barchan.studio.worker.state_files import StateNames
from barchan.studio.worker.state_folder import beside_newest, with_past

MOST = 256 << 20
"""Bytes of a state that are kept outside the worker; larger ones would fill the server and the pipe to it."""


@dataclass(frozen=True)
class Newest:
    """All that a run goes on from, as it was at one moment."""

    state: State
    beside: dict[str, Any]
    """Measures, bookmarks and branches, with the names of the files of other states, and their folder."""


def newest_of(run: StudioRun) -> State | None:
    """The newest state of a run; None where it is larger than ``MOST``."""
    state = run.live.state()
    return None if sum(array.nbytes for array in state.arrays.values()) > MOST else state


def to_bytes(run: StudioRun, number: int, files: StateNames) -> bytes | None:
    """The newest state of a run, with the ``number`` of the start that it goes back to.

    ``files`` are those of the run on disk, where it is kept, too. None where it is larger than ``MOST``.
    """
    state = newest_of(run)
    if state is None:
        return None
    newest = Newest(state, beside_newest(run, files))
    content = pickle.dumps(newest, pickle.HIGHEST_PROTOCOL)
    return STATE_MAGIC + struct.pack(STATE_HEAD, number, state.step) + content


def from_bytes(data: bytes, desk: Desk | None = None) -> tuple[StudioRun, list[str]]:
    """The run whose state ``to_bytes`` gave, paused, and a text for each of its branches that is lost.

    Earlier states and other branches are there as far as they were written to disk.
    """
    head = len(STATE_MAGIC) + struct.calcsize(STATE_HEAD)
    newest: Newest = pickle.loads(memoryview(data)[head:])  # noqa: S301 - a worker of this session wrote it
    return with_past(newest.state, newest.beside, Path(newest.beside["folder"]), desk)
