"""Where plants stand on a bed at first."""

from pathlib import Path
from typing import Annotated, ClassVar, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from barchan.errors import Problem, ScenarioError
from barchan.ground.area import Area, covered
from barchan.ground.raster import UnreadableError
from barchan.ground.reading import read
from barchan.lattice import Lattice
from barchan.parameters import Parameters, parameter
from barchan.plants.species import LEAST, MOST, SPECIES
from barchan.streams import Stream, high
from barchan.words import counted

TABLES = "Prague thesis, Tables 6.4-6.6"
OWN = "ours"


class Layout(Parameters):
    """Where plants stand at first."""

    kind_key: ClassVar[str] = "kind"

    kind: str
    grass: float = parameter(
        0.0, unit="-", ge=LEAST, le=MOST, meaning="Effectiveness of grass.", source=TABLES
    )
    mesquite: float = parameter(
        0.0, unit="-", ge=LEAST, le=MOST, meaning="Effectiveness of mesquite.", source=TABLES
    )
    shrub: float = parameter(
        0.0, unit="-", ge=LEAST, le=MOST, meaning="Effectiveness of shrub.", source=TABLES
    )
    randomised: bool = parameter(
        False,
        unit="-",
        meaning="Whether each cell starts with a random share of these values.",
        source="Prague thesis, Table 6.6",
    )

    def cover(self, lattice: Lattice, stream: Stream) -> dict[str, NDArray[np.float64]]:
        """Effectiveness of each species on each cell."""
        share = self.share(lattice)
        if self.randomised:
            share = share * (high(stream.draws(0, lattice.cells)) / 2.0**32).reshape(lattice.shape)
        return {name: getattr(self, name) * share for name in SPECIES}

    def share(self, lattice: Lattice) -> NDArray[np.float64]:
        """The share of the stated effectiveness that each cell has."""
        return np.ones(lattice.shape)


class UniformPlants(Layout):
    """The same plants everywhere; none unless stated, to develop naturally."""

    kind: Literal["uniform"] = parameter(
        "uniform", unit="-", meaning="The same plants on every cell.", source=TABLES
    )


class Blowouts(Layout):
    """Plants everywhere but on bare patches in a row across the field, from south to north."""

    kind: Literal["blowouts"] = parameter(
        "blowouts", unit="-", meaning="Plants with bare patches.", source=TABLES
    )
    count: int = parameter(3, unit="-", ge=1, le=1000, meaning="Bare patches.", source="Prague thesis, §6.4")
    width: float = parameter(
        5.0,
        unit="m",
        gt=0,
        le=1e6,
        meaning="Size of a patch from south to north.",
        source="Prague thesis, §6.4",
    )
    length: float = parameter(
        6.0,
        unit="m",
        gt=0,
        le=1e6,
        meaning="Size of a patch from west to east.",
        source="Prague thesis, §6.4",
    )
    x: float = parameter(
        0.25,
        unit="-",
        ge=0,
        le=1,
        meaning="Where the patches lie, as a fraction of the field from the west.",
        source=OWN,
    )

    def share(self, lattice: Lattice) -> NDArray[np.float64]:
        """None on the patches, all elsewhere."""
        centres = lattice.x + lattice.shift[:, None]
        columns = _within(centres - self.x * lattice.width, self.length)
        middles = (np.arange(self.count) + 0.5) * lattice.height / self.count
        rows = _within(lattice.y[:, None] - middles, self.width).any(axis=1)
        return np.where(np.logical_and(np.asarray(rows)[:, None], columns), 0.0, 1.0)


def _within(distance: NDArray[np.float64], size: float) -> NDArray[np.bool_]:
    return (distance >= -size / 2) & (distance < size / 2)


class Island(Area):
    """A rectangle that plants stand on."""


def _three() -> list[Island]:
    """Our places: the Prague thesis shows them only in pictures."""
    return [
        Island(west=0.15, east=0.35, south=0.60, north=0.85),
        Island(west=0.40, east=0.60, south=0.15, north=0.40),
        Island(west=0.65, east=0.85, south=0.55, north=0.80),
    ]


class Islands(Layout):
    """Plants on rectangles only; three unless stated."""

    kind: Literal["islands"] = parameter(
        "islands", unit="-", meaning="Plants on rectangles only.", source=TABLES
    )
    islands: list[Island] = parameter(
        _three,
        unit="-",
        max_length=100,
        meaning="Where plants stand.",
        source="Prague thesis, §6.4; our places, the text has none",
    )

    def share(self, lattice: Lattice) -> NDArray[np.float64]:
        """All on the islands, none elsewhere."""
        return covered(self.islands, lattice).astype(np.float64)


class MappedPlants(Layout):
    """Plants in the shares that an image or an array gives."""

    kind: Literal["file"] = parameter(
        "file", unit="-", meaning="Plants where an image or array has them.", source=OWN
    )
    path: str = parameter(
        unit="-",
        meaning="A .npy array of shares (row 0 in the south) or a .png or .jpg (its luminance; white: the "
        "full values), of the lattice's size.",
        source=OWN,
    )

    def share(self, lattice: Lattice) -> NDArray[np.float64]:
        """The file's shares; raises ScenarioError where it cannot be read or does not fit."""
        try:
            raster = read(Path(self.path))
        except UnreadableError as error:
            raise self._misfit(str(error)) from None
        share = raster.values / (raster.full_scale or 1.0)
        message = ""
        if share.shape != lattice.shape:
            message = f"has {share.shape} rows and columns; allowed: the lattice's {lattice.shape}"
        elif not np.isfinite(share).all():
            without = int(np.count_nonzero(~np.isfinite(share)))
            message = f"has {counted(without, 'cell')} without a value; allowed: none"
        elif share.min() < 0 or share.max() > 1:
            message = f"has shares from {share.min():g} to {share.max():g}; allowed: 0 to 1"
        if message:
            raise self._misfit(message)
        return share

    def _misfit(self, message: str) -> ScenarioError:
        return ScenarioError([Problem("model.vegetation.path", f"'{self.path}': {message}")])


Vegetation = Annotated[
    UniformPlants | Blowouts | Islands | MappedPlants,
    Field(discriminator="kind"),
]
