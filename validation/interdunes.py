"""Small bumps between dunes, with and without erosion in shadow.

Preset `barchans` (1000 steps) with the switch either way. The Prague thesis (§6.1) blames the bumps on
erosion in shadow. A bump is a patch of sand (cells that touch by faces) of fewer than 30 cells on otherwise
bare ground.
"""

import numpy as np
from scipy.ndimage import label

import barchan
from validation.study import order, over_seeds

TITLE = "Bumps between dunes"

SMALL = 30


def bumps(lee_erosion, seed):
    simulation = barchan.Simulation(barchan.load("barchans", run__seed=seed, model__lee_erosion=lee_erosion))
    simulation.advance(1000)
    patches, _ = label(simulation.bed.sand > 0)
    sizes = np.bincount(patches.ravel())[1:]
    bare = float(np.mean(simulation.bed.sand == 0))
    count = float(np.sum(sizes < SMALL))
    return {"per bare": 1000 * count / (bare * patches.size), "bare": bare}


def rows():
    allowed, forbidden = over_seeds(bumps, [(True,), (False,)])
    what = "bumps, erosion in shadow allowed against forbidden"
    unit = "per 1000 bare cells"
    yield order(what, "more", allowed["per bare"], forbidden["per bare"], unit)
    what = "bare ground, forbidden against allowed"
    yield order(what, "more even ground between dunes", forbidden["bare"], allowed["bare"])


READING = """
Erosion in shadow makes the bumps, as the Prague thesis supposes; without it most of the field is swept bare.
"""
