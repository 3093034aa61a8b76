"""Small scenes of snow."""

from typing import Any

import barchan
from barchan.simulation import Simulation

WIND = {"kind": "steady", "speed": 10.0, "unit": "m/s"}

SWITCHED_OFF: dict[str, Any] = {
    "bonding": {"grows": False},
    "relief": {"acts": False},
    "creep": {"gain": 0.0},
    "abrasion": {"rate": 0.0},
    "packing": {"law": "none"},
}


def snow(mean: int = 10, wind: dict[str, Any] | None = None, seed: int = 3, **model: Any) -> Simulation:
    """A field of 32 × 48 cells of 10 cm with ``mean`` quanta on each."""
    lattice, influx = model.pop("lattice", {}), model.pop("influx", None)
    blowing = {**WIND, **(wind or {})}
    return Simulation(
        barchan.load(
            {
                "barchan": 5,
                "lattice": {"rows": 32, "columns": 48, "cell_size": 0.1, **lattice},
                "sand": {"kind": "flat", "mean": mean},
                "wind": {key: value for key, value in blowing.items() if value is not None},
                "influx": influx,
                "model": {"name": "snow", **model},
                "run": {"steps": 10_000, "seed": seed},
            }
        )
    )
