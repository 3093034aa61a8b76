"""The bed as a run finds it."""

from collections.abc import Sequence

import numpy as np

from barchan.bed import Bed
from barchan.errors import Problem, ScenarioError
from barchan.fields import SAND, LayerInfo
from barchan.ground.reference import system_of
from barchan.ground.sand import MOST_SLABS, FileSand, Sand
from barchan.ground.surface import FileGround, Ground
from barchan.lattice import Lattice
from barchan.streams import Stream


def first_bed(
    lattice: Lattice,
    ground: Ground,
    sand: Sand,
    seed: int,
    layers: Sequence[LayerInfo] = (SAND,),
    *,
    unit_height: float | None = None,
    beneath: float = 0.0,
) -> Bed:
    """The ground and the layers on it before the first step, all units in the uppermost; rocks start bare.

    ``unit_height`` (m) is the height of a unit, where it is not a slab of the lattice; ``beneath`` (m) is the
    thickness of what the model lays under these units.

    Raises ScenarioError with every problem found: files that do not fit, stacks too high to be counted.
    """
    elevation, slabs = np.zeros(lattice.shape), np.zeros(lattice.shape, np.int64)
    found: list[Problem] = []
    try:
        elevation = ground.elevation(lattice, Stream(seed, "ground"))
    except ScenarioError as error:
        found += error.problems
    try:
        counted = lattice
        if unit_height is not None:
            counted = lattice.model_copy(update={"slab_aspect": None, "slab_height": unit_height})
        slabs = sand.slabs(counted, elevation + beneath, Stream(seed, "initial surface"))
    except ScenarioError as error:
        found += error.problems
    if not found:
        found += _misplaced(lattice, ground, sand)
    slabs[ground.bare(lattice)] = 0
    if slabs.max() > MOST_SLABS:
        found.append(Problem("sand", f"has stacks of up to {slabs.max()} slabs; allowed: up to {MOST_SLABS}"))
    if found:
        raise ScenarioError(found)
    below = [np.zeros(lattice.shape, np.int32) for _ in layers[1:]]
    return Bed(lattice, elevation, *below, slabs.astype(np.int32), layers=layers)


def _misplaced(lattice: Lattice, ground: Ground, sand: Sand) -> list[Problem]:
    """A problem where files of ground and sand have coordinates and do not begin at the same corner."""
    if not isinstance(ground, FileGround) or not isinstance(sand, FileSand):
        return []
    below, above = ground.outline().place, sand.outline().place
    if below is None or above is None:
        return []
    east, north = above.west - below.west, above.south - below.south
    same = above.crs is None or below.crs is None or above.crs == below.crs
    if max(abs(east), abs(north)) < lattice.cell_size / 2 and same:
        return []
    text = (
        f"'{sand.path}': begins {east:g} m east and {north:g} m north of the ground's file, "
        f"{system_of(above)} against {system_of(below)}; allowed: the same south-west corner and system"
    )
    return [Problem("sand.path", text)]
