"""The measures of any surface, each declared once, with what speaks against quoting it."""

import math

import numpy as np

from barchan.analysis.declared_measures import FROM_NORTH, Measure
from barchan.measures.crest_lines import crest_length, defect_density, mean_direction
from barchan.measures.floor import floor_share
from barchan.measures.roughness import frontal_area_index, roughness
from barchan.survey.measuring import STRAIGHT, Survey

CELLS = 6.0
"""Bedforms closer than this number of cells are not resolved; ours."""

BEDFORMS = 3.0
"""Fewer bedforms than this in the field are no train of them; ours."""

ROUGH = 3.0
"""Multiple of the roughness that bedforms are higher than; ours."""


def _relief(survey: Survey) -> str:
    if not survey.bedform_height > 0.0:
        return "no relief"
    return "" if survey.bedform_height > ROUGH * survey.grit else "the relief is roughness from cell to cell"


def _spacing(survey: Survey) -> str:
    if reason := _relief(survey):
        return reason
    cells = survey.spacing / survey.cell_size
    if math.isnan(cells):
        return "no relief across the crests"
    if cells < CELLS:
        return f"a spacing of {cells:.1f} cells is not resolved"
    angle = math.radians(survey.across)
    rows, columns = survey.heights.shape
    count = (abs(math.cos(angle)) * rows + abs(math.sin(angle)) * columns) / cells
    return f"only {count:.1f} bedforms in the field" if count < BEDFORMS else ""


def _azimuth(survey: Survey) -> str:
    straightness = survey.orientation.coherence
    common = "" if straightness >= STRAIGHT else f"no common direction (straightness {straightness:.2f})"
    return _relief(survey) or common


def _crests(survey: Survey) -> str:
    return _relief(survey) or ("" if survey.crests else "no crest line")


def _flanks(survey: Survey) -> str:
    if reason := _relief(survey):
        return reason
    return "no wind is stated, and neither side is steeper" if math.isnan(survey.wind) else ""


def _wind(survey: Survey) -> str:
    stated = not (math.isnan(survey.given) and math.isnan(survey.field.wind))
    return "" if stated else "by the steeper side; state it with --wind"


def _dunes(survey: Survey) -> str:
    return "" if survey.dunes else "no single dune: ridges go on over the edges"


def _median(survey: Survey, name: str) -> float:
    values = [getattr(shape, name) for _, shape in survey.dunes]
    return float(np.median(values)) if values else math.nan


def _crest_density(survey: Survey) -> float:
    known = int(np.isfinite(survey.heights).sum())
    return crest_length(survey.crests) / known / survey.cell_size


SURFACE_MEASURES: tuple[Measure[Survey], ...] = (
    Measure("relief", "lowest to highest", "m", lambda s: float(np.nanmax(s.heights) - np.nanmin(s.heights))),
    Measure("spacing", "dominant spacing", "m", lambda s: s.spacing, _spacing),
    Measure("crest_spacing", "spacing, crest by crest", "m", lambda s: s.crest_spacing.mean, _spacing),
    Measure("crest_spacing_spread", "its spread", "m", lambda s: s.crest_spacing.spread, _spacing),
    Measure("dune_height", "height, crest to toe", "m", lambda s: s.dune_height, _relief),
    Measure("bedform_height", "bedform height", "m", lambda s: s.bedform_height, _relief),
    Measure(
        "bedform_index",
        "bedform index",
        "-",
        lambda s: s.spacing / s.bedform_height if s.bedform_height else math.nan,
        _spacing,
    ),
    Measure(
        "crest_azimuth", "crest orientation", "degrees", lambda s: s.orientation.azimuth, _azimuth, FROM_NORTH
    ),
    Measure("straightness", "crest straightness", "-", lambda s: s.orientation.coherence, _relief),
    Measure(
        "orientation_spread", "spread of crests", "degrees", lambda s: mean_direction(s.crests)[1], _crests
    ),
    Measure("crest_density", "crest per area", "1/m", _crest_density, _crests),
    Measure(
        "defect_density",
        "ends per crest length",
        "1/m",
        lambda s: defect_density(s.crests, s.cell_size),
        _crests,
    ),
    Measure("wind", "wind from", "degrees", lambda s: s.wind, _wind, FROM_NORTH),
    Measure("lee_strength", "one-sidedness", "-", lambda s: s.lee.strength, _relief),
    Measure("windward_slope", "windward slope", "degrees", lambda s: s.slopes.windward, _flanks),
    Measure("lee_slope", "lee slope", "degrees", lambda s: s.slopes.lee, _flanks),
    Measure("slip_face_angle", "slip-face angle", "degrees", lambda s: s.slip_face_angle, _flanks),
    Measure(
        "frontal_area_index",
        "frontal area per ground",
        "-",
        lambda s: frontal_area_index(s.heights, s.cell_size, s.across, s.periodic),
        _flanks,
    ),
    Measure(
        "floor_share",
        "floor between bedforms",
        "fraction",
        lambda s: floor_share(s.heights, s.reach, s.periodic),
    ),
    Measure("roughness", "roughness below 12 cells", "m", lambda s: roughness(s.heights, s.periodic)),
    Measure("dunes", "single dunes", "-", lambda s: len(s.dunes), _dunes),
    Measure("median_dune_height", "their median height", "m", lambda s: _median(s, "height"), _dunes),
    Measure("median_dune_width", "their median width", "m", lambda s: _median(s, "width"), _dunes),
    Measure("median_dune_length", "their median length", "m", lambda s: _median(s, "length"), _dunes),
    Measure("median_dune_volume", "their median volume", "m³", lambda s: _median(s, "volume"), _dunes),
    Measure("median_asymmetry", "their median asymmetry", "-", lambda s: _median(s, "asymmetry"), _dunes),
)
"""Every measure of a surface, in the order in which tables show them."""
