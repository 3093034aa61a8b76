"""Fields as sums of waves and back, by threads where a field is large; bits do not depend on their number."""

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

LARGE = 2**18
"""Cells from which on threads share a transform: below, to wake them takes longer."""

MEDIUM = 2**13
"""Cells from which on, up to ``LARGE``, threads share several transforms of a field."""


def waves_of(field: NDArray[np.float64]) -> NDArray[np.complex128]:
    """The amplitudes of a field's waves, as ``numpy.fft.rfft2`` orders them."""
    from scipy.fft import rfft2  # at the first step of a model that needs it, not with the first page

    return np.asarray(rfft2(field, workers=_workers(field.size)))


def sum_of_waves(waves: NDArray[np.complex128], shape: tuple[int, ...]) -> NDArray[np.float64]:
    """The field of a ``shape`` whose waves have these amplitudes."""
    from scipy.fft import irfft2

    return np.asarray(irfft2(waves, s=shape, workers=_workers(shape[0] * shape[1])))


def _workers(cells: int) -> int:
    from barchan.kernels.core.threads import thread_count

    return thread_count() if cells >= LARGE else 1


def several(fields: Sequence[Callable[[], NDArray[np.float64]]], cells: int) -> list[NDArray[np.float64]]:
    """Independent fields of so many cells, each of which takes a transform."""
    from barchan.kernels.core.threads import at_once

    return at_once(fields) if MEDIUM <= cells < LARGE else [field() for field in fields]
