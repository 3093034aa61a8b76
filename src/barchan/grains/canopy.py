"""Canopy: plants in the wind of grains, where they stand, how high, and how they roughen the wind."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.mesh import over_mesh
from barchan.aeolian.wall import KARMAN
from barchan.bed import Bed
from barchan.fields import FieldInfo
from barchan.grains.closure import Closure
from barchan.ground.area import Area
from barchan.kernels.grains.air_state import CanopyDrag
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


PLANT_SHARE = Derived("plant_share", "1", "height of plants over that of the tallest", _share, least=0.0)

PLANTS = Overlay(PLANT_SHARE.name, "plants, over the tallest", "Greens")


def planted(stands: Sequence[Stand], lattice: Lattice) -> NDArray[np.float64]:
    """Height (m) of plants on each cell; where stands overlap, that of the last one."""
    height = np.zeros(lattice.shape)
    for stand in stands:
        height[stand.where(lattice)] = stand.height
    return height


class Canopy(Closure):
    """Plants that roughen the wind over them."""

    key: ClassVar[str] = "canopy"

    stands: list[Stand] = parameter(
        list,
        unit="-",
        max_length=100,
        meaning="Stands of plants that roughen the wind over them; later ones replace earlier ones. Where "
        "any are given, more can be painted.",
        source="ours; Prague thesis, §3.5",
    )
    roughness: float = parameter(
        0.123,
        unit="-",
        gt=0,
        le=0.5,
        live=True,
        meaning="Roughness length of plants, over their height.",
        source="Brutsaert 1982; Allen et al. 1998 (FAO-56)",
    )
    displacement: float = parameter(
        2.0 / 3.0,
        unit="-",
        ge=0,
        le=1,
        live=True,
        meaning="Zero-plane displacement of plants, over their height.",
        source="Brutsaert 1982; Allen et al. 1998 (FAO-56)",
    )

    def roughness_of(
        self, height: NDArray[np.float64], lattice: Lattice, rules: "GrainFlight"
    ) -> "PlantRoughness":
        """Displacement and roughness of plants of a ``height`` (m) on each cell."""
        mean = over_mesh(height, lattice.periodic).reshape(-1)
        displacement = np.maximum(self.displacement * mean - rules.displacement, 0.0)
        ratio = np.maximum(self.roughness * mean / rules.roughness_length, 1.0)
        return PlantRoughness(displacement.astype(np.float32), np.log(ratio))


class PlantRoughness(NamedTuple):
    """Plants in the wind: flat arrays over the mesh cells."""

    displacement_height: NDArray[np.float32]
    """Height (m) by which plants lift the wind profile, over the displacement of the field."""
    logarithm: NDArray[np.float64]
    """Logarithm of the roughness length of plants over that of the field."""

    def drag(self, ustar: float) -> CanopyDrag:
        """The effect on a wind of friction velocity ``ustar`` (m/s), as kernels take it."""
        deficit = ustar / KARMAN * self.logarithm
        return CanopyDrag(self.displacement_height, deficit.astype(np.float32))


def canopy_facts(canopy: Canopy, lattice: Lattice) -> str:
    """Cover, height, roughness and displacement of the plants, for people to read."""
    height = planted(canopy.stands, lattice)
    tallest = float(height.max())
    return (
        f"on {(height > 0).mean():.0%} of the field, up to {tallest:.3g} m high, with a roughness of "
        f"{canopy.roughness * tallest:.3g} m and a displacement of {canopy.displacement * tallest:.3g} m"
    )
