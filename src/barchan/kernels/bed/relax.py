"""Avalanches that go on until every slope stands, over the whole bed or from where something changed.

For initial surfaces, painted sand, changed limits and dying plants, and for sand that starts to slide at one
angle and comes to rest at another. The order of work is fixed; equally steep neighbours are checked in
orders that alternate without a pattern, so that a heap does not lean.
"""

import numpy as np
from numba import njit
from numpy.typing import NDArray

from barchan.kernels.bed.active_layer import slide
from barchan.kernels.bed.grid import neighbour
from barchan.kernels.bed.loose import slide_loose
from barchan.kernels.bed.sliding import drawn_downslope
from barchan.kernels.bed.slopes import has_sand, steepest
from barchan.kernels.bed.state import DOWN, STABLE, ActiveLayer, Grid, Repose, Stacks, unstable_cells
from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.inlining import never_inline
from barchan.kernels.core.internal import internal
from barchan.kernels.core.progress import report
from barchan.kernels.core.random import mix

SINGLY = 256
"""Slides for each cell of the field after which slabs slide together: more than any usual bed takes."""

TOGETHER = 8
"""Slabs by which a step is too high beyond which slabs slide together."""

BATCH = 200_000
"""Slides after which a signal is handled: some tenths of a second at most."""

NO_END = 1 << 62
"""Slides that no avalanche has."""

CHECKED, MOVING = 1, 2
"""Why a cell waits to be looked at: a neighbour changed, or an avalanche moved its sand."""


@internal(forceinline=True)
def enqueue(unstable, cell, why, at, length):
    """Put a cell on the queue that starts ``at`` if the cell does not wait yet; the queue's new length."""
    if unstable.waiting[cell] == 0:
        unstable.queue[(at + length) % unstable.queue.size] = cell
        length += 1
    unstable.waiting[cell] = max(unstable.waiting[cell], why)
    return length


@internal()
def enqueue_about(unstable, row, col, first, at, length, grid):
    """Put the neighbours of a cell on the queue, from direction ``first`` on; the queue's new length."""
    unstable = borrowed(unstable)
    for k in range(8):
        r, c = neighbour(row, col, (first + k) & 7, grid)
        length = enqueue(unstable, r * grid.cols + c, CHECKED, at, length)
    return length


@internal(forceinline=True)
def _move_slabs(surface, sand, cell, lower, slab, count):
    """Move slabs of sand from a cell to a lower one."""
    surface[cell] -= slab * count
    surface[lower] += slab * count
    if sand is not None:
        sand[cell] -= count
        sand[lower] += count


@internal(forceinline=True)
def _sliding(surface, sand, cell, lower, limit, slab):
    """Slabs that slide together: one, or half of what a high step has too many, as far as there is sand."""
    excess = np.int64(surface[cell]) - np.int64(surface[lower]) - limit
    if excess <= TOGETHER * slab:
        return np.int64(1)
    held = np.int64(surface[cell]) // slab if sand is None else np.int64(sand[cell])
    return min(excess // (2 * slab), held)


@internal()
def relax_queue(stacks, orders, unstable, progress, most, key, grid, repose, mixture):
    """Let the cells of the queue slide, and all that they upset, until every slope stands.

    Sand at rest slides where a step exceeds the static limit, moving sand comes to rest at the repose limit.
    Slabs slide one at a time, ``SINGLY`` times for each cell; then, from steps that are too high by more than
    ``TOGETHER`` slabs, half of these at once, so that the work does not grow with the height of the sand.
    ``orders`` are the orders in which neighbours are checked, one of which is drawn by ``key`` each time;
    where slabs go straight down the slope, the neighbour is.
    Sand of several sizes takes its ``mixture`` along (None: uniform). ``progress`` holds where the queue
    begins, its length, the slides and the slabs that slid so far; returns them after ``most`` more slides, or
    once the queue is empty.
    """
    never_inline()
    stacks, orders, unstable, mixture = borrowed((stacks, orders, unstable, mixture))
    at, length, slides, slid = progress
    end, singly = slides + most, SINGLY * unstable.waiting.size
    number_of_orders = np.uint64(orders.shape[0])
    while length > 0 and slides < end:
        cell = unstable.queue[at]
        at = at + 1 if at + 1 < unstable.queue.size else 0
        length -= 1
        at_rest = unstable.waiting[cell] == CHECKED
        unstable.waiting[cell] = 0
        if not has_sand(stacks.surface, stacks.sand, cell):
            continue
        row = cell // grid.cols
        col = cell % grid.cols
        draw = mix(key + np.uint64(slides))
        order = np.int64(draw % number_of_orders)
        here = np.int64(stacks.surface[cell])
        direction = steepest(stacks, orders, order, row, col, here, DOWN, at_rest, grid, repose)
        if direction == STABLE:
            continue
        if repose.downslope:
            direction = drawn_downslope(stacks, orders, order, row, col, here, DOWN, mix(draw), grid, repose)
        r, c = neighbour(row, col, direction, grid)
        lower = r * grid.cols + c
        limit = repose.face_limit if direction < 4 else repose.corner_limit
        count = np.int64(1)
        if slides >= singly:
            count = _sliding(stacks.surface, stacks.sand, cell, lower, limit, repose.slab)
        _move_slabs(stacks.surface, stacks.sand, cell, lower, repose.slab, count)
        slide(mixture, cell, lower, count)
        slide_loose(stacks.loose, cell, lower, count)
        slides += 1
        slid += count
        length = enqueue(unstable, lower, MOVING, at, length)
        length = enqueue_about(unstable, row, col, order, at, length, grid)
        length = enqueue(unstable, cell, MOVING, at, length)
    return at, length, slides, slid


@njit(cache=True, nogil=True)
def enqueue_all(unstable, where, grid):
    """Put the cells ``where`` (bool, flat) something changed and neighbours on the queue; its length."""
    length = 0
    for cell in range(where.size):
        if where[cell]:
            length = enqueue(unstable, cell, CHECKED, 0, length)
            length = enqueue_about(unstable, cell // grid.cols, cell % grid.cols, 0, 0, length, grid)
    return length


@njit(cache=True, nogil=True)
def _relax_some(stacks, orders, unstable, progress, grid, repose, mixture):
    key = np.uint64(0)
    return relax_queue(stacks, orders, unstable, progress, BATCH, key, grid, repose, mixture)


def relax_field(
    stacks: Stacks,
    where: NDArray[np.bool_],
    orders: NDArray[np.int64],
    grid: Grid,
    repose: Repose,
    mixture: ActiveLayer | None,
) -> int:
    """Let slopes that are too steep slide until all stand; returns the number of slabs that slid.

    Starts at the cells ``where`` (bool, flat) something changed and their neighbours and goes on wherever
    sand moves. Changes the stacks in place. After each batch of slides a signal can be handled, and whoever
    listens (``progress``) is told of the slabs that slid and the cells whose slopes have still to be checked.
    """
    unstable = unstable_cells(grid.rows * grid.cols)
    progress = 0, enqueue_all(unstable, where, grid), 0, 0
    while progress[1] > 0:
        progress = _relax_some(stacks, orders, unstable, progress, grid, repose, mixture)
        report(f"slopes relax: {progress[3]:,} slabs have slid, {progress[1]:,} cells still to be checked")
    return int(progress[3])
