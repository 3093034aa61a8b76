"""The wind's frame: the field turned by quarter turns so that the wind blows towards growing columns.

Only quarter turns are made, so nothing is interpolated; the remaining angle of the wind lies within 45
degrees of the columns' axis. A lattice of hexagons fits onto itself only after half turns: then it lies
within 90 degrees.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from barchan.directions import downwind

_AXIS = 1e-9
"""Angles (rad) to an axis below this are the axis itself."""


def off_axes(direction: float, hexagonal: bool = False) -> bool:
    """Whether a wind from ``direction`` (degrees) blows along no line of cells that share faces.

    Those are the rows and columns of squares, and of hexagons the rows and what lies at 60 degrees to them.
    """
    x, y = downwind(direction)
    towards = math.atan2(y, x)
    between = math.pi / 3 if hexagonal else math.pi / 2
    return abs(towards - math.floor(towards / between + 0.5) * between) >= _AXIS


@dataclass(frozen=True)
class WindFrame:
    """How the lattice lies to a wind."""

    turns: int
    """Quarter turns, anticlockwise seen from above, from the wind's frame to the map."""
    angle: float
    """Angle (rad) of the wind to the columns' axis, anticlockwise, within 45 degrees (hexagons: 90)."""

    @classmethod
    def of(cls, direction: float, hexagonal: bool = False) -> "WindFrame":
        """The frame of a wind from ``direction`` (degrees clockwise from north)."""
        x, y = downwind(direction)
        towards = math.atan2(y, x)
        turns = math.floor(towards / (math.pi / 2) + 0.5)
        if hexagonal:
            turns = 2 * math.floor(towards / math.pi + 0.5)
        angle = towards - turns * math.pi / 2
        return cls(turns % 4, 0.0 if abs(angle) < _AXIS else angle)

    @property
    def crossed(self) -> bool:
        """Whether the map's rows are the frame's columns."""
        return self.turns % 2 == 1

    def enter(self, field: NDArray) -> NDArray:
        """A field of the map as it lies in the frame (a view)."""
        return np.rot90(field, -self.turns, axes=(1, 0))

    def leave(self, field: NDArray) -> NDArray:
        """A field of the frame as it lies on the map (a view)."""
        return np.rot90(field, self.turns, axes=(1, 0))

    def to_map(self, along: float, across: float) -> tuple[float, float]:
        """A vector of the frame as (x, y) on the map."""
        for _ in range(self.turns):
            along, across = -across, along
        return along, across
