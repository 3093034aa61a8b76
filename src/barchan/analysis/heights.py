"""How much sand there is and how high it stands."""

import numpy as np
from numpy.typing import NDArray


def highest_stack(sand: NDArray[np.integer]) -> int:
    """Slabs in the highest stack."""
    return int(sand.max())


def bare_fraction(sand: NDArray[np.integer]) -> float:
    """Share of the cells that hold no sand."""
    return float(np.mean(sand == 0))


def sand_volume(sand: NDArray[np.integer], slab_height: float, cell_size: float) -> float:
    """Volume of the sand (m³), pores included."""
    return int(sand.sum(dtype=np.int64)) * slab_height * cell_size**2
