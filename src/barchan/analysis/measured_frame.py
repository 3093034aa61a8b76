"""One frame of a run as measures see it: the surface of its bedforms, their crests, the wind over them."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Bed
from barchan.directions import downwind
from barchan.measures.bedform_surface import is_level
from barchan.measures.crest_to_toe import crest_to_toe_height
from barchan.measures.migration import Migration
from barchan.measures.orientation import Orientation, crest_orientation
from barchan.measures.relief import bedform_height
from barchan.measures.slopes import Slopes, slip_face_angle, streamwise_slopes
from barchan.measures.spacing import dominant_spacing
from barchan.models import Model, ModelMeasure
from barchan.scenario import Scenario
from barchan.squares import Squares
from barchan.wind.segment import Segment

WindChoice = Literal["resultant", "last"]
"""The wind that windward, lee and downwind refer to: that of a whole cycle's transport, or the last one."""

STRAIGHT = 0.2
"""Straightness from which on crests have a common direction; ours."""


@dataclass(frozen=True)
class MeasuredFrame:
    """One frame of a run, compared with the frames before it."""

    modelled: Callable[[], tuple[Model, Bed, Segment]]
    """The model, the bed and the wind as they were then."""
    bed: Bed
    """Ground and layers."""
    surface: NDArray[np.float64]
    """Elevation (m) of the bedforms on squares, without the relief of uneven ground; NaN on rock."""
    scenario: Scenario
    direction: float
    """Direction that the last wind came from (degrees clockwise from north)."""
    resultant: float
    """Direction that the resultant wind comes from (degrees clockwise from north); NaN where winds cancel."""
    wind: WindChoice
    migration: Migration
    standing: str
    """Why there can be no migration, where the frames do not allow any."""
    travel: tuple[float, float]
    """Distance (cells, east and north) travelled on the wind since the frame before, summed over slabs."""
    steps: int
    """Steps since the frame before."""
    span: int
    """Steps since the frame that the latest displacement is from; 0 without one."""

    def __repr__(self) -> str:
        rows, columns = self.surface.shape
        return f"<MeasuredFrame of {rows} × {columns} cells, {self.steps} steps after the one before>"

    @property
    def periodic(self) -> tuple[bool, bool]:
        """Whether the field is periodic south to north and west to east."""
        return self.scenario.lattice.periodic

    @property
    def cell_size(self) -> float:
        """Width of a cell (m)."""
        return self.scenario.lattice.cell_size

    def of_model(self, measure: ModelMeasure) -> float:
        """A measure that only the model can give."""
        if measure.shared is None:
            return float(measure.compute(*self._parts))
        if measure.shared not in self._shared:
            self._shared[measure.shared] = measure.shared(*self._parts)
        return float(measure.compute(self._shared[measure.shared]))

    @cached_property
    def _parts(self) -> tuple[Model, Bed, Segment]:
        return self.modelled()

    @cached_property
    def _shared(self) -> dict[Callable[..., Any], Any]:
        return {}

    @cached_property
    def unit_height(self) -> float:
        """Mean thickness (m) of a unit of the layers: a slab's, or that of quanta as dense as those there."""
        lattice, units = self.scenario.lattice, self.bed.units
        if self.bed.layers[-1].mass is None or units == 0:
            return lattice.thickness
        return self.bed.volume / (units * lattice.cell_area)

    @property
    def upwind(self) -> float:
        """Direction (degrees) that the chosen wind comes from; the last one's where all winds cancel."""
        return self.direction if self.wind == "last" or math.isnan(self.resultant) else self.resultant

    @cached_property
    def orientation(self) -> Orientation:
        """Mean direction of the crests."""
        return crest_orientation(self.surface, self.cell_size, self.periodic)

    @cached_property
    def across(self) -> float:
        """Direction (degrees) across the crests, from the side that the chosen wind comes from.

        The wind's own where the crests have no common direction.
        """
        if not self.orientation.coherence >= STRAIGHT:
            return self.upwind
        normal = self.orientation.azimuth + 90.0
        facing = math.cos(math.radians(normal - self.upwind)) >= 0.0
        return (normal if facing else normal + 180.0) % 360.0

    @cached_property
    def spacing(self) -> float:
        """Dominant spacing (m) across the crests."""
        return dominant_spacing(self.surface, self.cell_size, self.across, self.periodic)

    @cached_property
    def bedform_height(self) -> float:
        """Height (m) of waves with the standard deviation of the surface."""
        return bedform_height(self.surface, self.periodic)

    @cached_property
    def dune_height(self) -> float:
        """Height (m) from crest to toe."""
        return crest_to_toe_height(self.surface, self.across, self.periodic)

    @cached_property
    def slopes(self) -> Slopes:
        """Mean slopes (degrees) across the crests."""
        return streamwise_slopes(self.surface, self.cell_size, self.across, self.periodic)

    @cached_property
    def slip_face_angle(self) -> float:
        """The 95th percentile (degrees) of lee slopes of the sand, to the horizontal."""
        squares = Squares(self.bed.lattice)
        elevation = squares.between(self.bed.elevation)
        if not is_level(self.bed.ground):
            elevation = np.where(squares.between(self.bed.stack > 0), elevation, np.nan)
        return slip_face_angle(elevation, self.cell_size, self.across, self.periodic)

    @property
    def speed(self) -> float:
        """Migration along the chosen wind (cells per step)."""
        return self.migration.along(*downwind(self.upwind))
