"""Surfaces continued beyond open edges, so that their waves can be found as if they were periodic."""

import numpy as np
from numpy.typing import NDArray

from barchan.lattice import Lattice


def mirrored(surface: NDArray[np.float64], lattice: Lattice) -> NDArray[np.float64]:
    """A surface followed by its mirror image along axes with open edges; the surface itself along others."""
    if all(lattice.periodic):
        return surface
    widths = [(0, 0 if wraps else size) for wraps, size in zip(lattice.periodic, lattice.shape, strict=True)]
    return np.pad(surface, widths, mode="symmetric")


def ramped_to_mean(
    surface: NDArray[np.float64], lattice: Lattice
) -> tuple[NDArray[np.float64], tuple[slice, slice]]:
    """A surface led on to its mean level and back beyond open edges, and the place of the field in it."""
    widths = [0 if wraps else size // 2 for wraps, size in zip(lattice.periodic, lattice.shape, strict=True)]
    inside = slice(widths[0], widths[0] + lattice.rows), slice(widths[1], widths[1] + lattice.columns)
    if not any(widths):
        return surface, inside
    mean = float(surface.mean())
    return np.pad(surface, [(w, w) for w in widths], mode="linear_ramp", end_values=mean), inside
