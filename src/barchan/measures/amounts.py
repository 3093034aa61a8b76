"""How much sand there is, how high it stands, and how much the wind carries."""

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


def flux(travel: float, cells: int, steps: int, slab_height: float, cell_size: float) -> float:
    """Sand flux (m³ per metre of width and step, that is m² per step), pores included.

    ``travel`` is the distance (cells) that slabs travelled on the wind in ``steps`` steps, summed over
    all slabs, on a field of ``cells`` cells.
    """
    return travel / cells * slab_height * cell_size / steps if steps else float("nan")
