"""The non-erodible ground under the sand: every kind there is."""

from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from barchan.ground.cylinders import Cylinders
from barchan.ground.fitting import FromFile
from barchan.ground.landforms import Bump, Cliff, DuneForm, Escarpment, FlatGround, Hump, Ramp, Valley
from barchan.ground.raster import georeference
from barchan.ground.rocks import ThreeRocks, UnevenGround
from barchan.ground.terrain import HIGHEST, Terrain
from barchan.lattice import Lattice
from barchan.parameters import parameter
from barchan.streams import Stream


class FileGround(Terrain, FromFile):
    """Ground from an elevation model, an image or an array."""

    kind: Literal["file"] = parameter(
        "file", unit="-", meaning="An elevation model, an image or an array (m)."
    )

    def elevation(self, lattice: Lattice, _stream: Stream) -> NDArray[np.float64]:
        """Elevation (m) on the lattice."""
        return self.heights(lattice, "ground", -HIGHEST, HIGHEST)

    def georeference(self) -> dict[str, Any]:
        """Position of the field on Earth, if the file states it."""
        return georeference(Path(self.path))


Ground = Annotated[
    FlatGround
    | Bump
    | Hump
    | DuneForm
    | Valley
    | Cliff
    | Escarpment
    | Ramp
    | ThreeRocks
    | Cylinders
    | UnevenGround
    | FileGround,
    Field(discriminator="kind"),
]
