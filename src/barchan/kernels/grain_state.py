"""Grains, air and bed as the kernels of flight see them: arrays and numbers, no rules."""

from typing import NamedTuple

import numpy as np
from numba import njit

from barchan.kernels.grain_surface import nearest_cell
from barchan.kernels.mixture import Mixture, kind_of, set_kind
from barchan.kernels.random import GOLDEN, mix

FREE, FLYING, LANDED, GONE = (np.int32(number) for number in range(4))
"""What a slot holds: nothing, a grain in the air, one that has come to rest, one that has left the field."""

SUNK = np.float32(-1.0)
"""Height (m) of free slots: below any surface."""

_FRACTION = 2.0**-53
_ZERO = np.float32(0.0)


class Grains(NamedTuple):
    """Grains by slot: one array for each quantity, float32 and int32."""

    x: np.ndarray
    """Place east of the westernmost stacks (cells)."""
    y: np.ndarray
    """Place north of the southernmost stacks (cells)."""
    z: np.ndarray
    """Height (m)."""
    u: np.ndarray
    """Velocity eastwards (m/s)."""
    v: np.ndarray
    w: np.ndarray
    from_x: np.ndarray
    """Where the grain was lifted (cells)."""
    from_y: np.ndarray
    held: np.ndarray
    """What the slot holds."""
    bounces: np.ndarray
    laps_x: np.ndarray
    """How often the grain went round the field eastwards."""
    laps_y: np.ndarray
    kind: np.ndarray | None = None
    """Its size (int32), where there are several."""


class Table(NamedTuple):
    """Values of a function of a positive number, by the leading bits of that number as a 32-bit float."""

    values: np.ndarray
    """Where there is a function for each size of grain, one after the other."""
    first: np.int32
    """Bits of the number at which the table begins."""
    last: np.int32
    """The last entry of a function."""


class Air(NamedTuple):
    """What the air does to a grain in one time step."""

    wind: Table
    """Wind speed (m/s) by height above the sheltering surface (m)."""
    drag: Table
    """Share of a velocity difference that one step takes away, by the square of the difference (m²/s²)."""
    wind_x: np.float32
    """Where the wind blows (unit vector)."""
    wind_y: np.float32
    fall: np.float32
    """Speed (m/s) that gravity adds in a step."""
    early_fall: np.float32
    """The part of it that drag within the step already sees."""
    before: np.float32
    """Distance (cells) that a step makes of each m/s before it."""
    after: np.float32
    """The same of each m/s after it."""
    rise_before: np.float32
    """Height (m) that a step makes of each m/s before it; the wind is looked up after so much of it."""
    rise_after: np.float32
    above: Table | None = None
    """Where the wind near the bed has places: what comes to it above the focus (m/s). ``wind`` is then the
    wind for a friction velocity of 1 m/s near the bed."""


class Ground(NamedTuple):
    """The bed as grains meet it, flat arrays over the cells."""

    sand: np.ndarray
    """Parcels (int32)."""
    level: np.ndarray
    """Elevation of the surface in parts of a parcel (int64)."""
    height: np.ndarray
    """The same in metres (float32), as flight reads it."""
    lid: np.ndarray
    """The surface above which the wind blows (m): ``height`` itself where nothing shelters."""
    top: np.ndarray
    """The highest corner of each mesh cell (m)."""
    base: np.ndarray
    """The mean of the lid over each mesh cell (m) and what plants lift it by: the wind's height counts from
    there."""
    stale: np.ndarray
    """Rows of mesh cells (1, else 0; uint8) of whose stacks some have changed since."""
    mixture: Mixture | None = None
    """Where sand of which size lies, where there are several."""
    near: np.ndarray | None = None
    """Friction velocity (m/s, float32) near the bed, where it has places."""
    lost: np.ndarray | None = None
    """Speed along the wind that impacts took (int64), where it is counted by place."""
    rise: np.ndarray | None = None
    """Slope of the wind along its way over each mesh cell (float32), where it follows the bed."""
    gain: np.ndarray | None = None
    """Wind speed over that above a level bed (float32), where it is faster over waves."""
    aside: np.ndarray | None = None
    """Part of the wind that blows to the left of its way (float32), there too."""
    bed_wind: np.ndarray | None = None
    """Friction velocity (m/s, float64) of the wind along the bed at each cell, where grains creep."""
    bed_turn: np.ndarray | None = None
    """Stress of the wind to its left over that along it (float64), there too."""
    lift: np.ndarray | None = None
    """Height (m, float32) by which plants lift the wind over each mesh cell, where there are any."""
    taken: np.ndarray | None = None
    """Wind speed (m/s, float32) that they take over each mesh cell."""


class Scale(NamedTuple):
    """Units of the bed."""

    parcel: int
    """Parts of a parcel in a level."""
    part: float
    """Height (m) of one part."""
    cell_size: float
    """Width of a cell (m)."""
    carried: int
    """Parcels that a grain takes along: one, or ``PATCH`` where it takes them from nine stacks."""


class Bounce(NamedTuple):
    """How grains bounce."""

    normal: float
    """Share of the speed across the surface that is kept."""
    tangential: float
    stop_speed: float
    """Speed (m/s) below which a grain stays where it is."""
    most: int
    """Bounces after which it does, whatever its speed."""


class LiftOff(NamedTuple):
    """How grains leave the bed, from anywhere on it."""

    chance: float
    """Chance that a free slot tries in an iteration; 0 below the threshold."""
    slowest: float
    """Least and greatest upward speed (m/s)."""
    fastest: float
    flattest: float
    """Least and greatest angle (rad) to the horizontal."""
    steepest: float
    wind_x: float
    wind_y: float
    from_lee: bool
    """Whether faces that look downwind give grains too."""
    creeps: np.ndarray | None = None
    """Which sizes are too heavy to be lifted, where there are several."""


class Events(NamedTuple):
    """What became of grains in an iteration: an entry for each that flies no longer, or hit the bed."""

    near: np.ndarray
    """Slots that flight found to be near the ground or outside the field."""
    slot: np.ndarray
    """The slot, where it was freed; ``NOWHERE`` where its grain flies on."""
    rest: np.ndarray
    """The cell it came to rest on, or ``NOWHERE``, or ``OUT`` of the field."""
    source: np.ndarray
    """The cell that its slot would lift a parcel from next, or ``NOWHERE``."""
    way_x: np.ndarray
    """How far it came (``TRAVEL_UNIT``)."""
    way_y: np.ndarray
    capped: np.ndarray
    """Whether it stopped because it had bounced too often."""
    impact: np.ndarray
    """Speed at which it hit the bed (m/s); 0 where it did not, or where impacts throw nothing out."""
    x: np.ndarray
    """Where it did (cells, float32)."""
    y: np.ndarray
    u: np.ndarray
    """Its velocity then (m/s)."""
    v: np.ndarray
    lost: np.ndarray
    """Speed along the wind that the impact took (``LOST_UNIT``)."""
    start: np.ndarray
    """Where the random numbers of the impact start."""
    kind: np.ndarray | None = None
    """The grain's size, where there are several."""


class Ejecta(NamedTuple):
    """Parcels that impacts throw out in an iteration, and what that takes; see ``grain_splash``."""

    hits: np.ndarray
    """Entries of ``Events`` that are impacts, in their order."""
    free: np.ndarray
    """Slots that are free, in the order of entries."""
    entry: np.ndarray
    """By parcel: the impact's entry."""
    number: np.ndarray
    """Which one of the impact's it is."""
    slot: np.ndarray
    """The slot that it flies in."""
    surface: np.ndarray
    """Height (m) of the surface when it was thrown out, and its slopes."""
    east: np.ndarray
    north: np.ndarray


NOWHERE, OUT = -1, -2

PATCH = 16
"""Parcels of a grain over nine stacks: 4 on the middle one, 2 on those at its faces, 1 at its corners."""

TRAVEL_UNIT = 1 << 16
"""Parts of a cell in which travel is counted, so that sums are exact."""

LOST_UNIT = 1 << 20
"""Parts of 1 m/s in which the speed that impacts take is counted, for the same reason."""


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def mesh_cell(x, y, cols):
    """The mesh cell that a place lies in."""
    return np.int32(y) * np.int32(cols) + np.int32(x)


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def draw(start, number):
    """Draw ``number`` (from 1 on) of a sequence, from 0 to below 1."""
    return np.float64(mix(start + GOLDEN * np.uint64(number)) >> np.uint64(11)) * _FRACTION


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def free_slot(slot, grains):
    """Take the grain out of a slot; the slot stays below the ground until it is used again."""
    grains.held[slot] = FREE
    grains.x[slot] = grains.y[slot] = _ZERO
    grains.z[slot] = SUNK
    grains.u[slot] = grains.v[slot] = grains.w[slot] = _ZERO


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def launch(slot, x, y, z, u, v, w, grains):
    """Let a grain start from a slot at a place (cells, m) with a velocity (m/s)."""
    grains.x[slot] = grains.from_x[slot] = x
    grains.y[slot] = grains.from_y[slot] = y
    grains.z[slot] = z
    grains.u[slot] = u
    grains.v[slot] = v
    grains.w[slot] = w
    grains.laps_x[slot] = grains.laps_y[slot] = 0
    grains.bounces[slot] = 0
    grains.held[slot] = FLYING


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def _way(there, start, laps, size):
    way = np.float64(there) - np.float64(start) + np.float64(laps) * size
    return np.int64(np.rint(way * TRAVEL_UNIT))


@njit(cache=True, nogil=True, error_model="numpy", forceinline=True)
def record_end(k, slot, most, grains, grid, events):
    """Put into entry ``k`` how the flight of a slot ended, if there was one, and free the slot."""
    events.slot[k] = slot
    events.source[k] = events.rest[k] = NOWHERE
    events.capped[k] = False
    set_kind(events.kind, k, kind_of(grains.kind, slot))
    if grains.held[slot] != FREE:
        gone = grains.held[slot] == GONE
        events.rest[k] = OUT if gone else nearest_cell(grains.x[slot], grains.y[slot], grid)
        events.capped[k] = grains.bounces[slot] >= most and not gone
        events.way_x[k] = _way(grains.x[slot], grains.from_x[slot], grains.laps_x[slot], grid.cols)
        events.way_y[k] = _way(grains.y[slot], grains.from_y[slot], grains.laps_y[slot], grid.rows)
    free_slot(slot, grains)
