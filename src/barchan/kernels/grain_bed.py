"""What grains in flight do to the bed: parcels lifted and laid down, and slopes that slide.

A parcel is the sand of one cell, as high as one unit of the bed. Exchange happens one grain after the
other in the order of slots, so it is the same however the flight was shared among threads.
"""

import numpy as np
from numba import njit

from barchan.kernels.avalanche import neighbour
from barchan.kernels.grain_state import NOWHERE, OUT, free_slot
from barchan.kernels.grain_surface import renew_mesh, renew_mesh_about
from barchan.kernels.settle import CHECKED, let_go, upset

MOVED, LEFT, CAPPED, TRAVEL_X, TRAVEL_Y, FLOWN, LOST = range(7)
"""What the counts of a step hold; travel in ``TRAVEL_UNIT``."""
COUNTS = 7


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def change_sand(cell, parcels, ground, scale, grid):
    """Lay parcels on a cell, or take them (negative)."""
    ground.sand[cell] += parcels
    ground.level[cell] += parcels * scale.parcel
    ground.height[cell] = np.float32(ground.level[cell] * scale.part)
    renew_mesh_about(cell, ground, grid)


@njit(cache=True, nogil=True, error_model="numpy")
def exchange(first, count, grains, ground, scale, grid, events, counts):
    """Lay down the parcels that came to rest and take those that were lifted, entry by entry.

    A cell that has no sand left by then gives none, and the slot stays free.
    """
    for k in range(first, first + count):
        rest, source = events.rest[k], events.source[k]
        if rest != NOWHERE:
            counts[TRAVEL_X] += events.way_x[k]
            counts[TRAVEL_Y] += events.way_y[k]
        if rest == OUT:
            counts[LEFT] += 1
        elif rest != NOWHERE:
            counts[CAPPED] += events.capped[k]
            change_sand(rest, 1, ground, scale, grid)
        if source != NOWHERE:
            if ground.sand[source] > 0:
                change_sand(source, -1, ground, scale, grid)
                counts[MOVED] += 1
            else:
                free_slot(events.slot[k], grains)


@njit(cache=True, nogil=True, error_model="numpy")
def _find_steep(level, rows, cols, repose, grid, steep):
    """Mark the cells that stand too high over one of their eight neighbours."""
    steep[:] = 0
    for row in range(rows):
        for step_row, step_col in ((0, 1), (1, 0), (1, 1), (1, -1)):
            limit = repose.face_limit if step_row * step_col == 0 else repose.corner_limit
            other = row + step_row
            if other == rows:
                if not grid.wrap_across:
                    continue
                other = 0
            here = level[row * cols : (row + 1) * cols]
            there = level[other * cols : (other + 1) * cols]
            mine = steep[row * cols : (row + 1) * cols]
            theirs = steep[other * cols : (other + 1) * cols]
            low = max(0, -step_col)
            high = cols - max(0, step_col)
            for col in range(low, high):
                step = here[col] - there[col + step_col]
                mine[col] |= step > limit
            for col in range(low, high):
                step = here[col] - there[col + step_col]
                theirs[col + step_col] |= step < -limit
            if step_col and grid.wrap_along:
                col = cols - 1 if step_col > 0 else 0
                step = here[col] - there[cols - 1 - col]
                mine[col] |= step > limit
                theirs[cols - 1 - col] |= step < -limit


@njit(cache=True, nogil=True, error_model="numpy")
def _relax(ground, scale, sequences, key, grid, repose, queue, waiting, length):
    slid = let_go(
        *(ground.level, ground.sand, None, None, sequences, queue, waiting, length, key),
        *(grid, None, repose),
    )
    if slid > 0:
        renew_surface(ground, scale, grid)
    return slid


@njit(cache=True, nogil=True, error_model="numpy")
def settle_steep(ground, scale, sequences, key, grid, repose, queue, waiting):
    """Let every slope slide that is too steep, until all hold; how many parcels slid.

    ``queue`` and ``waiting`` (both over the cells) are work space; ``waiting`` is all zero before and after.
    """
    _find_steep(ground.level, grid.rows, grid.cols, repose, grid, waiting)
    length = 0
    for cell in range(waiting.size):
        if waiting[cell]:
            queue[length] = cell
            waiting[cell] = CHECKED
            length += 1
    return _relax(ground, scale, sequences, key, grid, repose, queue, waiting, length)


@njit(cache=True, nogil=True, error_model="numpy")
def settle_about(cell, other, ground, scale, sequences, key, grid, repose, queue, waiting):
    """The same where only two cells changed."""
    length = 0
    for changed in (cell, other):
        length = upset(changed, CHECKED, queue, waiting, 0, length)
        for k in range(8):
            r, c = neighbour(changed // grid.cols, changed % grid.cols, k, grid)
            length = upset(r * grid.cols + c, CHECKED, queue, waiting, 0, length)
    return _relax(ground, scale, sequences, key, grid, repose, queue, waiting, length)


@njit(cache=True, nogil=True, error_model="numpy")
def renew_surface(ground, scale, grid):
    """Compute every stack's height (m, float32) from its level, and the mesh."""
    for cell in range(ground.level.size):
        ground.height[cell] = np.float32(ground.level[cell] * scale.part)
    renew_mesh(ground, grid)
