"""Coordinates of frames: distances within the field, or in the reference system of its terrain."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.ground.terrain import Georeference
from barchan.lattice import Lattice

GRID_MAPPING = "spatial_ref"
"""Name of the variable that holds the reference system, by the CF conventions and as GIS programs expect."""

CENTRE_X = "centre_x"
"""Name of the coordinate that holds where the centres of hexagons lie from west to east."""

STEP = {"units": "1", "long_name": "steps done", "axis": "T"}
"""Attributes of the steps; by the axis readers of NetCDF (VTK's) know that frames follow in time."""


Axis = tuple[tuple[str, ...], NDArray[np.float64], dict[str, Any]]
"""Dimensions, places (m) and attributes of a coordinate."""


def axes(lattice: Lattice, place: Georeference | None) -> dict[str, Axis]:
    """Centres of the cells along ``x`` and ``y``; of hexagons also ``CENTRE_X``, by row and column."""
    west, south = (0.0, 0.0) if place is None else (place.west, place.south)
    found: dict[str, Axis] = {
        "x": (("x",), lattice.x + west, attributes_of("x", place)),
        "y": (("y",), lattice.y + south, attributes_of("y", place)),
    }
    if lattice.hexagonal:
        found["x"][2]["comment"] = "of rows 0, 2, 4 and so on; the others lie half a cell farther east"
        own = {"units": "m", "long_name": "distance of the cell's centre from the west edge"}
        found[CENTRE_X] = (("y", "x"), lattice.centres[0].copy(), own)
    return found


def lattice_attributes(lattice: Lattice) -> dict[str, Any]:
    """Shape and size of the cells, as attributes of a run's data."""
    known: dict[str, Any] = {"lattice": lattice.kind, "cell_size": lattice.cell_size}
    if lattice.hexagonal:
        known |= {"row_spacing": lattice.row_spacing, "shift_of_odd_rows": lattice.cell_size / 2}
    return known


def place_attributes(place: Georeference | None) -> dict[str, Any]:
    """Where on Earth a run's field lies, as attributes of its data."""
    if place is None:
        return {}
    known = {"west": place.west, "south": place.south}
    return known if place.crs is None else {"crs": place.crs, **known}


def mapping_attributes(place: Georeference | None) -> dict[str, Any]:
    """The reference system as attributes of the variable that holds it; empty where there is none."""
    if place is None or place.wkt is None:
        return {}
    return {"crs_wkt": place.wkt, "spatial_ref": place.wkt, "long_name": "coordinate reference system"}


def mapped(place: Georeference | None) -> dict[str, str]:
    """The attribute by which a field names its reference system; none where there is none."""
    return {"grid_mapping": GRID_MAPPING} if mapping_attributes(place) else {}


def attributes_of(name: str, place: Georeference | None) -> dict[str, Any]:
    """Attributes of a coordinate along an axis of the field."""
    attributes = {"units": "m", "axis": name.upper()}
    if place is None:
        edge = {"x": "west", "y": "south"}[name]
        return {**attributes, "long_name": f"distance from the {edge} edge"}
    kind = {"x": "easting", "y": "northing"}[name]
    return {
        **attributes,
        "standard_name": f"projection_{name}_coordinate",
        "long_name": f"{kind} of the cell's centre" + (f" in {place.crs}" if place.crs else ""),
    }
