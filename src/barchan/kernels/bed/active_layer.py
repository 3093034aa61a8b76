"""Sand of several sizes: parcels of each size class in the active layer of a cell, and in the substrate.

The active layer is the part of the bed that wind and impacts reach (Hirano 1971). It holds a fixed number of
parcels, fewer only where the stack is lower. Deposited parcels enter the layer, and the surplus is buried in
the substrate; eroded parcels are replaced from the substrate. The size of a parcel that changes its place is
drawn at random from the mixture that it leaves, parcel by parcel. None in place of a layer is sand of one
size, and nothing is kept.
"""

import numpy as np
from numba import njit

from barchan.kernels.core.internal import internal
from barchan.kernels.core.random import GOLDEN, below, derive, high, mix

_OWN_STREAM = 4
"""Number under a key from which the random sequence of sizes derives."""


@internal(error_model="numpy")
def class_at(classes, at):
    """The size class at a place of ``classes``; 0 for sand of one size."""
    if classes is not None:
        return np.int64(classes[at])
    return np.int64(0)


@internal(error_model="numpy")
def set_class(classes, at, size_class):
    """Set the size class at a place of ``classes``; nothing for sand of one size."""
    if classes is not None:
        classes[at] = size_class


@internal(error_model="numpy")
def available(layer, sand, size_class, cell):
    """Parcels of a size class that a cell can give."""
    if layer is not None:
        return np.int64(layer.surface[size_class, cell])
    return np.int64(sand[cell])


@internal(error_model="numpy")
def parcels_of(counts, cell):
    """Parcels of all size classes in a cell."""
    total = np.int64(0)
    for size_class in range(counts.shape[0]):
        total += counts[size_class, cell]
    return total


@internal(error_model="numpy")
def class_of_parcel(counts, cell, number):
    """Size class of parcel ``number`` of a cell when its parcels are sorted by size."""
    for size_class in range(counts.shape[0] - 1):
        number -= counts[size_class, cell]
        if number < 0:
            return size_class
    return counts.shape[0] - 1


@njit(cache=True, nogil=True, error_model="numpy")
def reseed(layer, key):
    """Restart the random sequence of sizes under a key."""
    if layer is not None:
        layer.rng_state[0] = derive(key, _OWN_STREAM)


@internal(error_model="numpy")
def _next(layer):
    layer.rng_state[0] += GOLDEN
    return mix(layer.rng_state[0])


@internal(error_model="numpy")
def _random_class(counts, cell, total, layer):
    return class_of_parcel(counts, cell, below(high(_next(layer)), total))


@njit(cache=True, nogil=True, error_model="numpy")
def put(layer, cell, size_class, parcels):
    """Deposit parcels of a size class on a cell."""
    if layer is not None:
        layer.surface[size_class, cell] += parcels
        held = parcels_of(layer.surface, cell)
        while held > layer.capacity:
            buried = _random_class(layer.surface, cell, held, layer)
            layer.surface[buried, cell] -= 1
            layer.substrate[buried, cell] += 1
            held -= 1


@njit(cache=True, nogil=True, error_model="numpy")
def take(layer, cell, size_class, parcels):
    """Erode parcels of a size class, which must be there, from a cell's active layer."""
    if layer is not None:
        layer.surface[size_class, cell] -= parcels
        held, rest = parcels_of(layer.surface, cell), parcels_of(layer.substrate, cell)
        while held < layer.capacity and rest > 0:
            raised = _random_class(layer.substrate, cell, rest, layer)
            layer.substrate[raised, cell] -= 1
            layer.surface[raised, cell] += 1
            held += 1
            rest -= 1


@internal(error_model="numpy")
def _take_any(layer, cell):
    size_class = _random_class(layer.surface, cell, parcels_of(layer.surface, cell), layer)
    take(layer, cell, size_class, 1)
    return size_class


@njit(cache=True, nogil=True, error_model="numpy")
def slide(layer, cell, other, parcels):
    """Move parcels of random size from one cell to another."""
    if layer is not None:
        for _ in range(parcels):
            put(layer, other, _take_any(layer, cell), 1)


@njit(cache=True, nogil=True, error_model="numpy")
def follow(layer, sand, shares, entered):
    """Bring the size classes up to date with a painted bed; adds the change of each class to ``entered``.

    Added sand has the ``shares`` of the classes (running sums up to 1); removed sand was in the active layer.
    """
    for cell in range(sand.size):
        change = sand[cell] - parcels_of(layer.surface, cell) - parcels_of(layer.substrate, cell)
        for _ in range(-change):
            entered[_take_any(layer, cell)] -= 1
        for _ in range(change):
            part = np.float64(_next(layer) >> np.uint64(11)) * 2.0**-53
            size_class = 0
            while size_class < shares.size - 1 and part >= shares[size_class]:
                size_class += 1
            put(layer, cell, size_class, 1)
            entered[size_class] += 1
