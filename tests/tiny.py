"""A small scenario that runs in milliseconds, on a lattice that is not square on purpose."""

import copy
from typing import Any

import barchan
from barchan.scenario import Scenario

ROWS, COLUMNS = 16, 24

DATA: dict[str, Any] = {
    "barchan": 5,
    "title": "Tiny",
    "lattice": {"rows": ROWS, "columns": COLUMNS},
    "ground": {"kind": "flat"},
    "sand": {"kind": "random", "mean": 3},
    "wind": {"kind": "steady", "direction": 270.0},
    "model": {"name": "werner"},
    "run": {"steps": 20, "save_every": 5, "seed": 7},
}

VARIANTS: dict[str, dict[str, Any]] = {
    "plain": {},
    "each once": {"model__polling": "non_repeated"},
    "forced": {"model__polling": "non_repeated", "model__forced_erosion": True},
    "moore, random order": {"model__neighbourhood": "moore", "model__neighbour_order": "random"},
    "bands": {"model__band_rows": 5},
    "oblique, open": {
        "wind__direction": 205.0,
        "lattice__boundary_x": "open",
        "lattice__boundary_y": "open",
    },
    "over a hill": {"ground": {"kind": "bump", "height": 3.0, "radius": 6.0}},
}
"""Changes to the tiny scenario that take different ways through the program."""


RIDGES: dict[str, Any] = {
    "lattice__columns": 96,
    "sand": {
        "kind": "flat",
        "mean": 4,
        "parts": [{"mean": 12, "west": k / 4, "east": (k + 0.5) / 4} for k in range(4)],
    },
    "model__hop_length": 3,
}
"""Changes to the tiny scenario that lay four ridges across the wind, which stay ridges."""


def data() -> dict[str, Any]:
    """The tiny scenario as plain data, to be changed."""
    return copy.deepcopy(DATA)


def tiny(**changes: Any) -> Scenario:
    """The tiny scenario with single values changed, ``__`` standing for the dot."""
    return barchan.load(DATA, **changes)
