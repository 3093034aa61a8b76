"""Two dates of one place: how far bedforms moved, and which volumes changed, with errors."""

import math
from dataclasses import dataclass
from functools import cached_property

from barchan.errors import SurveyError
from barchan.measures.change import Budget, Displacement, Estimate, budget, displacement_between
from barchan.survey.height_field import HeightField
from barchan.wind.clock import YEAR

BESIDE = 0.01
"""Part of a cell by which two frames may lie beside each other."""

CELLS_ALIKE = 1e-6
"""Part by which their cells may differ."""


@dataclass(frozen=True)
class Finding:
    """One result of a comparison."""

    name: str
    title: str
    value: float
    """NaN where there is none."""
    error: float
    """Standard error, in the same unit; NaN where none is known."""
    unit: str
    doubt: str = ""
    """Why it should not be quoted, or there is none; empty where all is well."""


@dataclass(frozen=True)
class Comparison:
    """Two surfaces of the same frame."""

    before: HeightField
    after: HeightField
    years: float
    """Time between them; NaN where unknown."""
    noise: float | None
    offset: float

    @cached_property
    def displacement(self) -> Displacement:
        """How far bedforms moved (cells)."""
        return displacement_between(self.before.heights, self.after.heights, self.before.periodic)

    @cached_property
    def budget(self) -> Budget:
        """Volumes that changed (m³)."""
        area = self.before.cell_size**2
        return budget(self.before.heights, self.after.heights, area, self.noise, self.offset)

    def findings(self) -> list[Finding]:
        """All results, in the order in which tables show them."""
        return [*self._motion(), *self._volumes()]

    def _motion(self) -> list[Finding]:
        moved, side = self.displacement, self.before.cell_size
        east, north = (Estimate(e.value * side, e.error * side) for e in (moved.east, moved.north))
        length, direction = _polar(east, north)
        doubt = self._doubt()
        found = [
            Finding("east", "migration eastwards", east.value, east.error, "m", doubt),
            Finding("north", "migration northwards", north.value, north.error, "m", doubt),
            Finding("migration", "migration", length.value, length.error, "m", doubt),
            Finding("direction", "migration towards", direction.value, direction.error, "degrees", doubt),
        ]
        if not math.isnan(self.years):
            speed, error = length.value / self.years, length.error / self.years
            found.append(Finding("speed", "migration per year", speed, error, "m/yr", doubt))
        windows = Finding("windows", "windows that agree", float(moved.windows), math.nan, "-")
        return [*found, Finding("correlation", "correlation", moved.correlation, math.nan, "-"), windows]

    def _doubt(self) -> str:
        moved = self.displacement
        if math.isnan(moved.correlation):
            return "no relief"
        if math.isnan(moved.east.value):
            return f"correlation {moved.correlation:.2f}: not the same bedforms"
        return "too few windows correlate for an error" if math.isnan(moved.east.error) else ""

    def _volumes(self) -> list[Finding]:
        found = self.budget
        volumes = [
            ("deposited", "volume deposited", found.deposited),
            ("eroded", "volume eroded", found.eroded),
            ("net", "net change of volume", found.net),
        ]
        per_offset = found.area * 0.01
        return [
            *(Finding(name, title, one.value, one.error, "m³") for name, title, one in volumes),
            Finding("area", "area compared", found.area, math.nan, "m²"),
            Finding("changed", "share that changed", found.certain_share, math.nan, "fraction"),
            Finding("noise", "noise of a cell's change", found.noise, math.nan, "m"),
            Finding("per_centimetre", "net change per cm of offset", per_offset, math.nan, "m³"),
        ]


def compare(
    before: HeightField,
    after: HeightField,
    *,
    years: float | None = None,
    noise: float | None = None,
    offset: float = 0.0,
) -> Comparison:
    """Compare two surfaces of the same cells at the same place.

    ``years`` is the time between them; two frames of a run with a clock know it. ``noise`` (m) is the
    standard deviation of the random error of a cell's change, estimated from the surfaces where it is not
    given; ``offset`` (m) the standard error of the level of one against the other. Raises SurveyError where
    frames differ.
    """
    wrong = [text for text in _differences(before, after) if text]
    if wrong:
        raise SurveyError(
            f"{before.name} and {after.name}: {'; '.join(wrong)}; allowed: the same cells at the same place, "
            "for instance by rio warp AFTER new.tif --like BEFORE --resampling bilinear"
        )
    for name, value, least in (
        ("--years", years, 0.0),
        ("--noise", noise, -1e-300),
        ("--offset", offset, -1e-300),
    ):
        if value is not None and not (math.isfinite(value) and value > least):
            raise SurveyError(f"{name} {value:g}; allowed: {'above 0' if not least else '0 or more'}")
    elapsed = (after.seconds - before.seconds) / YEAR if years is None else years
    return Comparison(before, after, elapsed if elapsed > 0 else math.nan, noise, offset)


def _differences(before: HeightField, after: HeightField) -> list[str]:
    """How the frames of two surfaces differ."""
    one, other = before.grid, after.grid
    if one.shape != other.shape:
        return [f"{one.columns} × {one.rows} and {other.columns} × {other.rows} cells"]
    side = before.cell_size
    sizes = abs(one.width / other.width - 1.0), abs(one.height / other.height - 1.0)
    apart = max(abs(one.west - other.west), abs(one.south - other.south))
    alike = one.wkt == other.wkt or one.crs == other.crs
    return [
        "" if max(sizes) <= CELLS_ALIKE else f"cells of {one.width:g} and {other.width:g} m",
        "" if apart <= BESIDE * side else f"corners {apart:g} m apart ({apart / side:.3g} cells)",
        "" if alike else f"in {one.crs or 'no reference system'} and {other.crs or 'no reference system'}",
        "" if one.periodic == other.periodic else "edges joined in one of them only",
    ]


def _polar(east: Estimate, north: Estimate) -> tuple[Estimate, Estimate]:
    """Length and direction (degrees clockwise from north) of a vector, with errors to first order."""
    length = math.hypot(east.value, north.value)
    if not length > 0.0:
        return Estimate(length, math.hypot(east.error, north.error)), Estimate(math.nan, math.nan)
    x, y = east.value / length, north.value / length
    along, across = math.hypot(x * east.error, y * north.error), math.hypot(y * east.error, x * north.error)
    direction = math.degrees(math.atan2(x, y)) % 360.0
    return Estimate(length, along), Estimate(direction, math.degrees(across / length))
