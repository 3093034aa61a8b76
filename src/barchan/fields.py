"""Declarations of the fields on the lattice, and of the layers that wind can move.

Archive, studio and figures know fields and layers by their declarations only.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class FieldInfo:
    """The declaration of a field on the lattice."""

    name: str
    dtype: str
    unit: str
    meaning: str
    in_frames: bool = True
    """Whether frames of a run carry the field."""
    centre: float | None = None
    """The value that pictures show it evenly about, where there is one."""
    coded: bool = False
    """Whether its numbers code what only its owner reads, or what another field shows: frames carry it,
    nothing shows or exports it."""


@dataclass(frozen=True)
class LayerInfo(FieldInfo):
    """The declaration of a layer that wind can move: on each cell a whole number of one quantum."""

    mass: float | None = None
    """Mass (kg/m²) of one unit, of a layer whose quantum is a mass; otherwise it is one slab in height."""
    height_field: str = ""
    """The field (whole numbers of ``HEIGHT_UNIT``) that holds how thick a layer of a mass lies on each cell;
    without one the layer's thickness is part of that of a layer above."""
    part_of: str = ""
    """The layer that this one is a class of: the classes of a layer add up to it on every cell."""
    class_value: float | None = None
    """The property that defines the class (a grain diameter, an age, a hardness), in ``class_unit``."""
    class_unit: str = ""

    @property
    def height(self) -> FieldInfo | None:
        """The declaration of its ``height_field``, which the depth shows in metres; None without one."""
        if not self.height_field:
            return None
        return FieldInfo(self.height_field, "int32", "µm", f"thickness of the {self.name}", coded=True)


HEIGHT_UNIT = 1e-6
"""Height (m) of one unit of a layer's ``height_field``; of a quantum of 0.1 kg/m² a two-hundredth at most."""


GROUND = FieldInfo("ground", "float64", "m", "elevation of the non-erodible ground")


SAND = LayerInfo("sand", "int32", "slabs", "slabs of sand on the ground")


def count_names(layers: Iterable[LayerInfo]) -> list[str]:
    """Names of the fields that hold how much of each layer lies on a cell, and how thick."""
    return [name for layer in layers for name in (layer.name, layer.height_field) if name]


def depth_of(layers: Iterable[LayerInfo], fields: Any, slab_height: float) -> Any:
    """Thickness (m) of all layers on each cell, computed from their counts in ``fields``.

    ``fields`` maps names to arrays, or to anything else that can be multiplied and added, of one bed or many.
    """
    depths = [
        fields[layer.name] * slab_height if layer.mass is None else fields[layer.height_field] * HEIGHT_UNIT
        for layer in layers
        if layer.mass is None or layer.height_field
    ]
    total = depths[0]
    for depth in depths[1:]:
        total = total + depth
    return total
