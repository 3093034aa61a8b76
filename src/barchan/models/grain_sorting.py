"""What grain size changes about splash, and how sizes too heavy to fly creep."""

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Lattice
from barchan.models.ripple_parameters import RipplesParameters


def sorting(rules: RipplesParameters, lattice: Lattice, creeps: NDArray[np.bool_]) -> Any:
    """Number and speed of ejecta by the size that hits (rows) and the one that is hit (columns).

    A parcel holds grains in proportion to 1 / d³, so (d_i / d_s) ejected grains for each that hits are
    (d_s / d_i)² parcels.
    """
    from barchan.kernels.grain_splash import Sorting

    diameters = np.array([one.diameter for one in rules.classes])
    ratio = diameters / diameters[:, None]
    creep = _creep(rules, lattice, diameters, creeps) if creeps.any() else None
    return Sorting(np.where(creeps, 0.0, ratio**2), np.minimum(ratio**-2, 1.0), creep)


def _creep(
    rules: RipplesParameters, lattice: Lattice, diameters: NDArray[np.float64], creeps: NDArray[np.bool_]
) -> Any:
    """How sizes are pushed: by as much momentum as takes a grain over its step against friction.

    Sand moves by whole cells, so there are fewer pushes than steps, by as much as a step is shorter.
    """
    from barchan.kernels.grain_creep import Creep

    friction = math.tan(math.radians(rules.repose_angle))
    step = np.minimum(rules.creep_step * diameters, lattice.cell_size)
    speed = np.sqrt(2.0 * friction * rules.gravity * step)
    number = rules.creep_momentum / speed * step / lattice.cell_size
    return Creep(np.where(creeps, number, 0.0), friction)
