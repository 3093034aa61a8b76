"""The bed: the lattice, the ground, and the layers on it that wind can move, in whole numbers of a quantum.

The surface is always computed from the ground and the layers, never accumulated.
"""

from collections.abc import Iterable, Mapping, Sequence
from typing import Self

import numpy as np
from numpy.typing import NDArray

from barchan.checked import checked
from barchan.errors import FieldError
from barchan.fields import GROUND, SAND, FieldInfo, LayerInfo, depth_of
from barchan.lattice import Lattice


class Bed:
    """The fields of a simulation, by name: the ground, the layers on it, and the models' own fields.

    Layers lie on the ground in the order of ``layers``, the lowest first. All count the same quantum, so that
    a unit that passes from one layer to another stays whole. Elevation is computed from ground and layers,
    never accumulated. Arrays are ``[row, column]``, row 0 at the south edge, column 0 at the west edge.
    """

    def __init__(
        self,
        lattice: Lattice,
        ground: NDArray[np.float64],
        *counts: NDArray[np.integer],
        layers: Sequence[LayerInfo] = (SAND,),
    ) -> None:
        """Take the ground (m) and the units of each of ``layers``, of the lattice's shape, as they are."""
        if len({(layer.mass, layer.unit) for layer in layers}) != 1:
            raise ValueError("layers of a bed count the same quantum")
        self.lattice = lattice
        self.layers = tuple(layers)
        self.declared: dict[str, FieldInfo] = {}
        self.arrays: dict[str, NDArray] = {}
        self.add(GROUND, ground)
        for layer, values in zip(layers, counts, strict=True):
            self.add(layer, values)
            if layer.height:
                self.add(layer.height, np.zeros_like(values))

    @classmethod
    def from_fields(
        cls,
        lattice: Lattice,
        fields: Mapping[str, NDArray],
        declared: Iterable[FieldInfo] = (),
        layers: Sequence[LayerInfo] = (SAND,),
    ) -> Self:
        """The bed that a frame shows: ground, layers and those of the ``declared`` fields that it carries."""
        counts = [fields[layer.name] for layer in layers]
        bed = cls(lattice, fields[GROUND.name], *counts, layers=layers)
        for name in (layer.height_field for layer in layers if layer.height_field):
            bed.arrays[name][...] = fields[name]
        for field in declared:
            if field.in_frames or field.name in fields:
                bed.add(field, fields[field.name])
        return bed

    def add(self, field: FieldInfo, values: NDArray) -> None:
        """Add a declared field; its values are copied into the declared type.

        Raises FieldError for another shape than the lattice's and for values that the type does not hold.
        """
        self.arrays[field.name] = checked(values, self.lattice.shape, field.dtype, field.name)
        self.declared[field.name] = field

    def check(self) -> None:
        """Raise FieldError where an array is not as its field was declared, or a layer is below zero."""
        for name, field in self.declared.items():
            array = self.arrays[name]
            if array.dtype != field.dtype:
                raise FieldError(f"{name} is of type {array.dtype}, declared {field.dtype}")
            if array.shape != self.lattice.shape or array.dtype.kind == "f":
                checked(array, self.lattice.shape, field.dtype, name)
        for layer in self.layers:
            if (lowest := self.arrays[layer.name].min()) < 0:
                raise FieldError(f"{layer.name} is {lowest} {layer.unit}; allowed: none or more")

    @property
    def ground(self) -> NDArray[np.float64]:
        """Elevation of the non-erodible ground (m)."""
        return self.arrays[GROUND.name]

    @property
    def sand(self) -> NDArray[np.int32]:
        """Slabs of sand on each cell, of a bed that has a layer of sand."""
        return self.arrays[SAND.name]

    @property
    def top(self) -> NDArray[np.int32]:
        """Units of the uppermost layer on each cell."""
        return self.arrays[self.layers[-1].name]

    @property
    def stack(self) -> NDArray[np.integer]:
        """Units of all layers on each cell; of a single layer its own array."""
        if len(self.layers) == 1:
            return self.top
        total = sum(self.arrays[layer.name].astype(np.int64) for layer in self.layers)
        return np.asarray(total)

    @property
    def depth(self) -> NDArray[np.float64]:
        """Thickness (m) of all layers on each cell."""
        return np.asarray(depth_of(self.layers, self.arrays, self.lattice.thickness))

    @property
    def elevation(self) -> NDArray[np.float64]:
        """Elevation of the surface (m), computed from ground and layers."""
        return self.ground + self.depth

    @property
    def units(self) -> int:
        """Units of all layers on the whole bed."""
        return sum(int(self.arrays[layer.name].sum(dtype=np.int64)) for layer in self.layers)

    @property
    def volume(self) -> float:
        """Volume (m³) of all layers on the whole bed, pores included."""
        area = self.lattice.cell_area
        if any(layer.mass is not None for layer in self.layers):
            return float(self.depth.sum()) * area
        return self.units * self.lattice.thickness * area

    def classes_of(self, layer: str) -> list[LayerInfo]:
        """The classes that a layer is divided into, in order of declaration; none: the layer is uniform."""
        return [f for f in self.declared.values() if isinstance(f, LayerInfo) and f.part_of == layer]

    def undivided(self) -> list[str]:
        """Names of layers whose classes, where all of them are on the bed, do not add up to the layer."""
        wrong = []
        for layer in self.layers:
            classes = self.classes_of(layer.name)
            parts = sum(self.arrays[one.name].astype(np.int64) for one in classes)
            if classes and not np.array_equal(parts, self.arrays[layer.name]):
                wrong.append(layer.name)
        return wrong

    def lay(self, change: NDArray[np.int64]) -> None:
        """Add units to the uppermost layer, and take units (negative) from the uppermost that there are.

        Raises OverflowError where a cell cannot count as many, ValueError where it does not hold as many.
        """
        taken = np.maximum(-change, 0)
        if (taken > self.stack).any():
            raise ValueError("more units are taken from a cell than lie on it")
        top = self.top.astype(np.int64) + np.maximum(change, 0)
        if top.max() > np.iinfo(self.top.dtype).max:
            raise OverflowError("more units than a cell can count")
        self.top[...] = top
        for layer in reversed(self.layers):
            counts = self.arrays[layer.name]
            here = np.minimum(taken, counts)
            counts -= here.astype(counts.dtype)
            taken = taken - here

    def frame(self) -> dict[str, NDArray]:
        """Copies of the fields that frames carry."""
        shown = [field.name for field in self.declared.values() if field.in_frames]
        return {name: self.arrays[name].copy() for name in shown}

    def __repr__(self) -> str:
        """Size, layers with their amounts, and the range of elevation."""
        elevation = self.elevation
        names = {layer.name for layer in self.layers} | {GROUND.name}
        amounts = [f"{self.arrays[x.name].sum(dtype=np.int64)} {x.unit} of {x.name}" for x in self.layers]
        others = [name for name in self.declared if name not in names]
        also = f"; fields {', '.join(others)}" if others else ""
        size = f"{self.lattice.rows} × {self.lattice.columns} cells of {self.lattice.cell_size:g} m"
        heights = f"elevation {elevation.min():.4g} to {elevation.max():.4g} m"
        return f"<Bed of {size}: {', '.join(amounts)}, {heights}{also}>"
