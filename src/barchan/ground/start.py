"""The bed as a run finds it."""

import numpy as np

from barchan.bed import Bed, Lattice
from barchan.errors import Problem, ScenarioError
from barchan.ground.sand import MOST_SLABS, Sand
from barchan.ground.surface import Ground
from barchan.streams import Stream


def first_bed(lattice: Lattice, ground: Ground, sand: Sand, seed: int) -> Bed:
    """The ground and the sand on it before the first step; rocks start bare.

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
    return Bed(lattice, elevation, slabs.astype(np.int32))
