"""Single grains followed from lift-off to rest, for pictures: over a bed that stays as it is."""

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Bed
from barchan.grains.bed import room_for
from barchan.grains.pool import free_slots, grains_in
from barchan.streams import Stream, derive
from barchan.wind.segment import Segment

if TYPE_CHECKING:
    from barchan.grains.model import GrainModel

PATH_COLUMNS = 7
"""Columns of a path."""

_TRIES = 20
"""Cells drawn for a path at most before it is given up."""


def follow(
    model: "GrainModel", bed: Bed, wind: Segment, stream: Stream, count: int, longest: float = 10.0
) -> list[NDArray[np.float64]]:
    """The paths of ``count`` grains, each for ``longest`` seconds at most.

    The columns of a path are the place east and north (m; it grows on beyond joined edges), the height
    over the lowest ground (m), the velocity eastwards, northwards and upwards (m/s), and the bounces so
    far; its rows are a time step apart. Fewer come back where hardly a cell gives sand.
    """
    from barchan.kernels.grains.trajectories import trace

    about = _surroundings(model, bed, wind)
    path = np.zeros((max(2, round(longest / model.parameters.time_step)), PATH_COLUMNS))
    found: list[NDArray[np.float64]] = []
    for number in range(_TRIES * count):
        kinds = None if model.sizes is None else np.zeros(1, np.int32)
        grains = grains_in(*free_slots(1), kinds)
        places: int = trace(*(np.uint64(derive(stream.key, number)), grains, *about, path))
        if places:
            flight = path[:places].copy()
            flight[:, :2] = (flight[:, :2] + 0.5) * model.lattice.cell_size
            found.append(flight)
        if len(found) == count:
            break
    return found


def _surroundings(model: "GrainModel", bed: Bed, wind: Segment) -> Any:
    """Air, bed and rules as the kernel takes them; a lift-off is sure where the wind lifts at all."""
    ground = model.ground_of(bed, wind.direction, room_for(1, model.sizes is not None))
    ground.spread_lid()
    air = model.blow(ground, wind)
    lifts = model.lift_off(wind)
    surely = lifts._replace(chance=1.0 if lifts.chance > 0.0 else 0.0)
    rules = surely, (model.bounce(), model.lift_off(wind, 0.0))
    return air, ground.arrays, ground.scale, ground.grid, rules, model.splash(wind), ground.events
