"""The bed as a run finds it."""

from collections.abc import Sequence

import numpy as np

from barchan.bed import Bed
from barchan.errors import Problem, ScenarioError
from barchan.fields import SAND, LayerInfo
from barchan.ground.sand import MOST_SLABS, Sand
from barchan.ground.surface import Ground
from barchan.lattice import Lattice
from barchan.streams import Stream


def first_bed(
    lattice: Lattice, ground: Ground, sand: Sand, seed: int, layers: Sequence[LayerInfo] = (SAND,)
) -> Bed:
    """The ground and the layers on it before the first step, all units in the uppermost; rocks start bare.

    Raises ScenarioError with every problem found: files that do not fit, stacks too high to be counted.
    """
    elevation, slabs = np.zeros(lattice.shape), np.zeros(lattice.shape, np.int64)
    found: list[Problem] = []
    try:
        elevation = ground.elevation(lattice, Stream(seed, "ground"))
    except ScenarioError as error:
        found += error.problems
    try:
        slabs = sand.slabs(lattice, elevation, Stream(seed, "initial surface"))
    except ScenarioError as error:
        found += error.problems
    slabs[ground.bare(lattice)] = 0
    if slabs.max() > MOST_SLABS:
        found.append(Problem("sand", f"has stacks of up to {slabs.max()} slabs; allowed: up to {MOST_SLABS}"))
    if found:
        raise ScenarioError(found)
    below = [np.zeros(lattice.shape, np.int32) for _ in layers[1:]]
    return Bed(lattice, elevation, *below, slabs.astype(np.int32), layers=layers)
