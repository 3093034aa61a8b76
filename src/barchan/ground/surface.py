"""The non-erodible ground under the sand."""

from typing import Annotated, ClassVar, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from barchan.bed import Lattice
from barchan.parameters import Parameters, parameter


class FlatGround(Parameters):
    """Level ground."""

    kind_key: ClassVar[str] = "kind"

    kind: Literal["flat"] = parameter("flat", unit="-", meaning="Level ground.")
    level: float = parameter(0.0, unit="m", ge=-1e5, le=1e5, meaning="Elevation of the ground.")

    def elevation(self, lattice: Lattice) -> NDArray[np.float64]:
        """Elevation (m) on the lattice."""
        return np.full(lattice.shape, self.level)


class Bump(Parameters):
    """A single rounded hill on level ground."""

    kind_key: ClassVar[str] = "kind"

    kind: Literal["bump"] = parameter("bump", unit="-", meaning="A single rounded hill.")
    height: float = parameter(10.0, unit="m", ge=-1e4, le=1e4, meaning="Height of the hill's top.")
    radius: float = parameter(
        40.0, unit="m", gt=0, le=1e7, scale="log", meaning="Distance from the top to the foot."
    )
    x: float = parameter(
        0.3, unit="-", ge=0, le=1, meaning="Where the top is, as a fraction of the field from the west."
    )
    y: float = parameter(
        0.5, unit="-", ge=0, le=1, meaning="Where the top is, as a fraction of the field from the south."
    )

    def elevation(self, lattice: Lattice) -> NDArray[np.float64]:
        """Elevation (m) on the lattice: a cosine bell."""
        dx = lattice.x - self.x * lattice.columns * lattice.cell_size
        dy = lattice.y - self.y * lattice.rows * lattice.cell_size
        share = np.minimum(np.hypot(dx[None, :], dy[:, None]) / self.radius, 1.0)
        return self.height * 0.5 * (1.0 + np.cos(np.pi * share))


Ground = Annotated[FlatGround | Bump, Field(discriminator="kind")]
