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
    """Name of the format, seconds of a processor for its second export of a frame, megabytes of a frame.

    An animation has two frames, and its numbers are halved. Layers of snow are a table of one cell: left out.
    """
    folder = Path(tempfile.mkdtemp())
    try:
        scenario = load("barchans", rows=SIDE, columns=SIDE, steps=40, save_every=40, seed=1)
        run_into(Simulation(scenario), folder / "run")
        frames = open_run(folder / "run").load()
        return [(_title(one), *_export(frames, folder, one)) for one in FORMATS if one.name != "layers"]
    finally:
        shutil.rmtree(folder)


def _title(one) -> str:
    return f"{one.name} ({one.suffixes[0]})" + (", one of two frames" if one.name == "animation" else "")


def _export(frames, folder: Path, one) -> tuple[float, float]:
    count = 2 if one.name == "animation" else 1
    chosen = frames.isel(step=slice(-count, None))
    suffix = one.suffixes[0]
    export(chosen, folder / f"warm-{one.name}{suffix}", format=one.name)
    began = time.process_time()
    files = export(chosen, folder / f"{one.name}{suffix}", format=one.name)
    took = time.process_time() - began
    if one.name == "pvd":
        files += folder.glob("pvd_frames/*")
    return took / count, float(np.sum([file.stat().st_size for file in files])) / 1e6 / count
