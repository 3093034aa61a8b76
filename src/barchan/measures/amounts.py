"""Amounts: units of a bed's layers on each cell, their volume, and the flux that the wind carries."""

import numpy as np
from numpy.typing import NDArray


def highest_stack(stack: NDArray[np.integer]) -> int:
    """Units (slabs of sand) in the highest stack."""
    return int(stack.max())


def bare_fraction(stack: NDArray[np.integer]) -> float:
    """Share of the cells on which nothing lies that the wind could move."""
    return float(np.mean(stack == 0))


def stack_volume(stack: NDArray[np.integer], slab_height: float, cell_size: float) -> float:
    """Volume (m³), pores included, of units ``slab_height`` (m) high on cells of ``cell_size`` (m)."""
    return int(stack.sum(dtype=np.int64)) * slab_height * cell_size**2


def flux(travel: float, cells: int, steps: int, slab_height: float, cell_size: float) -> float:
    """Flux (m³ per metre of width and step, that is m² per step), pores included.

    ``travel`` is the distance (cells) that slabs travelled on the wind in ``steps`` steps, summed over
    all slabs, on a field of ``cells`` cells.
    """
    return travel / cells * slab_height * cell_size / steps if steps else float("nan")
