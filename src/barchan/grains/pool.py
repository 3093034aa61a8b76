"""Slots that grains fly in: arrays of their motion and counters, and how they are kept together."""

from collections.abc import Iterable
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from barchan.kernels.grains.state import SUNK, Ejecta, Grains, Landings

MOTION, COUNTERS = 8, 4
"""Quantities of a grain, as numbers and as whole numbers; see ``kernels.grains.state.Grains``."""

SLOT_BYTES = 312
"""Memory (bytes) of a grain, of its landing and ejecta, and of a state that holds it."""

_PAGE, _STAGGER = 1024, 80
"""Numbers in a page of memory, and by how many rows start apart within it."""


def free_slots(count: int) -> tuple[NDArray[np.float32], NDArray[np.int32]]:
    """A pool of free slots: motion and counters.

    Rows start at different places of a memory page: a cache keeps few lines that start at the same one.
    """
    width = -(-count // _PAGE) * _PAGE + _STAGGER
    numbers = np.zeros((MOTION + COUNTERS, width), np.float32)[:, :count]
    motion, counters = numbers[:MOTION], numbers[MOTION:].view(np.int32)
    motion[2] = SUNK
    return motion, counters


def grains_in(
    motion: NDArray[np.float32], counters: NDArray[np.int32], size_class: NDArray[np.int32] | None = None
) -> Grains:
    """The grains in a pool as the kernels take them."""
    return Grains(*motion, *counters)._replace(size_class=size_class)


def close_gaps(quantities: Iterable[NDArray], used: NDArray[np.bool_], spare: int) -> int:
    """Move grains up to the first slots, in their order, where more than ``spare`` free ones lie between.

    ``used`` marks the slots that hold a grain, ``quantities`` are the arrays of the pool. Returns the number
    of slots from the first one to the last grain.
    """
    full = np.flatnonzero(used)
    last = int(full[-1]) + 1 if full.size else 0
    if last <= full.size + spare:
        return last
    order = np.concatenate((full, np.flatnonzero(~used[:last])))
    for quantity in quantities:
        quantity[:last] = quantity[order]
    return full.size


def work_space(slots: int, several_sizes: bool = False) -> tuple[Landings, Ejecta]:
    """Work space of an iteration: its landings and ejecta, for a pool of some ``slots``."""
    candidates, slot, deposit, lift, travel_x, travel_y = np.zeros((6, slots), np.int64)
    x, y = np.zeros((2, slots), np.float32)
    impact_speed, u, v = np.zeros((3, slots))
    landings = Landings(
        candidates=candidates,
        slot=slot,
        deposit_cell=deposit,
        lift_cell=lift,
        travel_x=travel_x,
        travel_y=travel_y,
        capped=np.zeros(slots, np.uint8),
        impact_speed=impact_speed,
        x=x,
        y=y,
        u=u,
        v=v,
        momentum_loss=np.zeros(slots, np.int64),
        start=np.zeros(slots, np.uint64),
        size_class=np.zeros(slots, np.int32) if several_sizes else None,
    )
    return landings, Ejecta(*np.zeros((6, slots + 1), np.int64), *np.zeros((3, slots)))


class Pool:
    """The grains in the air, by slot."""

    def __init__(self, size: int, several_sizes: bool) -> None:
        """Take the number of slots, and whether grains have size classes."""
        self.size, self.several_sizes = size, several_sizes
        self.in_use = size
        """Slots that fly: the first ones."""

    @cached_property
    def _arrays(self) -> tuple[NDArray[np.float32], NDArray[np.int32]]:
        """Grain arrays, allocated on first use.

        So a scenario can be inspected even if its grains would not fit in memory.
        """
        return free_slots(self.size)

    @property
    def motion(self) -> NDArray[np.float32]:
        """Place, velocity and place of lift-off of the grain in each slot."""
        return self._arrays[0]

    @property
    def counters(self) -> NDArray[np.int32]:
        """Status, bounces and wraps of the grain in each slot."""
        return self._arrays[1]

    @cached_property
    def size_class(self) -> NDArray[np.int32] | None:
        """Size class of the grain in each slot; None: sand of one size."""
        return np.zeros(self.size, np.int32) if self.several_sizes else None

    @cached_property
    def work(self) -> tuple[Landings, Ejecta]:
        """Work space of an iteration, made once: new memory is slow at first."""
        return work_space(self.size, self.several_sizes)

    @property
    def grains(self) -> Grains:
        """The grains as the kernels take them."""
        return grains_in(self.motion, self.counters, self.size_class)

    @property
    def flying(self) -> int:
        """Grains in the air."""
        return int(np.count_nonzero(self.counters[0, : self.in_use]))

    def use_few(self, spare: int) -> None:
        """Leave free slots but ``spare`` ones out of flight; grains move up where too many lie between."""
        if spare >= self.size:
            self.in_use = self.size
            return
        classes = () if self.size_class is None else (self.size_class,)
        used = self.counters[0, : self.in_use] != 0
        last = close_gaps((*self.motion, *self.counters, *classes), used, spare)
        self.in_use = min(last + spare, self.size)

    def state(self) -> dict[str, NDArray]:
        """All grains."""
        classes = {} if self.size_class is None else {"size_class": self.size_class}
        return {"motion": self.motion, "counters": self.counters, **classes}

    def restore(self, state: dict[str, NDArray]) -> None:
        """Take up remembered grains."""
        for name, array in self.state().items():
            array[...] = state[name]
        self.in_use = self.size
