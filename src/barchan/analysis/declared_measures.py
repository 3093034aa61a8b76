"""The measures of a frame, each declared once: tables, series, the studio and the pages follow from here."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, Generic, TypeVar

from barchan.analysis import doubts
from barchan.analysis.measured_frame import MeasuredFrame
from barchan.measures.amounts import bare_fraction, flux, highest_stack
from barchan.models import ModelMeasure, models
from barchan.scenario import Scenario
from barchan.wind.clock import YEAR

Measured = TypeVar("Measured")
"""Something that has measures: a frame of a run, or any surface."""


@dataclass(frozen=True)
class Measure(Generic[Measured]):
    """A declared measure."""

    name: str
    title: str
    unit: str
    compute: Callable[[Measured], float]
    doubt: Callable[[Measured], str] = doubts.none
    """Why its value should not be quoted, or why there is none; empty where all is well."""
    reference: str = ""
    """What an angle is counted from."""
    row: str = ""
    """The measure that it is, in another unit; tables show both in one row."""

    def __repr__(self) -> str:
        return f"<Measure {self.name}: {self.title}{f' ({self.unit})' if self.unit != '-' else ''}>"

    def of(self, measured: Measured) -> "Value":
        """Its value for a frame or a surface."""
        return Value(self, float(self.compute(measured)), self.doubt(measured))


@dataclass(frozen=True)
class Value:
    """The value of a measure for one frame."""

    measure: Measure[Any]
    value: float
    """In the measure's unit; NaN where there is none."""
    doubt: str
    """Why it should not be quoted; empty where all is well."""


def _ratio(value: float, over: float) -> float:
    return value / over if over else math.nan


def _towards(frame: MeasuredFrame) -> float:
    """Direction (degrees) that bedforms move towards; NaN where they stand still."""
    x, y = frame.migration.x, frame.migration.y
    return math.degrees(math.atan2(x, y)) % 360.0 if math.hypot(x, y) > 0.0 else math.nan


def _flux(frame: MeasuredFrame) -> float:
    lattice = frame.scenario.lattice
    travel = math.hypot(*frame.travel)
    return flux(travel, lattice.cells, frame.steps, frame.unit_height, lattice.cell_size)


def _per_year(frame: MeasuredFrame, per_step: float) -> float:
    return per_step * YEAR / (frame.scenario.step_seconds or math.nan)


SLABS = "slabs"
"""Unit of measures that count whole units of the layers, by whatever name a scenario's layers call them."""

FROM_NORTH = "clockwise from north"

MEASURES: tuple[Measure[MeasuredFrame], ...] = (
    Measure("highest", "highest stack", "m", lambda m: float(m.bed.depth.max())),
    Measure("highest_stack", "highest stack", SLABS, lambda m: highest_stack(m.bed.stack), row="highest"),
    Measure("bare_fraction", "bare ground", "fraction", lambda m: bare_fraction(m.bed.stack)),
    Measure("spacing", "dominant spacing", "m", lambda m: m.spacing, doubts.of_spacing),
    Measure("dune_height", "height, crest to toe", "m", lambda m: m.dune_height, doubts.of_height),
    Measure("bedform_height", "bedform height", "m", lambda m: m.bedform_height, doubts.of_relief),
    Measure(
        "bedform_index",
        "bedform index",
        "-",
        lambda m: _ratio(m.spacing, m.bedform_height),
        doubts.of_spacing,
    ),
    Measure(
        "crest_azimuth",
        "crest orientation",
        "degrees",
        lambda m: m.orientation.azimuth,
        doubts.of_azimuth,
        FROM_NORTH,
    ),
    Measure("straightness", "crest straightness", "-", lambda m: m.orientation.coherence, doubts.of_relief),
    Measure("speed", "migration downwind", "m/step", lambda m: m.speed * m.cell_size, doubts.of_migration),
    Measure(
        "speed_cells", "migration downwind", "cells/step", lambda m: m.speed, doubts.of_migration, row="speed"
    ),
    Measure(
        "migration_direction",
        "migration towards",
        "degrees",
        _towards,
        doubts.of_migration,
        FROM_NORTH,
    ),
    Measure("windward_slope", "windward slope", "degrees", lambda m: m.slopes.windward, doubts.of_flanks),
    Measure("lee_slope", "lee slope", "degrees", lambda m: m.slopes.lee, doubts.of_flanks),
    Measure(
        "slip_face_angle", "slip-face angle", "degrees", lambda m: m.slip_face_angle, doubts.of_slip_faces
    ),
    Measure(
        "resultant_wind",
        "resultant wind from",
        "degrees",
        lambda m: m.resultant,
        doubts.of_resultant,
        FROM_NORTH,
    ),
    Measure("flux", "net flux", "m²/step", _flux, doubts.of_flux),
    Measure("volume", "volume", "m³", lambda m: m.bed.volume),
)
"""Every measure of any frame, in the order in which tables show them."""

PER_YEAR: tuple[Measure[MeasuredFrame], ...] = (
    Measure(
        "speed_per_year",
        "migration downwind",
        "m/yr",
        lambda m: _per_year(m, m.speed * m.cell_size),
        doubts.of_migration,
        row="speed",
    ),
    Measure(
        "flux_per_year", "net flux", "m²/yr", lambda m: _per_year(m, _flux(m)), doubts.of_flux, row="flux"
    ),
)
"""Measures of a frame whose steps have a duration."""


def measures_of(scenario: Scenario) -> tuple[Measure[MeasuredFrame], ...]:
    """Every measure of a scenario's frames: those of any frame, by year too, and its model's own."""
    timed = () if scenario.step_seconds is None else PER_YEAR
    unit = scenario.layers[-1].unit
    common = (replace(m, unit=unit) if m.unit == SLABS else m for m in MEASURES)
    return (*common, *timed, *map(_own, models()[scenario.model.name].measures))


def in_rows(values: list[Value]) -> list[list[Value]]:
    """Values of measures, those of one measure in several units together, in order."""
    rows: dict[str, list[Value]] = {}
    for value in values:
        rows.setdefault(value.measure.row or value.measure.name, []).append(value)
    return list(rows.values())


def _own(own: ModelMeasure) -> Measure[MeasuredFrame]:
    return Measure(own.name, own.title, own.unit, lambda m: m.of_model(own))
