"""The collapse of slopes above the angle of repose, as kernels take it."""

import math

import numpy as np

from barchan.grains.parameters import GrainFlight
from barchan.kernels.bed.state import Repose, settling_sequences
from barchan.kernels.grains.rules import Filter
from barchan.kernels.grains.state import Slopes
from barchan.lattice import Lattice


def repose_limits(angle: float, lattice: Lattice) -> tuple[int, int]:
    """Largest steps (parcels) that stand towards faces and corners; at least one."""
    slope = math.tan(math.radians(angle)) / lattice.aspect
    return max(1, math.floor(slope + 1e-9)), max(1, math.floor(math.sqrt(2.0) * slope + 1e-9))


def slopes_of(rules: GrainFlight, lattice: Lattice, parcel: int) -> Slopes:
    """Limits of slopes, for levels with ``parcel`` parts of a parcel."""
    face, corner = repose_limits(rules.repose_angle, lattice)
    repose = Repose(
        slab=parcel,
        face_limit=face * parcel,
        corner_limit=corner * parcel,
        corner_weight=math.sqrt(0.5),
        corners=True,
        random_order=False,
        firm_face_limit=face * parcel,
        firm_corner_limit=corner * parcel,
        firm_below=-1,
        release_face=0,
        release_corner=0,
    )
    queue, waiting = np.zeros(lattice.cells, np.int64), np.zeros(lattice.cells, np.uint8)
    return Slopes(repose, settling_sequences(True), queue, waiting)


def filter_of(rules: GrainFlight, lattice: Lattice, parcel: int) -> Filter:
    """The smoothing filter of Wang & Hu, for levels with ``parcel`` parts of a parcel."""
    least = math.tan(math.radians(rules.repose_angle)) / rules.filter_scale / lattice.aspect
    return Filter(rules.filter_gain, least * parcel)
