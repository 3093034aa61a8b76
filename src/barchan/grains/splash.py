"""What grain size changes about splash, and how impacts push grains along the bed."""

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.directions import downwind
from barchan.grains.ripple_parameters import RipplesParameters
from barchan.kernels.grains.state import Creep, Sorting
from barchan.lattice import Lattice


def sorting(rules: RipplesParameters, creeps: NDArray[np.bool_]) -> Any:
    """Number and speed of ejecta by the size that hits (rows) and the one that is hit (columns).

    A parcel holds grains in proportion to 1 / d³, so (d_i / d_s) ejected grains for each that hits are
    (d_s / d_i)² parcels.
    """
    diameters = np.array([one.diameter for one in rules.classes])
    ratio = diameters / diameters[:, None]
    return Sorting(np.where(creeps, 0.0, ratio**2), np.minimum(ratio**-2, 1.0))


def creep(rules: RipplesParameters, lattice: Lattice, creeps: NDArray[np.bool_], direction: float) -> Any:
    """How sizes are pushed, in a wind from a direction (degrees).

    Those that ``creeps`` marks are too heavy to be thrown out, and take the momentum of ejecta as well.
    """
    diameters = np.array([one.diameter for one in rules.by_size])
    speed = rules.creep_speed * np.sqrt(rules.gravity * diameters)
    momentum = rules.creep_momentum + np.where(creeps, rules.ejecta_momentum, 0.0)
    return Creep(
        momentum / speed,
        speed**2 / (2.0 * rules.gravity * lattice.cell_size),
        np.array([one.impact_threshold() for one in rules.by_size]),
        math.tan(math.radians(rules.repose_angle)),
        *downwind(direction),
        max(rules.diameter, rules.carried * lattice.thickness),
    )
