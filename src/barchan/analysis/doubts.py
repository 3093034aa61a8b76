"""Why a measure of a frame should not be quoted: reasons for people to read, empty where there is none."""

import math

import numpy as np

from barchan.analysis.measured_frame import STRAIGHT, MeasuredFrame
from barchan.measures.bedform_surface import is_level, is_steep
from barchan.measures.migration import LEAST_CORRELATION

SLABS = 2.0
"""Bedforms lower than this number of slabs are roughness; ours."""

ROUNDING = 1e-6
"""Relief below this number of slabs is rounding."""

CELLS = 6.0
"""Bedforms closer than this number of cells are shaped by the lattice; ours."""

BEDFORMS = 3.0
"""Fewer bedforms than this in the field are no train of them; ours."""

RELIEF = 3.0
"""Relief of the ground over the height of the bedforms beyond which its remains count; ours."""

FACE = 4.0
"""Slip faces shorter than this number of cells are rounded by the smoothing; ours."""

STEP = 0.4
"""Share of a spacing from frame to frame beyond which a crest may be taken for its neighbour; ours."""


def none(_measured: object) -> str:
    """No reason."""
    return ""


def of_relief(frame: MeasuredFrame) -> str:
    """Of any measure of the bedforms' shape."""
    slabs = frame.bedform_height / frame.unit_height
    if not slabs > ROUNDING:
        return "no relief"
    if slabs < SLABS:
        return f"relief of {slabs:.1f} {frame.bed.layers[-1].unit} is roughness"
    ground, sandy = frame.bed.ground, frame.bed.stack > 0
    if not is_level(ground) and sandy.any():
        relief = 2.0 * math.sqrt(2.0) * float(ground[sandy].std())
        if relief > RELIEF * frame.bedform_height:
            return f"the ground's relief is {relief / frame.bedform_height:.0f} times the bedforms' height"
    return ""


def of_spacing(frame: MeasuredFrame) -> str:
    """Of the spacing and what is computed from it."""
    if reason := of_relief(frame):
        return reason
    if math.isnan(frame.spacing):
        return "no relief across the crests"
    cells = frame.spacing / frame.cell_size
    if cells < CELLS:
        return f"a spacing of {cells:.1f} cells is shaped by the lattice"
    count = _extent(frame) / cells
    return f"only {count:.1f} bedforms in the field" if count < BEDFORMS else ""


def of_azimuth(frame: MeasuredFrame) -> str:
    """Of the direction of the crests."""
    straightness = frame.orientation.coherence
    common = "" if straightness >= STRAIGHT else f"no common direction (straightness {straightness:.2f})"
    return of_relief(frame) or common


def of_flanks(frame: MeasuredFrame) -> str:
    """Of measures that tell the windward from the lee side."""
    return of_relief(frame) or _of_sides(frame)


def of_slip_faces(frame: MeasuredFrame) -> str:
    """Of the angle of slip faces."""
    if reason := of_flanks(frame):
        return reason
    angle, height = frame.slip_face_angle, frame.dune_height
    if math.isnan(angle):
        return "nothing falls to the lee"
    cells = height / math.tan(math.radians(angle)) / frame.cell_size
    return f"faces of {cells:.1f} cells are rounded by the smoothing" if cells < FACE else ""


def of_height(frame: MeasuredFrame) -> str:
    """Of the height from crest to toe."""
    return of_relief(frame) or ("no whole bedform" if math.isnan(frame.dune_height) else "")


def of_migration(frame: MeasuredFrame) -> str:
    """Of migration."""
    if frame.standing:
        return frame.standing
    correlation = frame.migration.correlation
    if math.isnan(correlation):
        return "no relief"
    if math.isnan(frame.migration.x):
        return f"correlation {correlation:.2f} is below {LEAST_CORRELATION:g}: not the same bedforms"
    moved = frame.migration.speed * frame.span * frame.cell_size
    if moved > STEP * frame.spacing and frame.span == frame.steps:
        return f"bedforms moved {moved / frame.spacing:.1f} spacings between frames; save frames more often"
    rocky = np.isnan(frame.surface).any() or is_steep(frame.bed.ground, frame.cell_size)
    held = "sand that rocks or steep ground hold stands still and counts" if rocky else ""
    return of_relief(frame) or held or _of_wind(frame)


def of_flux(frame: MeasuredFrame) -> str:
    """Of flux."""
    return "" if frame.steps else "no earlier frame"


def of_resultant(frame: MeasuredFrame) -> str:
    """Of the direction of the resultant wind."""
    return "the winds cancel, or none moves sand" if math.isnan(frame.resultant) else ""


def _of_sides(frame: MeasuredFrame) -> str:
    apart = math.cos(math.radians(frame.across - frame.upwind))
    along = "" if apart > math.sin(math.radians(20.0)) else "crests lie along the wind: no lee side"
    return along or _of_wind(frame)


def _of_wind(frame: MeasuredFrame) -> str:
    cancels = math.isnan(frame.resultant) and frame.wind == "resultant"
    return "the winds cancel: the last one is taken" if cancels else ""


def _extent(frame: MeasuredFrame) -> float:
    """How far the field reaches across the crests (cells)."""
    angle = math.radians(frame.across)
    rows, columns = frame.surface.shape
    return float(np.abs(np.array([math.cos(angle) * rows, math.sin(angle) * columns])).sum())
