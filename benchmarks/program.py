"""The program as a user meets it: start-up, a first run that compiles, a second run, a long wind record."""

import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np


def seconds(arguments: list[str], folder: Path, cache: Path) -> float:
    """Wall time of one call of the command line."""
    began = time.perf_counter()
    subprocess.run(
        [str(Path(sys.executable).parent / "barchan"), *arguments],
        cwd=folder,
        env={**os.environ, "NUMBA_CACHE_DIR": str(cache)},
        check=True,
        capture_output=True,
    )
    return time.perf_counter() - began


def write_record(path: Path, hours: int = 350_000) -> None:
    """Forty years of made-up hours, one row each."""
    random = np.random.default_rng(1)
    times = (np.datetime64("1980-01-01T00:00") + np.arange(hours) * np.timedelta64(1, "h")).astype(str)
    winds = zip(times, 6.0 * random.weibull(2.0, hours), random.integers(0, 360, hours), strict=True)
    rows = "\n".join(f"{time},{speed:.1f},{direction}" for time, speed, direction in winds)
    path.write_text(f"time,speed (m/s),direction (deg)\n{rows}\n")


def measure() -> dict[str, float]:
    """Wall times (s) of help, of two runs of the barchans preset with picture, and of a wind analysis."""
    folder = Path(tempfile.mkdtemp())
    cache = folder / "cache"
    write_record(folder / "forty-years.csv")
    try:
        seconds(["--help"], folder, cache)
        return {
            "`barchan --help`": min(seconds(["--help"], folder, cache) for _ in range(5)),
            "`barchan run barchans`, first run, kernels compiled": seconds(
                ["run", "barchans"], folder, cache
            ),
            "`barchan run barchans`, second run": seconds(["run", "barchans"], folder, cache),
            "`barchan wind`, 350 000 rows read, analysed and drawn": min(
                seconds(["wind", "forty-years.csv"], folder, cache) for _ in range(3)
            ),
        }
    finally:
        shutil.rmtree(folder)
