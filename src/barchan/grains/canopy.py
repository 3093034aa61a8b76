"""Plants in the wind of grains: where they stand, how high, and what they take from the wind."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.mesh import over_mesh
from barchan.bed import Bed
from barchan.fields import FieldInfo
from barchan.ground.area import Area
from barchan.lattice import Lattice
from barchan.model import Derived, Overlay
from barchan.parameters import parameter

if TYPE_CHECKING:
    from barchan.grains.parameters import GrainFlight

TALLEST = 5.0
"""Height (m) of plants at most: their roughness and displacement stay below 10 m, where winds are stated."""

PAINTED = 1.0
"""Height (m) that a brush can give plants, where no stand is taller."""


class Stand(Area):
    """A rectangle of the field with plants of one height, its edges given as fractions of the field."""

    height: float = parameter(
        unit="m",
        ge=0,
        le=TALLEST,
        meaning="Height of the plants; 0: none yet, they may be painted.",
        source="Allen et al. 1998 (FAO-56): grass of 0.12 m",
    )


PLANT_HEIGHT = FieldInfo("plant_height", "float64", "m", "height of plants")


def _share(_model: Any, bed: Bed, _wind: Any) -> NDArray[np.float64]:
    height = bed.arrays[PLANT_HEIGHT.name]
    return np.asarray(height / max(float(height.max()), 1e-12))


PLANT_SHARE = Derived("plant_share", "1", "height of plants over that of the tallest", _share)

PLANTS = Overlay(PLANT_SHARE.name, "plants, over the tallest", "Greens")


def planted(stands: Sequence[Stand], lattice: Lattice) -> NDArray[np.float64]:
    """Height (m) of plants on each cell; where stands overlap, that of the last one."""
    height = np.zeros(lattice.shape)
    for stand in stands:
        height[stand.where(lattice)] = stand.height
    return height


class Hold(NamedTuple):
    """What plants do to the wind over each mesh cell: flat arrays."""

    lift: NDArray[np.float32]
    """Height (m) by which they lift its profile, over the displacement of the field."""
    logarithm: NDArray[np.float64]
    """What they take from its speed, over friction velocity / 0.4: the logarithm of their roughness over
    that of the field."""


def hold(rules: "GrainFlight", height: NDArray[np.float64], lattice: Lattice) -> Hold:
    """What plants of a ``height`` (m) on each cell do to the wind."""
    mean = over_mesh(height, lattice.periodic).reshape(-1)
    lift = np.maximum(rules.plant_displacement * mean - rules.displacement, 0.0)
    rough = np.maximum(rules.plant_roughness * mean / rules.roughness_length, 1.0)
    return Hold(lift.astype(np.float32), np.log(rough))
