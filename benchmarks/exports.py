"""One frame of 1024² cells into every format."""

import shutil
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from barchan.archive import open_run
from barchan.archive import run as run_into
from barchan.entry import load
from barchan.export import FORMATS, export
from barchan.simulation import Simulation

SIDE = 1024


def report() -> Iterator[str]:
    """The table, line by line."""
    yield ""
    yield f"| export of a frame of {SIDE}² cells | seconds of a processor | MB |"
    yield "|---|---|---|"
    for name, seconds, megabytes in measure():
        yield f"| {name} | {seconds:.2f} | {megabytes:.1f} |"


def measure() -> list[tuple[str, float, float]]:
    """Name of the format, seconds of a processor for its second export, megabytes of its file."""
    folder = Path(tempfile.mkdtemp())
    try:
        scenario = load("barchans", rows=SIDE, columns=SIDE, steps=40, save_every=40, seed=1)
        run_into(Simulation(scenario), folder / "run")
        frame = open_run(folder / "run").isel(step=[-1]).load()
        return [(f"{one.name} ({one.suffixes[0]})", *_export(frame, folder, one)) for one in FORMATS]
    finally:
        shutil.rmtree(folder)


def _export(frame, folder: Path, one) -> tuple[float, float]:
    export(frame, folder / f"warm{one.suffixes[0]}", format=one.name)
    began = time.process_time()
    files = export(frame, folder / f"frame{one.suffixes[0]}", format=one.name)
    took = time.process_time() - began
    if one.name == "pvd":
        files += folder.glob("frame_frames/*")
    return took, float(np.sum([file.stat().st_size for file in files])) / 1e6
