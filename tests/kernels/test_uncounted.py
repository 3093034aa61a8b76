"""Kernels that do not count references to arrays, and leave them alone."""

import gc
import sys
import weakref
from typing import NamedTuple

import numpy as np
import pytest

from barchan.kernels import grain_bed, grain_filter, grain_flight, grain_landing, grain_splash
from barchan.kernels.uncounted import uncounted, uncounted_inline


class Pair(NamedTuple):
    """Two arrays."""

    left: np.ndarray
    right: np.ndarray


@uncounted_inline
def turn(pair, at):
    """Change one or the other, on ways that leave in several places."""
    if pair.left[at] > 0.0:
        pair.left[at] = -pair.left[at]
        if pair.right[at] > 0.0:
            return
    pair.right[at] += 1.0


@uncounted
def turn_all(pair):
    """Change all."""
    for at in range(pair.left.size):
        turn(pair, at)


def test_arrays_live_as_long_as_python_holds_them():
    left, right = np.array([1.0, -1.0]), np.array([1.0, 1.0])
    held = sys.getrefcount(left)
    for _ in range(3):
        turn_all(Pair(left, right))
    assert sys.getrefcount(left) == held
    assert (left.tolist(), right.tolist()) == ([-1.0, -1.0], [3.0, 4.0])
    watched = weakref.ref(left)
    del left
    gc.collect()
    assert watched() is None


@pytest.mark.parametrize(
    "kernel",
    [
        *(grain_landing.land, grain_bed.exchange, grain_bed.settle_steep, grain_splash.eject),
        *(grain_flight._move_blocks, grain_filter._find_sharp),
    ],
)
def test_kernels_of_grains_count_no_references(kernel):
    assert kernel.targetoptions["_nrt"] is False
