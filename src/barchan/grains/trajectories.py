"""Single grains followed from lift-off to rest, for pictures: over a bed that stays as it is."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Bed
from barchan.grains.pool import Pool, work_space
from barchan.grains.rules import entrainment_of, rules_of
from barchan.streams import Stream, derive
from barchan.wind.segment import Segment

if TYPE_CHECKING:
    from barchan.grains.model import GrainModel

PATH_COLUMNS = 7
"""Columns of a path."""

_TRIES = 20
"""Random cells tried for a path at most."""


def follow(
    model: "GrainModel", bed: Bed, wind: Segment, stream: Stream, count: int, longest: float = 10.0
) -> list[NDArray[np.float64]]:
    """The paths of ``count`` grains, each for ``longest`` seconds at most.

    The columns of a path are the place east and north (m; it grows on beyond joined edges), the height
    over the lowest ground (m), the velocity eastwards, northwards and upwards (m/s), and the bounces so
    far; its rows are a time step apart. Fewer come back where hardly a cell gives sand.
    """
    from barchan.kernels.grains.trajectories import trace

    several_sizes = model.sized_sand is not None
    ground = model.ground_of(bed, wind.direction, work_space(1, several_sizes))
    ground.raise_shelter()
    air, setting = model.blow(ground, wind), model.setting(wind)
    rules, lifting = rules_of(setting, lifts=False), entrainment_of(setting, probability=1.0)
    path = np.zeros((max(2, round(longest / model.parameters.time_step)), PATH_COLUMNS))
    found: list[NDArray[np.float64]] = []
    for number in range(_TRIES * count):
        scene = model.scene(ground, air, rules, Pool(1, several_sizes))
        rows: int = trace(np.uint64(derive(stream.key, number)), scene, lifting, path)
        if rows:
            flight = path[:rows].copy()
            flight[:, :2] = (flight[:, :2] + 0.5) * model.lattice.cell_size
            found.append(flight)
        if len(found) == count:
            break
    return found
