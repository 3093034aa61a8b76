"""The newest complete state of a run, in one file that is replaced as a whole."""

import json
import os
import zipfile
from pathlib import Path

import numpy as np

from barchan.errors import ArchiveError
from barchan.simulation import State

_DATA = "data"


def write_checkpoint(path: Path, state: State) -> None:
    """Write a state; what stood there before stays whole until the new file is complete."""
    partial = path.with_suffix(".partial")
    text = np.frombuffer(json.dumps(state.data).encode(), np.uint8)
    with partial.open("wb") as file:
        np.savez(file, allow_pickle=False, **{_DATA: text}, **state.arrays)
        file.flush()
        os.fsync(file.fileno())
    partial.replace(path)


def read_checkpoint(path: Path) -> State:
    """Read a state; raises ArchiveError where there is none or it is damaged."""
    try:
        with np.load(path, allow_pickle=False) as file:
            arrays = {name: file[name] for name in file.files}
    except FileNotFoundError:
        raise ArchiveError(f"{path.parent}: no checkpoint to resume from") from None
    except (OSError, ValueError, zipfile.BadZipFile) as error:
        raise ArchiveError(f"{path}: damaged checkpoint ({error})") from None
    data = json.loads(arrays.pop(_DATA).tobytes())
    return State(data, arrays)
