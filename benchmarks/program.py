"""The program as a user meets it: start-up, a first run that compiles, a second run."""

import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path


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


def measure() -> dict[str, float]:
    """Wall times (s) of help and of the first and second run of the barchans preset, picture included."""
    folder = Path(tempfile.mkdtemp())
    cache = folder / "cache"
    try:
        seconds(["--help"], folder, cache)
        return {
            "`barchan --help`": min(seconds(["--help"], folder, cache) for _ in range(5)),
            "`barchan run barchans`, first run, kernels compiled": seconds(
                ["run", "barchans"], folder, cache
            ),
            "`barchan run barchans`, second run": seconds(["run", "barchans"], folder, cache),
        }
    finally:
        shutil.rmtree(folder)
