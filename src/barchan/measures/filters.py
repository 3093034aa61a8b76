"""Filters that several measures apply to a field first."""

from collections.abc import Sequence
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

Field = NDArray[np.float64]
Periodic = tuple[bool, bool]
"""Whether a field is periodic along its rows' axis (south to north) and along its columns'."""


def smoothed(field: NDArray, width: float, periodic: Periodic) -> Field:
    """A field smoothed with a Gaussian of standard deviation ``width`` (cells)."""
    modes: list[Literal["wrap", "nearest"]] = ["wrap" if p else "nearest" for p in periodic]
    return ndimage.gaussian_filter(np.asarray(field, float), width, mode=modes)


def gradient(field: Field, cell_size: float, periodic: Periodic) -> tuple[Field, Field]:
    """Slopes of a field towards east and towards north, by central differences."""
    slopes = []
    for axis in (1, 0):
        if field.shape[axis] < 2:
            slopes.append(np.zeros_like(field))
        elif periodic[axis]:
            slopes.append((np.roll(field, -1, axis) - np.roll(field, 1, axis)) / (2 * cell_size))
        else:
            slopes.append(np.gradient(field, cell_size, axis=axis))
    return slopes[0], slopes[1]


def tapered(field: Field, periodic: Periodic, shift: Sequence[float] | Field = (0.0, 0.0)) -> Field:
    """The field about its mean, faded out towards edges that are not joined (Hann).

    The window's middle lies ``shift`` (rows, columns) from that of the field.
    """
    result = field - field.mean()
    for axis in (0, 1):
        size = field.shape[axis]
        if not periodic[axis] and size > 2:
            place = np.clip(np.arange(1, size + 1) - shift[axis], 0, size + 1)
            window = np.sin(np.pi * place / (size + 1)) ** 2
            result = result * (window[:, None] if axis == 0 else window[None, :])
    return result
