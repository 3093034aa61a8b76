"""Paths of grains over a frame's bed, computed again on request, and the hops of each path."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.analysis.fields import as_modelled
from barchan.bed import Bed
from barchan.errors import BarchanError
from barchan.grains.model import GrainModel
from barchan.models import Model
from barchan.scenario import Scenario
from barchan.streams import Stream
from barchan.wind.segment import Segment

if TYPE_CHECKING:
    import xarray as xr

BOUNCES = 6
"""The column of a path that counts bounces; see ``GrainModel.paths``."""


def follows_grains(model: Model) -> bool:
    """Whether a model follows grains through the air."""
    return isinstance(model, GrainModel)


def paths_over(model: Model, bed: Bed, wind: Segment, seed: int, count: int) -> list[NDArray[np.float64]]:
    """Paths of up to ``count`` grains that the wind lifts from a bed; none of a model that follows none.

    The run's ``seed`` starts their random numbers; bed and model stay as they are. See
    ``GrainModel.paths`` for the columns.
    """
    return model.paths(bed, wind, Stream(seed, "paths"), count) if isinstance(model, GrainModel) else []


def grain_paths(frame: "xr.Dataset", scenario: Scenario, count: int) -> list[NDArray[np.float64]]:
    """Paths of ``count`` grains that the wind lifts from a frame's bed, which stays as it is.

    See ``GrainModel.paths`` for the columns. Raises BarchanError where the model follows no grains or where
    none is lifted.
    """
    model, bed, wind = as_modelled(frame, scenario)
    if not follows_grains(model):
        raise BarchanError(f"model '{model.name}' follows no grains; paths are those of grain models")
    found = paths_over(model, bed, wind, scenario.seed, count)
    if not found:
        raise BarchanError("no grain is lifted: the wind is below the threshold, or no cell gives sand")
    return found


def broken_at_edges(path: NDArray[np.float64], width: float, depth: float) -> NDArray[np.float64]:
    """A path (x, y, z in m) brought back into the field, with a gap (NaN) wherever it crosses an edge."""
    inside = path[:, :3].copy()
    laps = np.floor(inside[:, :2] / (width, depth))
    inside[:, :2] -= laps * (width, depth)
    jumps = np.flatnonzero((np.diff(laps, axis=0) != 0).any(axis=1)) + 1
    return np.insert(inside, jumps, np.nan, axis=0)


def hops_of(path: NDArray[np.float64]) -> NDArray[np.float64]:
    """The complete hops of a path: length (m), height (m) and impact angle (degrees), a row each.

    A hop's last place lies up to a time step before the impact; its velocity stands for that of the impact.
    """
    rows = []
    for number in range(int(path[-1, BOUNCES]) + 1):
        hop = path[path[:, BOUNCES] == number]
        if len(hop) < 2:
            continue
        length = float(np.hypot(*(hop[-1, :2] - hop[0, :2])))
        height = float(hop[:, 2].max() - min(hop[0, 2], hop[-1, 2]))
        angle = float(np.degrees(np.arctan2(-hop[-1, 5], np.hypot(*hop[-1, 3:5]))))
        rows.append((length, height, angle))
    return np.array(rows).reshape(-1, 3)
