"""A surface as its measures see it, and the measures, each declared once."""

import math
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.analysis.declared_measures import Value
from barchan.errors import SurveyError
from barchan.measures.crest_lines import CrestLine, crest_lines
from barchan.measures.crest_spacing import CrestSpacing, crest_spacing
from barchan.measures.crest_to_toe import crest_to_toe_height
from barchan.measures.dune_shapes import DuneShape, dune_shape
from barchan.measures.dunes import Dune
from barchan.measures.filters import without_trend
from barchan.measures.floor import dunes_on_floor
from barchan.measures.landform import LOPSIDED, Landform, half_spacing, landform
from barchan.measures.lee_side import LeeSide, lee_side
from barchan.measures.orientation import Orientation, crest_orientation
from barchan.measures.relief import bedform_height
from barchan.measures.roughness import roughness
from barchan.measures.slopes import Slopes, slip_face_angle, streamwise_slopes
from barchan.measures.spacing import dominant_spacing
from barchan.survey.height_field import HeightField
from barchan.survey.reading import read_field

STRAIGHT = 0.2
"""Straightness from which on crests have a common direction; that of frames of runs."""


def measure(source: Any, *, wind: float | None = None, **reading: Any) -> "Survey":
    """Measure a surface: a file, a run's folder, an array with its ``cell_size`` (m), or a HeightField.

    ``wind`` (degrees clockwise from north) is where the resultant wind comes from; without it that of a run,
    or the one that the steeper sides show. Other keywords are those of ``read_field``. Raises SurveyError.
    """
    if isinstance(source, str | Path):
        source = read_field(source, **reading)
    elif not isinstance(source, HeightField):
        joined = bool(reading.pop("periodic", False))
        cell_size = reading.pop("cell_size", None)
        if cell_size is None or reading:
            raise SurveyError("an array needs cell_size (m), and takes periodic and wind besides")
        source = HeightField.of_array(source, cell_size, (joined, joined))
    if wind is not None and not 0.0 <= wind <= 360.0:
        raise SurveyError(f"a wind from {wind:g}°; allowed: 0 to 360, clockwise from north")
    return Survey(source, math.nan if wind is None else wind)


@dataclass(frozen=True)
class Survey:
    """A surface with its measures, each computed when it is first asked for."""

    field: HeightField
    given: float = math.nan
    """The stated wind (degrees); NaN without one."""

    def values(self) -> list[Value]:
        """Every measure of the surface; of a frame of a run, those that need the run too."""
        from barchan.survey.surface_measures import SURFACE_MEASURES

        names = {value.measure.name for value in self.field.known}
        own = [measure.of(self) for measure in SURFACE_MEASURES if measure.name not in names]
        return [*self.field.known, *own]

    @property
    def heights(self) -> NDArray[np.float64]:
        """The heights (m)."""
        return self.field.heights

    @property
    def cell_size(self) -> float:
        """The side of a cell (m)."""
        return self.field.cell_size

    @property
    def periodic(self) -> tuple[bool, bool]:
        """Whether the surface is periodic south to north and west to east."""
        return self.field.periodic

    @cached_property
    def lee(self) -> LeeSide:
        """The steeper side."""
        return lee_side(self.heights, self.cell_size, self.periodic)

    @property
    def wind(self) -> float:
        """The wind (degrees) that is stated, that of the run, or the one that lee sides show; else NaN."""
        for wind in (self.given, self.field.wind):
            if not math.isnan(wind):
                return wind
        return self.lee.wind if self.lee.strength >= LOPSIDED else math.nan

    @cached_property
    def orientation(self) -> Orientation:
        """Mean direction of the crests."""
        return crest_orientation(self.heights, self.cell_size, self.periodic)

    @cached_property
    def across(self) -> float:
        """Direction (degrees) across the crests, from the windward side where that is known."""
        wind = self.lee.wind if math.isnan(self.wind) else self.wind
        wind = 0.0 if math.isnan(wind) else wind
        if not self.orientation.coherence >= STRAIGHT:
            return wind
        normal = self.orientation.azimuth + 90.0
        return (normal if math.cos(math.radians(normal - wind)) >= 0.0 else normal + 180.0) % 360.0

    @cached_property
    def spacing(self) -> float:
        """Dominant spacing (m) across the crests."""
        return dominant_spacing(self.heights, self.cell_size, self.across, self.periodic)

    @cached_property
    def crest_spacing(self) -> CrestSpacing:
        """Spacing of the crests, one by one."""
        return crest_spacing(self.heights, self.cell_size, self.across, self.periodic)

    @cached_property
    def bedform_height(self) -> float:
        """Height (m) of waves with the standard deviation of the surface."""
        return bedform_height(self.heights, self.periodic)

    @cached_property
    def grit(self) -> float:
        """Root-mean-square height (m) of what is smaller than about six cells."""
        return roughness(self.heights, self.periodic, 1.0)

    @cached_property
    def dune_height(self) -> float:
        """Height (m) from crest to toe."""
        return crest_to_toe_height(self.heights, self.across, self.periodic)

    @cached_property
    def slopes(self) -> Slopes:
        """Mean slopes (degrees) across the crests."""
        return streamwise_slopes(self.heights, self.cell_size, self.across, self.periodic)

    @cached_property
    def slip_face_angle(self) -> float:
        """The 95th percentile (degrees) of lee slopes."""
        return slip_face_angle(self.heights, self.cell_size, self.across, self.periodic)

    @cached_property
    def landform(self) -> Landform:
        """The class of the field."""
        return landform(self.heights, self.cell_size, self.wind, self.periodic)

    @property
    def reach(self) -> float:
        """Half a spacing (cells), within the field."""
        return half_spacing(self.spacing, self.cell_size, self.heights.shape)

    @cached_property
    def crests(self) -> list[CrestLine]:
        """Crest lines, the longest first; none on a surface without relief."""
        if not self.bedform_height > 0.0:
            return []
        return crest_lines(without_trend(self.heights, self.periodic), self.periodic, reach=self.reach)

    @cached_property
    def dunes(self) -> list[tuple[Dune, DuneShape]]:
        """Single dunes above the floor between them, the largest first, with their shapes."""
        found = dunes_on_floor(self.heights, self.reach, self.periodic)
        wind = self.across if math.isnan(self.wind) else self.wind
        shapes = [(dune, dune_shape(dune, wind, self.cell_size)) for dune in found]
        return sorted(shapes, key=lambda one: -one[1].volume)
