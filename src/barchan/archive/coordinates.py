"""Coordinates of frames: distances within the field, or in the reference system of its terrain."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.ground.terrain import Georeference
from barchan.lattice import Lattice

GRID_MAPPING = "spatial_ref"
"""Name of the variable that holds the reference system, by the CF conventions and as GIS programs expect."""

STEP = {"units": "1", "axis": "T", "long_name": "steps done"}
"""Attributes of the steps: by the axis T readers of NetCDF know the frames as moments of one surface."""


def axes(
    lattice: Lattice, place: Georeference | None
) -> dict[str, tuple[NDArray[np.float64], dict[str, Any]]]:
    """Centres of the cells (m) along ``x`` and ``y``, with their attributes."""
    west, south = (0.0, 0.0) if place is None else (place.west, place.south)
    return {
        "x": (lattice.x + west, _attributes("x", place)),
        "y": (lattice.y + south, _attributes("y", place)),
    }


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


def _attributes(name: str, place: Georeference | None) -> dict[str, Any]:
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
