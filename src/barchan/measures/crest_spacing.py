"""How far crests stand apart, counted one by one."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from barchan.directions import downwind
from barchan.measures.crest_to_toe import profiles
from barchan.measures.filters import Field, Periodic, smoothed, without_trend

PROMINENCE = 0.25
"""Share of the height of the surface's bedforms by which a crest rises above the troughs beside it; ours."""


@dataclass(frozen=True)
class CrestSpacing:
    """Distances (m) from one crest to the next along the wind; NaN where no two crests follow each other."""

    mean: float
    spread: float
    """Standard deviation from gap to gap."""
    count: int
    """Gaps between crests that were measured, on all profiles."""

    def __repr__(self) -> str:
        return f"<CrestSpacing {self.mean:.3g} ± {self.spread:.2g} m, {self.count} gaps>"


def crest_spacing(
    elevation: NDArray,
    cell_size: float,
    direction: float,
    periodic: Periodic = (True, True),
    width: float = 1.0,
) -> CrestSpacing:
    """Mean distance from crest to crest along profiles in a wind from ``direction`` (degrees), a cell apart.

    The surface is that of ``dominant_spacing``. A crest is a highest point of a profile that rises above the
    hollows to both sides by a quarter of the height of waves with the surface's standard deviation. Gaps that
    meet cells of NaN or an open edge are left out.
    """
    surface = smoothed(without_trend(elevation, periodic), width, periodic)
    known = np.isfinite(surface)
    rounding = 1e-9 * max(1.0, float(np.abs(np.asarray(elevation, float)[known]).max(initial=0.0)))
    height = float(2 * np.sqrt(2) * surface.std(where=known)) if known.any() else 0.0
    if not height > rounding:
        return CrestSpacing(float("nan"), float("nan"), 0)
    lines = profiles(surface, direction, periodic)
    x, y = downwind(direction)
    extent = round(abs(x) * surface.shape[1] + abs(y) * surface.shape[0])
    gaps = _gaps(lines, PROMINENCE * height, extent)
    if not gaps.size:
        return CrestSpacing(float("nan"), float("nan"), 0)
    return CrestSpacing(float(gaps.mean()) * cell_size, float(gaps.std()) * cell_size, int(gaps.size))


def _gaps(lines: Field, prominence: float, extent: int) -> Field:
    """Distances (cells) between neighbouring crests of each line, none of them over a void.

    Gaps that begin within the ``extent`` (cells) of the field count: over joined edges lines go through it
    twice.
    """
    flat = np.pad(lines, ((0, 0), (0, 1)), constant_values=np.nan).ravel()
    gone = np.isnan(flat)
    sunk = np.where(gone, np.nanmin(lines) - prominence if not gone.all() else 0.0, flat)
    from scipy.signal import find_peaks  # takes a second to load, which a first picture does without

    peaks, _ = find_peaks(sunk, prominence=prominence)
    peaks = peaks[~(gone[peaks - 1] | gone[peaks + 1])]
    if len(peaks) < 2:
        return np.zeros(0)
    voids = np.cumsum(gone)
    whole = (voids[peaks[1:]] == voids[peaks[:-1]]) & (peaks[:-1] % (lines.shape[1] + 1) < extent)
    return np.diff(_refined(sunk, peaks))[whole]


def _refined(line: Field, peaks: NDArray[np.intp]) -> Field:
    """Places of peaks to a fraction of a cell, by parabolas through their neighbours."""
    left, middle, right = (line[peaks + step] for step in (-1, 0, 1))
    bend = left - 2 * middle + right
    return peaks + np.clip(
        np.where(bend < 0, 0.5 * (left - right) / np.where(bend < 0, bend, 1.0), 0.0), -0.5, 0.5
    )
