"""The non-erodible ground under the sand: every kind there is."""

from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from barchan.ground.cylinders import Cylinders
from barchan.ground.fitting import FromFile
from barchan.ground.landforms import Bump, Cliff, DuneForm, Escarpment, FlatGround, Hump, Ramp, Valley
from barchan.ground.raster import Outline, Place, UnreadableError
from barchan.ground.reference import name_of, remarks_on, system_of
from barchan.ground.rocks import ThreeRocks, UnevenGround
from barchan.ground.terrain import HIGHEST, Georeference, Terrain
from barchan.lattice import Lattice
from barchan.parameters import parameter
from barchan.streams import Stream

EXACT = 1e-6
"""Relative difference of lengths that rounding in a file explains."""


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
        file = self._known()
        if file is None or file.place is None:
            return None
        place = file.place
        if place.crs is None:
            return Georeference(place.west, place.south)
        return Georeference(place.west, place.south, name_of(place.crs), place.crs.to_wkt())

    def facts(self, lattice: Lattice) -> dict[str, str]:
        """Size and place of the file's cells, and how they are brought onto the lattice."""
        file = self._known()
        if file is None:
            return {}
        rows, columns = file.shape
        said = [f"{rows} rows of {columns} cells"]
        if file.place is not None:
            said = [f"{said[0]} of {_cells(file.place)}", _position(file.place)]
        if file.unit is not None and file.scale != 1.0:
            said.append(f"heights in {file.unit} taken to metres")
        if file.coloured:
            said.append("colours taken by their luminance")
        if filled := self.fill_facts():
            said.append(filled)
        if self.resample:
            said.append(f"brought onto cells of {lattice.cell_size:g} m")
        return {"terrain": "; ".join(said)}

    def remarks(self, lattice: Lattice) -> list[str]:
        """Remarks on cells that are not the lattice's, and on lengths and north of the map."""
        file = self._known()
        if file is None or file.place is None:
            return []
        place, found = file.place, []
        sides = (place.width, place.height)
        if not self.resample and any(abs(side / lattice.cell_size - 1.0) > EXACT for side in sides):
            squares = f"squares of {lattice.cell_size:.9g} m"
            found.append(f"cells of the terrain are {_cells(place)}, and taken as {squares}")
        return [*found, *remarks_on(place, file.shape)]

    def _known(self) -> Outline | None:
        try:
            return self.outline()
        except UnreadableError:
            return None


def _cells(place: Place) -> str:
    square = abs(place.width / place.height - 1.0) <= EXACT
    return f"{place.width:.9g} m" if square else f"{place.width:.9g} × {place.height:.9g} m"


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
