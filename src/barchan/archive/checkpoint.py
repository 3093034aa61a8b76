"""The newest complete state of a run, in one file that is replaced as a whole."""

import hashlib
import json
import os
from io import BytesIO
from pathlib import Path

import numpy as np

from barchan.errors import ArchiveError
from barchan.scenario.paths import anchored
from barchan.simulation import State

_DATA = "data"

_DIGEST = hashlib.sha256().digest_size
"""Bytes of the checksum at the end of the file."""


def write_checkpoint(path: Path, state: State) -> None:
    """Write a state; what stood there before stays whole until the new file is complete."""
    partial = path.with_suffix(".partial")
    text = np.frombuffer(json.dumps(state.data).encode(), np.uint8)
    with partial.open("w+b") as file:
        np.savez(file, allow_pickle=False, **{_DATA: text}, **state.arrays)
        file.seek(0)
        file.write(hashlib.file_digest(file, "sha256").digest())
        file.flush()
        os.fsync(file.fileno())
    partial.replace(path)


def read_checkpoint(path: Path) -> State:
    """Read a state; raises ArchiveError where there is none or it is damaged.

    Files that it names start at its folder.
    """
    try:
        whole = path.read_bytes()
    except FileNotFoundError:
        raise ArchiveError(f"{path.parent}: no checkpoint to resume from") from None
    except OSError as error:
        raise ArchiveError(f"{path}: the checkpoint cannot be read ({error.strerror})") from None
    content, digest = whole[:-_DIGEST], whole[-_DIGEST:]
    if hashlib.sha256(content).digest() != digest:
        raise ArchiveError(f"{path}: damaged checkpoint")
    with np.load(BytesIO(content), allow_pickle=False) as file:
        arrays = {name: file[name] for name in file.files}
    data = json.loads(arrays.pop(_DATA).tobytes())
    return State(anchored(data, path.parent.absolute()), arrays)
