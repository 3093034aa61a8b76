"""Coordinate reference systems: what a metre of a map is on the ground, and which maps can be used.

Slopes need cells whose sides are true lengths. A raster in degrees, in feet or in a projection that stretches
lengths (Web Mercator by 1/cos of the latitude) is refused, and the true size of its cells is stated.
"""

import re
from typing import Any

from barchan.ground.raster import Hints, Place, UnreadableError
from barchan.ground.true_cells import is_local, true_cell

MISSING_EXTRA = "needs rasterio to be read; install it with: python -m pip install rasterio"

METRES = "metres"
"""Stands for local coordinates in metres, instead of a reference system."""

LARGEST_DISTORTION = 0.03
"""Lengths on the map may differ by this part from those on the ground."""

NOTABLE_DISTORTION = 0.005
NOTABLE_CONVERGENCE = 3.0
"""Degrees between north of the map and true north that are worth a remark."""

_UNIT = re.compile(r'UNIT\["([^"]+)",([0-9.eE+-]+)')


def reference_of(text: str) -> Any:
    """The reference system that a code or a WKT names; raises UnreadableError where it names none."""
    try:
        from rasterio.crs import CRS
        from rasterio.errors import CRSError
    except ImportError:
        raise UnreadableError(MISSING_EXTRA) from None
    try:
        if text.lstrip().upper().startswith(("PROJCS", "GEOGCS")):
            return CRS.from_wkt(text, morph_from_esri_dialect=True)
        return CRS.from_user_input(text)
    except CRSError:
        raise UnreadableError(
            f"is in '{text[:60]}', which is no known coordinate reference system; "
            f"allowed: a code such as EPSG:32633, or '{METRES}'"
        ) from None


def stated(crs: Any, hints: Hints) -> Any:
    """The file's own reference system, or the one that the user gives where the file has none."""
    if hints.crs is None or hints.crs == METRES:
        if crs is not None and hints.crs == METRES:
            raise UnreadableError(f"is in {name_of(crs)} by itself; leave crs out")
        return crs
    given = reference_of(hints.crs)
    if crs is not None and crs != given:
        raise UnreadableError(f"is in {name_of(crs)} by itself, not in {hints.crs}; leave crs out")
    return given


def name_of(crs: Any) -> str:
    """Code of a reference system where it has one, else its name."""
    text = str(crs.to_string())
    return text if len(text) < 40 else text.split('"')[1]


def system_of(place: Place) -> str:
    """The reference system of a raster, for people to read."""
    return "no coordinate reference system stated" if place.crs is None else name_of(place.crs)


def require_metres(place: Place, shape: tuple[int, int], hints: Hints) -> None:
    """Raise UnreadableError where a raster's coordinates are not metres on the ground."""
    crs = place.crs
    if (crs is None or not crs.is_geographic) and hints.crs != METRES and _like_degrees(place, shape):
        said = "states no coordinate reference system, and" if crs is None else f"is in {name_of(crs)}, but"
        raise UnreadableError(
            f"{said} its cells of {place.width:g} from {place.west:g} to "
            f"{place.west + shape[1] * place.width:g} look like degrees; "
            + (f"state crs '{METRES}' if they are metres, else " if crs is None else "")
            + f"bring it to metres, {_advice(place.west, place.south)}"
        )
    if crs is None:
        return
    if is_local(crs):
        _require_local_metres(crs)
        return
    true = true_cell(place, shape)
    advice = _advice(true.longitude, true.latitude, true.on_earth)
    allowed = f"allowed: a projected one in metres, {advice}"
    if crs.is_geographic:
        raise UnreadableError(
            f"is in {crs.units_factor[0]}s ({name_of(crs)}): its cells of {place.width:.4g} are "
            f"{true.sides()}; {allowed}"
        )
    unit, factor = crs.linear_units_factor
    if factor != 1.0:
        raise UnreadableError(
            f"is in {name_of(crs)}, in units of {factor:.6g} m ({unit}): its cells of {place.width:g} "
            f"are {true.sides()}; {allowed}"
        )
    if true.distortion(place) > LARGEST_DISTORTION:
        raise UnreadableError(
            f"is in {name_of(crs)}, whose lengths are not those on the ground: at {true.where()} its "
            f"cells of {place.width:g} m are {true.sides()}; allowed: a projection true to "
            f"{100 * LARGEST_DISTORTION:g} %, {advice}"
        )


def remarks_on(place: Place, shape: tuple[int, int]) -> list[str]:
    """Remarks on lengths and directions of a raster's map that differ from those on the ground."""
    if place.crs is None or is_local(place.crs):
        return []
    true, found = true_cell(place, shape), []
    if true.distortion(place) > NOTABLE_DISTORTION:
        found.append(
            f"cells of the terrain are {true.sides()} on the ground, and taken as {place.cell_size:g} m: "
            f"{name_of(place.crs)} does not keep lengths at {true.where()}"
        )
    if abs(true.convergence) > NOTABLE_CONVERGENCE:
        side = "east" if true.convergence > 0 else "west"
        found.append(
            f"north of the terrain's map lies {abs(true.convergence):.1f}° {side} of true north "
            f"({name_of(place.crs)} at {true.where()}); winds given against true north must be turned by that"
        )
    return found


def _require_local_metres(crs: Any) -> None:
    """Raise UnreadableError where the coordinates of a site are in another unit."""
    unit = _UNIT.search(str(crs.to_wkt(version="WKT1_GDAL")))
    if unit is not None and float(unit[2]) != 1.0:
        raise UnreadableError(f"is in '{name_of(crs)}', in units of {unit[2]} m ({unit[1]}); allowed: metres")


def _like_degrees(place: Place, shape: tuple[int, int]) -> bool:
    east, north = place.west + shape[1] * place.width, place.south + shape[0] * place.height
    inside = place.west >= -360 and east <= 360 and place.south >= -90 and north <= 90
    return inside and max(place.width, place.height) < 0.1


def _advice(longitude: float, latitude: float, on_earth: bool = True) -> str:
    """A projection for a place, and how to get there."""
    if not on_earth:
        return "for instance an equirectangular one whose standard parallel crosses the field"
    zone = min(int((longitude + 180.0) % 360.0 // 6) + 1, 60)
    code = (32600 if latitude >= 0 else 32700) + zone
    name = f"EPSG:{code} (UTM zone {zone}{'N' if latitude >= 0 else 'S'})"
    if abs(latitude) > 80:
        code = 3413 if latitude > 0 else 3031
        name = f"EPSG:{code} (polar stereographic)"
    return f"for instance {name}, to which a GIS or Rasterio's warp brings it"
