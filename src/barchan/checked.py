"""Arrays that a model or another author's code returns, checked before compiled code reads them."""

import math

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from barchan.errors import FieldError
from barchan.words import counted


def checked(values: ArrayLike, shape: tuple[int, ...], dtype: DTypeLike, name: str) -> NDArray:
    """The values as an array of a type, in rows; raises FieldError where they are no such field.

    They must have the lattice's ``shape`` and be finite numbers; for a type of whole numbers they must be
    whole and within its range.
    """
    array, wanted = np.asarray(values), np.dtype(dtype)
    if array.shape != shape:
        raise FieldError(f"{name} has shape {array.shape}, the lattice {shape}")
    if array.dtype.kind not in "biuf":
        raise FieldError(f"{name} is of type {array.dtype}; allowed: numbers")
    if array.dtype.kind == "f":
        _refuse(~np.isfinite(array), array, name, "finite numbers")
    if wanted.kind in "iu" and array.dtype != wanted:
        limits = np.iinfo(wanted)
        within = (array >= limits.min) & (array <= limits.max)
        whole = array == np.rint(array) if array.dtype.kind == "f" else True
        _refuse(~(within & whole), array, name, f"whole numbers from {limits.min} to {limits.max}")
    return np.array(array, dtype=wanted, order="C")


def finite(value: float, name: str) -> float:
    """A number that is one; raises FieldError for NaN and infinity."""
    if not math.isfinite(value):
        raise FieldError(f"{name} is {value}; allowed: a finite number")
    return value


def _refuse(wrong: NDArray[np.bool_], array: NDArray, name: str, allowed: str) -> None:
    """Raise FieldError with the first cell that is wrong, and how many there are."""
    count = int(np.count_nonzero(wrong))
    if count:
        first = tuple(int(index) for index in np.argwhere(wrong)[0])
        place = ", ".join(f"{word} {index}" for word, index in zip(("row", "column"), first, strict=False))
        more = f" and {counted(count - 1, 'more cell')}" if count > 1 else ""
        raise FieldError(f"{name} is {array[first]} at {place}{more}; allowed: {allowed}")
