"""``python -m tests.bounds [PRESET …]``: run presets with bounds checks in all kernels, print what happened.

Kernels are compiled anew with the checks, into a cache of their own, which takes some minutes the first time.
"""

import os
import sys
import tempfile
from pathlib import Path

os.environ["NUMBA_BOUNDSCHECK"] = "1"
os.environ.setdefault("NUMBA_CACHE_DIR", str(Path(tempfile.gettempdir()) / "barchan-bounds"))

from barchan.errors import BarchanError
from barchan.scenario import load_scenario, preset_names
from barchan.simulation import Simulation

ROWS, COLUMNS, STEPS = 20, 28, 3


def outcome(preset: str) -> str:
    """What becomes of a preset on a small lattice."""
    sizes = [("lattice.rows", str(ROWS)), ("lattice.columns", str(COLUMNS)), ("run.steps", str(STEPS))]
    try:
        Simulation(load_scenario(preset, sizes)).advance(STEPS)
    except IndexError as error:
        return f"out of bounds: {error}"
    except BarchanError as error:
        return f"refused: {error}"
    return "within bounds"


def main() -> int:
    """Run the presets; 1 where any reads or writes beside an array."""
    failed = False
    for preset in sys.argv[1:] or preset_names():
        said = outcome(preset)
        failed |= said.startswith("out of bounds")
        sys.stdout.write(f"{preset}: {said}\n")
        sys.stdout.flush()
    return int(failed)


sys.exit(main())
