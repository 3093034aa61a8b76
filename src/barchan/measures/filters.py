"""Filters that several measures apply to a field first.

A cell that is NaN is a void: it counts for nothing, and what is computed from it is a void too.
"""

from collections.abc import Sequence
from typing import Literal

import numpy as np
import scipy
from numpy.typing import NDArray

Field = NDArray[np.float64]
Periodic = tuple[bool, bool]
"""Whether a field is periodic along its rows' axis (south to north) and along its columns'."""


def smoothed(field: NDArray, width: float, periodic: Periodic) -> Field:
    """A field smoothed with a Gaussian of standard deviation ``width`` (cells); voids stay as they are."""
    modes: list[Literal["wrap", "nearest"]] = ["wrap" if p else "nearest" for p in periodic]
    values = np.asarray(field, float)
    known = np.isfinite(values)
    if known.all():
        return scipy.ndimage.gaussian_filter(values, width, mode=modes)
    total = scipy.ndimage.gaussian_filter(np.where(known, values, 0.0), width, mode=modes)
    weight = scipy.ndimage.gaussian_filter(known.astype(float), width, mode=modes)
    return np.where(known, total / np.where(known, weight, 1.0), np.nan)


def without_trend(field: NDArray, periodic: Periodic) -> Field:
    """A field less its ``trend``."""
    values = np.asarray(field, float)
    return values - trend(values, periodic)


def trend(field: Field, periodic: Periodic) -> Field:
    """The plane through a field, about its middle, that slopes only towards edges that are not joined.

    Cells are weighted by Hann windows towards those edges: waves that the edges cut tilt the plane little.
    """
    sloping = [axis for axis in (0, 1) if not periodic[axis] and field.shape[axis] > 2]
    known = np.isfinite(field)
    if not sloping or not known.any():
        return np.zeros_like(field)
    places = np.indices(field.shape)
    sides = [places[axis] - (field.shape[axis] - 1) / 2 for axis in sloping]
    weight = np.sqrt(windows(field.shape, periodic))[known]
    columns = np.stack([np.ones(int(known.sum())), *(side[known] for side in sides)], axis=1)
    plane = np.linalg.lstsq(columns * weight[:, None], field[known] * weight, rcond=None)[0]
    return np.asarray(sum(slope * side for slope, side in zip(plane[1:], sides, strict=True)))


def windows(shape: tuple[int, ...], periodic: Periodic, shift: Sequence[float] | Field = (0.0, 0.0)) -> Field:
    """Weights that fade out towards edges that are not joined (Hann), 1 along the other axes.

    Their middle lies ``shift`` (rows, columns) from that of the field.
    """
    weights = np.ones(shape)
    for axis in (0, 1):
        size = shape[axis]
        if not periodic[axis] and size > 2:
            place = np.clip(np.arange(1, size + 1) - shift[axis], 0, size + 1)
            window = np.sin(np.pi * place / (size + 1)) ** 2
            weights = weights * (window[:, None] if axis == 0 else window[None, :])
    return weights


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


def sixfold_gradient(field: Field, cell_size: float, periodic: Periodic) -> tuple[Field, Field]:
    """Slopes towards east and north of a field on hexagons, of which every second row is shifted half a cell.

    The plane that fits a cell's six neighbours best; beyond an open edge the slope goes on as it comes.
    """
    height, width = field.shape
    rows, columns = np.indices(field.shape)
    odd = rows % 2
    joined_y, joined_x = periodic
    east, north = np.zeros_like(field), np.zeros_like(field)
    # three pairs of opposite neighbours, at 0, 60 and 120 degrees
    for angle, up, ahead, back in ((0, 0, 1, -1), (60, 1, odd, odd - 1), (120, 1, odd - 1, odd)):
        found = []
        for r, c in ((rows + up, columns + ahead), (rows - up, columns + back)):
            inside = (joined_y | ((r >= 0) & (r < height))) & (joined_x | ((c >= 0) & (c < width)))
            step = field[r % height, c % width] - field
            found.append(np.where(inside, step, np.nan))
        ahead_of, behind = found
        rise = np.where(
            np.isnan(ahead_of), -behind, np.where(np.isnan(behind), ahead_of, (ahead_of - behind) / 2)
        )
        rise = np.nan_to_num(rise) * 2.0 / (3.0 * cell_size)
        east += rise * np.cos(np.radians(angle))
        north += rise * np.sin(np.radians(angle))
    return east, north


def tapered(field: Field, periodic: Periodic, shift: Sequence[float] | Field = (0.0, 0.0)) -> Field:
    """The field about its mean, faded out towards edges that are not joined; voids are at the mean.

    The window's middle lies ``shift`` (rows, columns) from that of the field.
    """
    known = np.isfinite(field)
    if not known.any():
        return np.zeros_like(field)
    about = field - field.mean(where=known)
    return np.where(known, about, 0.0) * windows(field.shape, periodic, shift)
