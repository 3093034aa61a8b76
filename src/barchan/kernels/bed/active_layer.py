"""Sand of several sizes: how many parcels of each lie in the active layer of a cell, and below it.

The layer is what wind and impacts reach (Hirano 1971). It holds as many parcels as it can, fewer only where
the stack is lower. What is laid down comes into it, and what then is too much goes below; what is taken is
replaced from below. Which size a parcel has that changes its place is drawn from the mixture that it comes
from, parcel by parcel. Without a mixture (None) all sand is alike, and nothing is kept.
"""

import numpy as np
from numba import njit

from barchan.kernels.core.random import GOLDEN, below, derive, high, mix

_OWN = 4
"""What draws of sizes have as their number under a key."""


@njit(cache=True, nogil=True, error_model="numpy")
def kind_of(kinds, at):
    """The size at a place of ``kinds``, or the only one."""
    if kinds is not None:
        return np.int64(kinds[at])
    return 0


@njit(cache=True, nogil=True, error_model="numpy")
def set_kind(kinds, at, kind):
    """Put a size there, where there are several."""
    if kinds is not None:
        kinds[at] = kind


@njit(cache=True, nogil=True, error_model="numpy")
def available(mixture, sand, kind, cell):
    """Parcels of a size that a cell can give."""
    if mixture is not None:
        return np.int64(mixture.layer[kind, cell])
    return np.int64(sand[cell])


@njit(cache=True, nogil=True, error_model="numpy")
def amount(counts, cell):
    """Parcels of all sizes."""
    total = np.int64(0)
    for kind in range(counts.shape[0]):
        total += counts[kind, cell]
    return total


@njit(cache=True, nogil=True, error_model="numpy")
def nth(counts, cell, at):
    """The size of the parcel that comes ``at`` many others, sorted by size."""
    for kind in range(counts.shape[0] - 1):
        at -= counts[kind, cell]
        if at < 0:
            return kind
    return counts.shape[0] - 1


@njit(cache=True, nogil=True, error_model="numpy")
def shuffle_anew(mixture, key):
    """Start the draws of sizes anew under a key."""
    if mixture is not None:
        mixture.turn[0] = derive(key, _OWN)


@njit(cache=True, nogil=True, error_model="numpy")
def _next(mixture):
    mixture.turn[0] += GOLDEN
    return mix(mixture.turn[0])


@njit(cache=True, nogil=True, error_model="numpy")
def _drawn(counts, cell, total, mixture):
    return nth(counts, cell, below(high(_next(mixture)), total))


@njit(cache=True, nogil=True, error_model="numpy")
def put(mixture, cell, kind, parcels):
    """Lay parcels of a size on a cell."""
    if mixture is not None:
        mixture.layer[kind, cell] += parcels
        held = amount(mixture.layer, cell)
        while held > mixture.full:
            lowered = _drawn(mixture.layer, cell, held, mixture)
            mixture.layer[lowered, cell] -= 1
            mixture.deep[lowered, cell] += 1
            held -= 1


@njit(cache=True, nogil=True, error_model="numpy")
def take(mixture, cell, kind, parcels):
    """Take parcels of a size, which lie there, from a cell's active layer."""
    if mixture is not None:
        mixture.layer[kind, cell] -= parcels
        held, rest = amount(mixture.layer, cell), amount(mixture.deep, cell)
        while held < mixture.full and rest > 0:
            raised = _drawn(mixture.deep, cell, rest, mixture)
            mixture.deep[raised, cell] -= 1
            mixture.layer[raised, cell] += 1
            held += 1
            rest -= 1


@njit(cache=True, nogil=True, error_model="numpy")
def _take_any(mixture, cell):
    kind = _drawn(mixture.layer, cell, amount(mixture.layer, cell), mixture)
    take(mixture, cell, kind, 1)
    return kind


@njit(cache=True, nogil=True, error_model="numpy")
def slide(mixture, cell, other, parcels):
    """Let parcels of any size slide from one cell to another."""
    if mixture is not None:
        for _ in range(parcels):
            put(mixture, other, _take_any(mixture, cell), 1)


@njit(cache=True, nogil=True, error_model="numpy")
def follow(mixture, sand, shares, entered):
    """Let the sizes follow a bed that was painted; adds to ``entered`` what came (or went) of each.

    Sand that came has the ``shares`` (running sums up to 1), sand that went was in the active layer.
    """
    for cell in range(sand.size):
        change = sand[cell] - amount(mixture.layer, cell) - amount(mixture.deep, cell)
        for _ in range(-change):
            entered[_take_any(mixture, cell)] -= 1
        for _ in range(change):
            part = np.float64(_next(mixture) >> np.uint64(11)) * 2.0**-53
            kind = 0
            while kind < shares.size - 1 and part >= shares[kind]:
                kind += 1
            put(mixture, cell, kind, 1)
            entered[kind] += 1
