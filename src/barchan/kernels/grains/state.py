"""Grains, air and bed as the kernels of flight see them: arrays and numbers, no rules."""

from typing import NamedTuple

import numpy as np

from barchan.kernels.bed.state import Grid, Mixture

FREE, FLYING, LANDED, GONE = (np.int32(number) for number in range(4))
"""What a slot holds: nothing, a grain in the air, one that has come to rest, one that has left the field."""

SUNK = np.float32(-1.0)
"""Height (m) of free slots: below any surface."""


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


LOST_UNIT = 1 << 20
"""Parts of 1 m/s in which the speed that impacts take is counted, for the same reason."""


MOVED, LEFT, CAPPED, TRAVEL_X, TRAVEL_Y, FLOWN, LOST = range(7)
"""What the counts of a step hold, in grains; travel in ``TRAVEL_UNIT``."""


COUNTS = 7
"""How many they are; after them follow those that left, by size."""


TABLE_SHIFT = 17
"""Bits of a 32-bit float below those that choose a table's entry: 64 entries for each doubling."""


class Creep(NamedTuple):
    """How grains are pushed; by size where there are several."""

    number: np.ndarray
    """Parcels set in motion for each m/s of an impact on such sand alone."""
    reach: np.ndarray
    """Distance (cells) that they go against a resistance as great as their weight."""
    threshold: np.ndarray
    """Friction velocity (m/s) near the bed of a wind that keeps them going by itself."""
    friction: float
    """Resistance of the bed over their weight, as a slope (rise over run)."""
    wind_x: float
    """Where the wind blows (unit vector)."""
    wind_y: float
    shelter: float
    """Depth (m) below the line that shelters in which the wind still reaches grains: that line is not drawn
    anew for each that leaves."""


class Filter(NamedTuple):
    """When and how strongly the filter works."""

    gain: float
    least: float
    """Difference to the neighbours' mean (parts) from which on it works."""


class Sorting(NamedTuple):
    """How splash differs by size: an impact of one size (rows) on parcels of another (columns)."""

    number: np.ndarray
    """Parcels thrown out over those of sand that is all alike; 0 of sizes too heavy."""
    speed: np.ndarray
    """Their mean speed over that of sand that is all alike."""


class Splash(NamedTuple):
    """What impacts do; angles in rad, speeds in m/s."""

    rebound_most: float
    """Chance that the fastest grains rebound."""
    rebound_rate: float
    """How fast the chance grows with impact speed (s/m)."""
    restitution: float
    """Speed after a rebound over the speed before."""
    rebound_angle: float
    """Mean angle to the surface."""
    number: float
    """Ejecta for each m/s of impact speed."""
    fastest: float
    """Mean speed of ejecta of the fastest impacts."""
    scale: float
    """Impact speed at which ejecta come near to that."""
    eject_angle: float
    spread: float
    """Half the range of azimuths about the impact's own."""
    most: int
    """Rebounds after which a grain stays where it lands."""
    creep: Creep
    """How impacts push grains along the bed."""
    sorting: Sorting | None = None
    """What size changes; None: all grains are alike."""


class Scene(NamedTuple):
    """What takes part in an iteration."""

    grains: Grains
    air: Air
    grid: Grid
    ground: Ground
    scale: Scale
    rules: tuple[Bounce, LiftOff]
    splash: object
    """What impacts throw out; None: nothing, grains bounce."""
    events: Events
    ejecta: Ejecta
    counts: np.ndarray


MOST_ITERATIONS = 256
"""Of a spell: so long an interruption waits."""
