"""Impacts of drift that break the young bonds of the loose snow at the surface."""

import numpy as np
from numba import njit

from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.random import derive, draw
from barchan.kernels.snow.layers import pop, push, state_class


@njit(cache=True)
def break_bonds(pack, tables, struck, mean, epoch, key):
    """Give the topmost ``mean`` quanta of every ``struck`` cell (bool, flat) the bonds of an ``epoch``.

    Only loose snow is broken, from the top down to the first bonded quantum. Of a ``mean`` that is not whole
    the rest is a chance, drawn for each cell. Densities and masses stay, so heights do too, but for those of
    buried layers that have to be merged.
    """
    pack, tables = borrowed((pack, tables))
    densities = np.empty(np.int64(np.ceil(mean)) + 1, np.int64)
    for cell in range(struck.size):
        if not struck[cell]:
            continue
        at = np.uint64(cell)
        most = min(np.int64(mean + draw(derive(key, cell), 1)), np.int64(pack.quanta[at]))
        taken = np.int64(0)
        while taken < most and not tables.bonded[state_class(pack.top[at], epoch, tables.age_class)]:
            densities[taken] = pop(pack, tables.thickness, at)
            taken += 1
        for k in range(taken - 1, -1, -1):
            push(pack, tables.thickness, at, epoch, densities[k])
