"""The collapse of slopes above the angle of repose, as kernels take it."""

import math

from barchan.grains.parameters import GrainFlight
from barchan.heights import LARGEST_STEP
from barchan.kernels.bed.state import relaxation_orders, repose_rule, unstable_cells
from barchan.kernels.grains.rules import Filter
from barchan.kernels.grains.state import Slopes
from barchan.lattice import Lattice


def repose_limits(angle: float, lattice: Lattice) -> tuple[int, int]:
    """Largest steps (parcels) that stand towards faces and corners; at least one."""
    slope = math.tan(math.radians(angle)) / lattice.aspect
    face, corner = (math.floor(min(s + 1e-9, LARGEST_STEP)) for s in (slope, math.sqrt(2.0) * slope))
    return max(1, face), max(1, corner)


def slopes_of(rules: GrainFlight, lattice: Lattice, parcel: int) -> Slopes:
    """Limits of slopes, for levels with ``parcel`` parts of a parcel."""
    repose = repose_rule(parcel, repose_limits(rules.repose_angle, lattice))
    return Slopes(repose, relaxation_orders(True), unstable_cells(lattice.cells))


def filter_of(rules: GrainFlight, lattice: Lattice, parcel: int) -> Filter:
    """The smoothing filter of Wang & Hu, for levels with ``parcel`` parts of a parcel."""
    least = math.tan(math.radians(rules.repose_angle)) / rules.filter_scale / lattice.aspect
    return Filter(rules.filter_gain, least * parcel)
