"""The non-erodible ground under the sand: every kind there is."""

from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from barchan.ground.cylinders import Cylinders
from barchan.ground.fitting import FromFile
from barchan.ground.landforms import Bump, Cliff, DuneForm, Escarpment, FlatGround, Hump, Ramp, Valley
from barchan.ground.raster import Place, Raster, UnreadableError
from barchan.ground.reference import name_of, remarks_on, system_of
from barchan.ground.rocks import ThreeRocks, UnevenGround
from barchan.ground.terrain import HIGHEST, Georeference, Terrain
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

    def georeference(self) -> Georeference | None:
        """Position of the field on Earth, if the file states it and can be read."""
        raster = self._readable()
        if raster is None or raster.place is None:
            return None
        place = raster.place
        if place.crs is None:
            return Georeference(place.west, place.south)
        return Georeference(place.west, place.south, name_of(place.crs), place.crs.to_wkt())

    def facts(self, lattice: Lattice) -> dict[str, str]:
        """Size and place of the file's cells, and how they are brought onto the lattice."""
        raster = self._readable()
        if raster is None:
            return {}
        rows, columns = raster.values.shape
        said = [f"{rows} rows of {columns} cells"]
        if raster.place is not None:
            said = [f"{said[0]} of {_cells(raster.place)}", _position(raster.place)]
        if raster.unit is not None and raster.scale != 1.0:
            said.append(f"heights in {raster.unit} taken to metres")
        if self.resample:
            said.append(f"brought onto cells of {lattice.cell_size:g} m")
        return {"terrain": "; ".join(said)}

    def remarks(self, _lattice: Lattice) -> list[str]:
        """Remarks on cells that are not quite square, and on maps that do not keep lengths or north."""
        raster = self._readable()
        if raster is None or raster.place is None:
            return []
        place, found = raster.place, []
        if place.width != place.height and not self.resample:
            found.append(f"cells of the terrain are {_cells(place)}, not quite square, and taken as squares")
        return [*found, *remarks_on(place, raster.values.shape)]

    def _readable(self) -> Raster | None:
        try:
            return self.raster()
        except UnreadableError:
            return None


def _cells(place: Place) -> str:
    sides = f"{place.width:.9g} × {place.height:.9g} m"
    return sides if place.width != place.height else f"{place.width:.9g} m"


def _position(place: Place) -> str:
    return f"west edge {place.west:.9g} m, south edge {place.south:.9g} m, {system_of(place)}"


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
