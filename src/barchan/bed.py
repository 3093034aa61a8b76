"""The bed: the lattice and the fields on it. Layers are whole numbers of a declared quantum.

The surface is always computed from the ground and the layers, never accumulated.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Literal, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import model_validator

from barchan.parameters import Parameters, parameter

Boundary = Literal["periodic", "open"]

DEFAULT_ASPECT = 1 / 3
LEAST_ASPECT, LARGEST_ASPECT = 1e-4, 10.0


class Lattice(Parameters):
    """The lattice: its size, what a cell and a slab measure, and what lies beyond its edges."""

    kind: Literal["square"] = parameter("square", unit="-", meaning="Shape of the cells.")
    rows: int = parameter(
        256,
        unit="cells",
        ge=1,
        le=65536,
        meaning="Cells from south to north.",
        source="Prague thesis, Table 6.1",
    )
    columns: int = parameter(
        256,
        unit="cells",
        ge=8,
        le=65536,
        meaning="Cells from west to east.",
        source="Prague thesis, Table 6.1",
    )
    cell_size: float = parameter(
        1.0, unit="m", ge=1e-4, le=1e6, scale="log", meaning="Width of a cell.", source="Prague thesis, §4.3"
    )
    slab_aspect: float | None = parameter(
        None,
        unit="-",
        ge=LEAST_ASPECT,
        le=LARGEST_ASPECT,
        meaning="Height of a slab as a fraction of the cell's width; 1/3 where neither this nor "
        "slab_height is given.",
        source="Momiji et al. 2000; Prague thesis, §4.3",
    )
    slab_height: float | None = parameter(
        None, unit="m", gt=0, le=1e6, meaning="Height of a slab, instead of slab_aspect."
    )
    boundary_x: Boundary = parameter(
        "periodic", unit="-", meaning="West and east edges: joined, or open so that sand may leave."
    )
    boundary_y: Boundary = parameter(
        "periodic", unit="-", meaning="South and north edges: joined, or open so that sand may leave."
    )

    @model_validator(mode="after")
    def _one_height(self) -> Self:
        if self.slab_aspect is not None and self.slab_height is not None:
            raise ValueError(
                f"slab_aspect {self.slab_aspect} and slab_height {self.slab_height} m are both given; "
                "give one of them"
            )
        if not LEAST_ASPECT <= self.aspect <= LARGEST_ASPECT:
            raise ValueError(
                f"slab_height {self.slab_height} m is {self.aspect:g} of cell_size {self.cell_size} m; "
                f"allowed: {LEAST_ASPECT:g} to {LARGEST_ASPECT:g} of it"
            )
        return self

    @property
    def aspect(self) -> float:
        """Height of a slab over the width of a cell."""
        if self.slab_height is not None:
            return self.slab_height / self.cell_size
        return DEFAULT_ASPECT if self.slab_aspect is None else self.slab_aspect

    @property
    def thickness(self) -> float:
        """Height of a slab in metres."""
        return self.aspect * self.cell_size

    @property
    def shape(self) -> tuple[int, int]:
        """(rows, columns)."""
        return self.rows, self.columns

    @property
    def cells(self) -> int:
        """Number of cells."""
        return self.rows * self.columns

    @property
    def periodic(self) -> tuple[bool, bool]:
        """Whether the field is periodic south to north and west to east."""
        return self.boundary_y == "periodic", self.boundary_x == "periodic"

    @property
    def x(self) -> NDArray[np.float64]:
        """Distance of the cells' centres from the west edge (m)."""
        return (np.arange(self.columns, dtype=np.float64) + 0.5) * self.cell_size

    @property
    def y(self) -> NDArray[np.float64]:
        """Distance of the cells' centres from the south edge (m)."""
        return (np.arange(self.rows, dtype=np.float64) + 0.5) * self.cell_size


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


GROUND = FieldInfo("ground", "float64", "m", "elevation of the non-erodible ground")
SAND = FieldInfo("sand", "int32", "slabs", "slabs of sand on the ground")


class Bed:
    """The fields of a simulation, by name; ``sand`` and ``ground`` are always there.

    Arrays are ``[row, column]``, row 0 at the south edge, column 0 at the west edge.
    """

    def __init__(self, lattice: Lattice, ground: NDArray[np.float64], sand: NDArray[np.int32]) -> None:
        """Take the ground (m) and the sand (slabs), each of the lattice's shape, as they are."""
        self.lattice = lattice
        self.declared: dict[str, FieldInfo] = {}
        self.arrays: dict[str, NDArray] = {}
        self.add(GROUND, ground)
        self.add(SAND, sand)

    @classmethod
    def from_fields(
        cls, lattice: Lattice, fields: Mapping[str, NDArray], declared: Iterable[FieldInfo] = ()
    ) -> Self:
        """The bed that a frame shows: ground, sand and what else it carries of the ``declared`` fields."""
        bed = cls(lattice, fields[GROUND.name], fields[SAND.name])
        for field in declared:
            if field.in_frames:
                bed.add(field, fields[field.name])
        return bed

    def add(self, field: FieldInfo, values: NDArray) -> None:
        """Add a declared field; its values are copied into the declared type."""
        array = np.array(values, dtype=field.dtype, order="C")
        if array.shape != self.lattice.shape:
            raise ValueError(f"{field.name} has shape {array.shape}, the lattice {self.lattice.shape}")
        self.declared[field.name] = field
        self.arrays[field.name] = array

    @property
    def ground(self) -> NDArray[np.float64]:
        """Elevation of the non-erodible ground (m)."""
        return self.arrays["ground"]

    @property
    def sand(self) -> NDArray[np.int32]:
        """Slabs of sand on the ground."""
        return self.arrays["sand"]

    @property
    def elevation(self) -> NDArray[np.float64]:
        """Elevation of the surface (m), computed from ground and sand."""
        return self.ground + self.sand * self.lattice.thickness

    @property
    def slabs(self) -> int:
        """Slabs of sand on the whole bed."""
        return int(self.sand.sum(dtype=np.int64))

    def frame(self) -> dict[str, NDArray]:
        """Copies of the fields that frames carry."""
        return {name: self.arrays[name].copy() for name in self._names(self.declared.values())}

    @staticmethod
    def _names(fields: Iterable[FieldInfo]) -> list[str]:
        return [field.name for field in fields if field.in_frames]
