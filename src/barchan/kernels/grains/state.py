"""Grains and bed as the kernels of flight take them: arrays and numbers, no rules.

A field over the cells is a flat array. A mesh cell is the square between a stack and its neighbours in the
east and north. What only some models have is one optional struct for each concept.
"""

from typing import NamedTuple

import numpy as np

from barchan.kernels.bed.state import ActiveLayer, Grid, Repose, Unstable
from barchan.kernels.grains.air_state import Air, BedStress, CanopyDrag, Feedback, Flow
from barchan.kernels.grains.rules import Rules

FREE, FLYING, LANDED, GONE = (np.int32(number) for number in range(4))
"""Status of a slot: no grain, a grain in the air, one that has come to rest, one that has left the field."""

SUNK = np.float32(-1.0)
"""Height (m) of free slots: below any surface."""

NOWHERE, OUT = -1, -2
"""In place of a cell: none, and outside the field."""

PATCH = 16
"""Parcels of a grain over nine stacks: 4 on the middle one, 2 on those at its faces, 1 at its corners."""

LOSS_UNIT = 1 << 20
"""Parts of 1 m/s in which the speed that impacts take from grains is counted, as whole numbers."""

MOVED, LEFT, CAPPED, TRAVEL_X, TRAVEL_Y, FLOWN, LOSS = range(7)
"""Entries of the counts of a step, in grains; travel in ``TRAVEL_UNIT``, loss of speed in ``LOSS_UNIT``."""

COUNTS = 7
"""Number of these entries; grains that left the field follow, by size class."""

MOST_ITERATIONS = 256
"""Iterations of a batch at most: an interruption waits as long."""


class Grains(NamedTuple):
    """The pool of grains, by slot: one array for each quantity, float32 and int32."""

    x: np.ndarray
    """Distance east of the westernmost stacks (cells)."""
    y: np.ndarray
    """Distance north of the southernmost stacks (cells)."""
    z: np.ndarray
    """Height (m)."""
    u: np.ndarray
    """Velocity eastwards (m/s)."""
    v: np.ndarray
    """Velocity northwards (m/s)."""
    w: np.ndarray
    """Velocity upwards (m/s)."""
    from_x: np.ndarray
    """Place where the grain was lifted (cells)."""
    from_y: np.ndarray
    status: np.ndarray
    """``FREE``, ``FLYING``, ``LANDED`` or ``GONE``."""
    bounces: np.ndarray
    """Bounces since the grain was lifted."""
    wraps_x: np.ndarray
    """Times that the grain went round the field eastwards."""
    wraps_y: np.ndarray
    size_class: np.ndarray | None = None
    """Size class (int32); None: sand of one size."""


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


class Bonds(NamedTuple):
    """Snow whose grains bond."""

    loose: np.ndarray
    """Parcels that have not bonded (int32), by cell and age, the youngest first."""
    yields: bool
    """Whether the wind is strong enough to lift bonded parcels too."""
    hardness: float
    """Probability that an impact sets a bonded parcel in motion where it would a loose one."""
    restitution: float
    """Speed after a rebound off bonded snow over the speed before."""


class Ground(NamedTuple):
    """The bed as grains meet it."""

    sand: np.ndarray
    """Parcels (int32)."""
    level: np.ndarray
    """Elevation of the surface in parts of a parcel (int64)."""
    height: np.ndarray
    """Elevation of the surface (m, float32)."""
    shelter_surface: np.ndarray
    """Surface above which the wind blows (m, float32): ``height`` itself where nothing shelters."""
    top: np.ndarray
    """Highest corner of each mesh cell (m)."""
    base: np.ndarray
    """Zero of the wind's height over each mesh cell (m): the mean shelter surface and the displacement by
    plants."""
    stale: np.ndarray
    """1 for rows of mesh cells whose stacks have changed since ``top`` and ``base`` were computed (uint8)."""
    grid: Grid
    scale: Scale
    active_layer: ActiveLayer | None = None
    """None: sand of one size."""
    feedback: Feedback | None = None
    """None: the near-bed wind is uniform."""
    flow: Flow | None = None
    """None: the wind blows level."""
    bed_stress: BedStress | None = None
    """None: nothing creeps."""
    canopy: CanopyDrag | None = None
    """None: no plants."""
    bonds: Bonds | None = None
    """None: nothing bonds."""


class Landings(NamedTuple):
    """Impacts and landings of an iteration.

    There is an entry for each grain that hit the bed or left the field, and for each slot that is free.
    """

    candidates: np.ndarray
    """Slots whose grain is near the ground or outside the field."""
    slot: np.ndarray
    """The slot, where it was freed; ``NOWHERE`` where its grain flies on."""
    deposit_cell: np.ndarray
    """The cell that the grain came to rest on, or ``NOWHERE``, or ``OUT`` of the field."""
    lift_cell: np.ndarray
    """The cell that the slot lifts its next parcel from, or ``NOWHERE``."""
    travel_x: np.ndarray
    """Distance from lift-off to rest eastwards (``TRAVEL_UNIT``)."""
    travel_y: np.ndarray
    capped: np.ndarray
    """Whether the grain stopped because it had bounced too often."""
    impact_speed: np.ndarray
    """Speed at which the grain hit the bed (m/s); 0 where it did not, or where impacts throw nothing out."""
    x: np.ndarray
    """Place of the impact (cells, float32)."""
    y: np.ndarray
    u: np.ndarray
    """Velocity at the impact (m/s)."""
    v: np.ndarray
    momentum_loss: np.ndarray
    """Speed along the wind that the impact took (``LOSS_UNIT``)."""
    start: np.ndarray
    """Start of the impact's random numbers."""
    size_class: np.ndarray | None = None
    """Size class of the grain; None: sand of one size."""


class Ejecta(NamedTuple):
    """Parcels that impacts throw out in an iteration, and the lists that this takes."""

    hits: np.ndarray
    """Entries of ``Landings`` that are impacts, in their order."""
    place: np.ndarray
    """By impact: the first of the places for its ejecta; one more, the end of all."""
    entry: np.ndarray
    """By place: the impact's entry, or ``NOWHERE`` where none was thrown out."""
    number: np.ndarray
    """By place: its number among the ejecta of that impact."""
    slot: np.ndarray
    """By place: the slot that it flies in."""
    size_class: np.ndarray
    """By place: the parcel's size class."""
    surface: np.ndarray
    """By place: height (m) of the surface when it was thrown out."""
    east: np.ndarray
    """By place: slope of the surface eastwards then."""
    north: np.ndarray


class Slopes(NamedTuple):
    """Limits of slopes, and work space of their collapse."""

    repose: Repose
    orders: np.ndarray
    """Orders in which neighbours are checked."""
    unstable: Unstable
    """Cells whose slopes have still to be checked."""


class Scene(NamedTuple):
    """Everything that takes part in an iteration."""

    grains: Grains
    air: Air
    ground: Ground
    rules: Rules
    landings: Landings
    ejecta: Ejecta
    counts: np.ndarray
