"""Snow that packs under its own weight."""

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.snow.density import PACKING
from barchan.kernels.snow.state import Pack
from barchan.snow.conditions import Conditions, quantum_heights

INTERVAL = 3_600_000_000
"""Time (µs) after which snow packs; shorter changes would be lost in rounding."""


def let_pack(pack: Pack, ground: NDArray[np.int32], now: Conditions, microseconds: int, key: int) -> None:
    """Let all layers pack for some time at the present temperature; masses do not change."""
    from barchan.kernels.snow.layers import densify, measure_surface

    viscosity, settling = PACKING[now.parameters.packing.law]
    density = np.maximum(np.arange(1024.0), 1.0)
    quantum = now.parameters.quantum
    tables = viscosity(density, now.temperature), settling(density, now.temperature)
    densify(pack, quantum, *tables, microseconds / 1e6, np.uint64(key))
    measure_surface(pack, quantum_heights(quantum), ground)
