"""The class of a field of sand: flat, young, ripples, barchan, parabolic, star, transverse or linear dunes.

The limits are ours; ``docs/measures.md`` states the rule and how it was tested.
"""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np
import scipy
from numpy.typing import NDArray

from barchan.directions import downwind
from barchan.measures.dune_shapes import DuneShape, dune_shape
from barchan.measures.filters import Field, Periodic, gradient, smoothed, without_trend
from barchan.measures.floor import dunes_on_floor, floor_share
from barchan.measures.lee_side import LeeSide, lee_side
from barchan.measures.orientation import Orientation, crest_orientation
from barchan.measures.spacing import dominant_spacing
from barchan.measures.stars import summits

Class = Literal[
    "flat", "young", "ripples", "barchan", "parabolic", "star", "transverse", "linear", "undetermined"
]

FLAT = 2.0
"""Degrees that the steepest two hundredth of a field are below where it is flat."""

OUTLASTING = 0.5
"""Share of a relief's variance that smoothing over 2 cells leaves, below which forms are only beginning."""

PARALLEL = 0.5
"""Straightness from which on a field has forms, however small."""

RIPPLES = 2.0
"""Spacing (m) below which bedforms are ripples."""

APART = 0.4
"""Share of floor from which on dunes are looked at one by one."""

HORNED = 0.3
"""Share of the dunes' area that dunes with a bay have at least where horns decide."""

AGREEING = 0.5
"""Mean cosine between horns and wind from which on horns point the same way."""

ARMED = 0.5
"""Share of summits with three arms or more from which on dunes are stars."""

STRAIGHT = 0.35
"""Straightness from which on a field has crests of one direction."""

LOPSIDED = 0.15
"""Strength of the lee side from which on it tells the wind."""

SLENDER = 3.0
"""Elongation from which on single dunes are ridges."""


@dataclass(frozen=True)
class Landform:
    """A class, and what decided."""

    name: Class
    reason: str


def landform(
    elevation: NDArray,
    cell_size: float,
    wind: float = float("nan"),
    periodic: Periodic = (True, True),
) -> Landform:
    """The class of a surface (m), in a resultant wind from ``wind`` (degrees) where that is known.

    Without a wind the steeper side of the bedforms is taken for their lee; where neither is, the class of
    ridges and of horned dunes is undetermined. The rule, in order: flat, where 99.5 % of the slopes are below
    2 degrees; young, where smoothing over 2 cells takes more than half of the relief's variance and crests
    have a straightness below 0.5; ripples, where the spacing is below 2 m; dunes apart from each other (40 %
    floor) are barchans or parabolic dunes where their horns point downwind or upwind; stars, where half of
    the summits have three arms or more; transverse or linear, by the angle of crests (or of slender single
    dunes) to the wind: 45 degrees and more, or less.
    """
    field = _Traits(np.asarray(elevation, float), cell_size, wind, periodic)
    for rule in (_flat, _young, _ripples, _horned, _star, _crested):
        if found := rule(field):
            return found
    return Landform("undetermined", f"crests without a common direction ({field.orientation.coherence:.2f})")


def half_spacing(spacing: float, cell_size: float, shape: tuple[int, ...]) -> float:
    """Half a spacing (m) in cells: 4 at least, where there is none too, and half of the field at most."""
    half = spacing / cell_size / 2
    return float(np.clip(half if math.isfinite(half) else 4.0, 4.0, max(min(shape) / 2, 4.0)))


@dataclass(frozen=True)
class _Traits:
    """What the rules ask for, each computed when one does."""

    elevation: Field
    cell_size: float
    given: float
    periodic: Periodic

    @cached_property
    def steepest(self) -> float:
        surface = smoothed(without_trend(self.elevation, self.periodic), 2.0, self.periodic)
        slope = np.hypot(*gradient(surface, self.cell_size, self.periodic))
        known = slope[np.isfinite(slope)]
        return math.degrees(math.atan(float(np.percentile(known, 99.5)))) if known.size else 0.0

    @cached_property
    def outlasting(self) -> float:
        """Share of the variance that smoothing over 2 cells leaves: 0.02 of white noise, 1 of wide forms."""
        surface = without_trend(self.elevation, self.periodic)
        return float(np.nanvar(smoothed(surface, 2.0, self.periodic)) / np.nanvar(surface))

    @cached_property
    def orientation(self) -> Orientation:
        return crest_orientation(self.elevation, self.cell_size, self.periodic)

    @cached_property
    def lee(self) -> LeeSide:
        return lee_side(self.elevation, self.cell_size, self.periodic)

    @property
    def wind(self) -> float:
        """The given wind, or the one that the lee sides show; NaN without either."""
        if not math.isnan(self.given):
            return self.given
        return self.lee.wind if self.lee.strength >= LOPSIDED else math.nan

    @cached_property
    def spacing(self) -> float:
        across = self.orientation.azimuth + 90.0
        return dominant_spacing(self.elevation, self.cell_size, across, self.periodic)

    @property
    def reach(self) -> float:
        """Half a spacing (cells), within the field."""
        return half_spacing(self.spacing, self.cell_size, self.elevation.shape)

    @cached_property
    def apart(self) -> bool:
        return floor_share(self.elevation, self.reach, self.periodic) >= APART

    @cached_property
    def dunes(self) -> list[DuneShape]:
        """Single dunes above the floor; without those that a void cuts, whose outlines are not theirs."""
        wind = 0.0 if math.isnan(self.wind) else self.wind
        found = dunes_on_floor(self.elevation, self.reach, self.periodic)
        cut = scipy.ndimage.binary_dilation(~np.isfinite(self.elevation), np.ones((3, 3), bool))
        rows, columns = self.elevation.shape
        whole = [dune for dune in found if not cut[dune.rows % rows, dune.columns % columns].any()]
        return [dune_shape(dune, wind, self.cell_size) for dune in whole]


def _flat(field: _Traits) -> Landform | None:
    reason = f"no slope above {field.steepest:.1f}°"
    return Landform("flat", reason) if field.steepest < FLAT else None


def _young(field: _Traits) -> Landform | None:
    if field.outlasting >= OUTLASTING or field.orientation.coherence >= PARALLEL:
        return None
    return Landform("young", f"{1 - field.outlasting:.0%} of the relief is roughness of a few cells")


def _ripples(field: _Traits) -> Landform | None:
    reason = f"a spacing of {field.spacing:.2g} m"
    return Landform("ripples", reason) if field.spacing < RIPPLES else None


def _horned(field: _Traits) -> Landform | None:
    if not field.apart or math.isnan(field.wind) or not field.dunes:
        return None
    area = np.array([dune.area for dune in field.dunes])
    pointing = np.radians([dune.horn_direction - field.wind - 180.0 for dune in field.dunes])
    horned = np.isfinite(pointing)
    if area[horned].sum() < HORNED * area.sum():
        return None
    along = float(np.average(np.cos(pointing[horned]), weights=area[horned]))
    if abs(along) < AGREEING:
        return None
    way = "downwind" if along > 0 else "upwind"
    reason = f"horns point {way} (mean cosine {along:+.2f}) on dunes apart from each other"
    return Landform("barchan" if along > 0 else "parabolic", reason)


def _star(field: _Traits) -> Landform | None:
    if field.orientation.coherence >= STRAIGHT:
        return None
    found = summits(without_trend(field.elevation, field.periodic), field.cell_size, field.periodic)
    armed = sum(summit.arms >= 3 for summit in found)
    if not found or armed < ARMED * len(found):
        return None
    return Landform("star", f"{armed} of {len(found)} summits have three arms or more")


def _crested(field: _Traits) -> Landform | None:
    azimuth = field.orientation.azimuth
    if field.orientation.coherence < STRAIGHT:
        slender = [dune for dune in field.dunes if dune.elongation >= SLENDER] if field.apart else []
        if not slender or len(slender) < len(field.dunes) / 2:
            return None
        double = np.exp(2j * np.radians([dune.orientation for dune in slender])).sum()
        azimuth = float(np.degrees(np.angle(double)) / 2)
    if math.isnan(field.wind):
        return Landform(
            "undetermined", "ridges about as steep to either side; the wind would tell their class"
        )
    x, y = downwind(field.wind)
    along = abs(x * math.sin(math.radians(azimuth)) + y * math.cos(math.radians(azimuth)))
    angle = math.degrees(math.acos(min(along, 1.0)))
    return Landform("transverse" if angle >= 45.0 else "linear", f"crests at {angle:.0f}° to the wind")
