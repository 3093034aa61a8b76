"""The air as the kernels of flight take it: tables of wind and drag, the wind near the bed and over waves.

A field over the cells is a flat array. What only some models have is one optional struct for each concept.
"""

from typing import NamedTuple

import numpy as np

TABLE_SHIFT = 17
"""Bits of a 32-bit float below those that choose a table's entry: 64 entries for each doubling."""


class Table(NamedTuple):
    """Values of a function of a positive number, by the leading bits of that number as a 32-bit float."""

    values: np.ndarray
    """Of a function for each size class, one table after the other."""
    first: np.int32
    """Bits of the number at which the table begins."""
    last: np.int32
    """The last entry of one function."""


class Air(NamedTuple):
    """Effect of the air on a grain in one time step."""

    wind: Table
    """Wind speed (m/s) by height above the shelter surface (m); where the near-bed wind varies in space, the
    speed for a friction velocity of 1 m/s near the bed."""
    drag: Table
    """Share of a velocity difference that one step takes away, by the square of the difference (m²/s²)."""
    wind_x: np.float32
    """Direction to which the wind blows (unit vector)."""
    wind_y: np.float32
    fall: np.float32
    """Speed (m/s) that gravity adds in a step."""
    early_fall: np.float32
    """Part of that speed that drag within the step acts on."""
    before: np.float32
    """Distance (cells) that a step makes of each m/s before it."""
    after: np.float32
    """Distance (cells) that a step makes of each m/s after it."""
    rise_before: np.float32
    """Height (m) that a step makes of each m/s before it; the wind is read at the height after that part."""
    rise_after: np.float32
    """Height (m) that a step makes of each m/s after it."""
    above: Table | None = None
    """Speed gained above the Bagnold focus (m/s); only where the near-bed wind varies in space."""


class Feedback(NamedTuple):
    """The wind near the bed, slowed by grains, where it varies in space."""

    near_bed_ustar: np.ndarray
    """Friction velocity (m/s, float32) below the focus, by cell."""
    momentum_loss: np.ndarray
    """Speed along the wind that impacts took from grains (``LOSS_UNIT``, int64), by cell."""


class Speedup(NamedTuple):
    """The speed of a wind over waves, by mesh cell (float32)."""

    factor: np.ndarray
    """Wind speed over that above a level bed."""
    crosswind_ratio: np.ndarray
    """Wind speed to the left of the wind's direction over the speed along it."""


class Flow(NamedTuple):
    """The wind over waves of the bed."""

    streamline_slope: np.ndarray
    """Rise over run of streamlines along the wind, by mesh cell (float32)."""
    speedup: Speedup | None = None
    """None: the wind is as fast as above a level bed."""


class BedStress(NamedTuple):
    """The shear stress of the wind on the bed, by cell (float64)."""

    ustar: np.ndarray
    """Friction velocity of the wind along the bed (m/s)."""
    deflection: np.ndarray
    """Stress to the left of the wind over the stress along it."""


class CanopyDrag(NamedTuple):
    """The wind over plants, by mesh cell (float32)."""

    displacement_height: np.ndarray
    """Height (m) by which plants lift the wind profile."""
    speed_deficit: np.ndarray
    """Wind speed (m/s) that plants take."""
