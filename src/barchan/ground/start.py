"""The bed as a run finds it."""

import numpy as np

from barchan.bed import Bed, Lattice
from barchan.errors import Problem, ScenarioError
from barchan.ground.sand import MOST_SLABS, Sand
from barchan.ground.surface import Ground
from barchan.streams import Stream


def first_bed(lattice: Lattice, ground: Ground, sand: Sand, seed: int) -> Bed:
    """The ground and the sand on it before the first step; rocks start bare.

    Raises ScenarioError where a file does not fit, or stacks would be too high to be counted.
    """
    elevation = ground.elevation(lattice, Stream(seed, "ground"))
    slabs = sand.slabs(lattice, elevation, Stream(seed, "initial surface"))
    slabs[ground.bare(lattice)] = 0
    if slabs.max() > MOST_SLABS:
        message = f"has stacks of up to {slabs.max()} slabs; allowed: up to {MOST_SLABS}"
        raise ScenarioError([Problem("sand", message)])
    return Bed(lattice, elevation, slabs.astype(np.int32))
