"""The same rules as a plain loop in C (``plain.c``), compiled where there is a compiler: how fast is fast?

The loop knows one model on flat ground under a wind along the rows. It makes the same bed, to the bit.
"""

import ctypes
import math
import shutil
import statistics
import subprocess
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from barchan.bed import Bed
from barchan.kernels.core import threads
from barchan.lattice import Lattice
from barchan.models.werner import Werner
from barchan.streams import Stream
from barchan.wind.segment import Segment

SOURCE = Path(__file__).with_name("plain.c")
FLAGS = ("-O3", "-march=native", "-shared", "-fPIC")


@dataclass(frozen=True)
class Case:
    """A field of Werner's model, three slabs a cell, from flat."""

    size: int
    steps: int
    lee_erosion: bool
    repetitions: int = 5

    @property
    def name(self) -> str:
        return f"{self.size}², erosion in shadow {'allowed' if self.lee_erosion else 'forbidden'}"


CASES = (
    Case(256, 100, True),
    Case(256, 100, False),
    Case(1024, 10, True),
    Case(1024, 10, False),
    Case(4096, 2, True, 2),
    Case(4096, 2, False, 2),
)


def compiled(folder: str, source: Path = SOURCE) -> ctypes.CDLL | None:
    """The loop, compiled into a folder; None without a compiler."""
    compiler = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
    if compiler is None:
        return None
    library = Path(folder) / "plain.so"
    subprocess.run([compiler, *FLAGS, "-o", library, source], check=True)
    return ctypes.CDLL(str(library))


def measure(case: Case, library: ctypes.CDLL) -> tuple[float, float, bool]:
    """Nanoseconds a poll of the kernel and of the loop, in turns, and whether both made the same bed."""
    lattice = Lattice(rows=case.size, columns=case.size)
    model = Werner(
        Werner.Parameters(lee_erosion=case.lee_erosion, repose_angle=33.7, repose_test="after"), lattice
    )
    flat = np.full(lattice.shape, 3, np.int32)
    kernel, loop = [], []
    same = True
    for repetition in range(case.repetitions + 1):
        mine, seconds = by_kernel(model, flat, case.steps)
        kernel.append(seconds)
        plain, seconds = by_loop(library, model, flat, case.steps)
        loop.append(seconds)
        same &= np.array_equal(mine, plain)
        if not repetition:
            kernel.clear()
            loop.clear()
    polls = case.steps * lattice.cells / 1e9
    return statistics.median(kernel) / polls, statistics.median(loop) / polls, bool(same)


def by_kernel(model, sand, steps):
    """The bed that the kernel makes of flat ``sand`` on one thread, and the seconds it takes."""
    bed = Bed(model.lattice, np.zeros(model.lattice.shape), sand)
    whole = threads.thread_count
    threads.thread_count = lambda: 1
    try:
        began = time.process_time()
        model.advance(bed, Segment(0, steps, 0, model.lattice.cells, 270.0), Stream(1, "transport"))
        return bed.sand, time.process_time() - began
    finally:
        threads.thread_count = whole


def shadow_line(model: Werner) -> tuple[float, float]:
    """How far the shadow line falls in a cell (slabs), and where in its cell it starts (cells)."""
    fall = math.tan(math.radians(model.parameters.shadow_angle)) / model.lattice.aspect
    return fall, 0.5 if model.parameters.shadow_from == "edge" else 0.0


def by_loop(library, model, sand, steps):
    """The bed that the loop makes of flat ``sand``, and the seconds it takes."""
    rules, lattice = model.parameters, model.lattice
    bed = sand.copy()
    fall, start = shadow_line(model)
    falls = np.floor((np.arange(1, lattice.columns + 1) - start) * fall).astype(np.int32)
    chances = [ctypes.c_uint64(round(chance * 2**32)) for chance in (rules.p_s, rules.p_ns)]
    numbers = (
        lattice.rows,
        lattice.columns,
        rules.band_rows,
        int(rules.hop_length),
        rules.face_limit(lattice),
    )
    key = ctypes.c_uint64(Stream(1, "transport").key)
    began = time.process_time()
    library.run_steps(
        bed.ctypes.data_as(ctypes.c_void_p),
        falls.ctypes.data_as(ctypes.c_void_p),
        *map(ctypes.c_int64, numbers),
        *chances,
        ctypes.c_int(rules.lee_erosion),
        key,
        ctypes.c_int64(0),
        ctypes.c_int64(steps),
    )
    return bed, time.process_time() - began


def report():
    """The table, line by line."""
    with tempfile.TemporaryDirectory() as folder:
        library = compiled(folder)
        if library is None:
            yield "No C compiler here: the plain loop was not measured."
            return
        yield "| Werner's model, one thread | ns a poll | plain loop in C | ratio | same bits |"
        yield "|---|---|---|---|---|"
        for case in CASES:
            kernel, loop, same = measure(case, library)
            ratio = f"{kernel / loop:.2f}"
            yield f"| {case.name} | {kernel:.1f} | {loop:.1f} | {ratio} | {'yes' if same else 'no'} |"
