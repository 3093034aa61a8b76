"""Coordinate reference systems: what a metre of a map is on the ground, and which maps can be used.

Slopes need cells whose sides are true lengths. A raster in degrees, in feet or in a projection that stretches
lengths (Web Mercator by 1/cos of the latitude) is refused, and the true size of its cells is stated.
"""

import math
from dataclasses import dataclass
from typing import Any

from barchan.ground.raster import Hints, Place, UnreadableError

MISSING_EXTRA = "needs rasterio to be read; install it with: pip install barchan[geo]"

METRES = "metres"
"""Stands for local coordinates in metres, instead of a reference system."""

LARGEST_DISTORTION = 0.03
"""Lengths on the map may differ by this part from those on the ground."""

NOTABLE_DISTORTION = 0.005
NOTABLE_CONVERGENCE = 3.0
"""Degrees between north of the map and true north that are worth a remark."""

EQUATORIAL_RADIUS, ECCENTRICITY_SQUARED = 6_378_137.0, 0.006_694_379_990_14
"""Of the WGS 84 ellipsoid (m, -)."""


@dataclass(frozen=True)
class TrueCell:
    """A cell in the middle of a raster, as it is on the ground."""

    width: float
    """Length from west to east (m)."""
    height: float
    """Length from south to north (m)."""
    longitude: float
    latitude: float
    convergence: float
    """Direction of the map's north, degrees clockwise from true north."""


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
    if place.crs is None:
        if hints.crs != METRES and _like_degrees(place, shape):
            raise UnreadableError(
                f"states no coordinate reference system, and its cells of {place.width:g} from "
                f"{place.west:g} to {place.west + shape[1] * place.width:g} look like degrees; state crs "
                f"'{METRES}' if they are metres, else bring it to metres, "
                f"{_advice(place.west, place.south)}"
            )
        return
    true = true_cell(place, shape)
    if place.crs.is_geographic:
        raise UnreadableError(
            f"is in degrees ({name_of(place.crs)}): its cells of {place.width:.4g}° are {_sides(true)}; "
            f"allowed: a projected one in metres, {_advice(true.longitude, true.latitude)}"
        )
    unit, factor = place.crs.linear_units_factor
    if factor != 1.0:
        raise UnreadableError(
            f"is in {name_of(place.crs)}, in units of {factor:.6g} m ({unit}): its cells of {place.width:g} "
            f"are {_sides(true)}; allowed: a projected one in metres, "
            f"{_advice(true.longitude, true.latitude)}"
        )
    if distortion(place, true) > LARGEST_DISTORTION:
        raise UnreadableError(
            f"is in {name_of(place.crs)}, whose lengths are not those on the ground: at {_where(true)} its "
            f"cells of {place.width:g} m are {_sides(true)}; allowed: a projection true to "
            f"{100 * LARGEST_DISTORTION:g} %, {_advice(true.longitude, true.latitude)}"
        )


def remarks_on(place: Place, shape: tuple[int, int]) -> list[str]:
    """Remarks on lengths and directions of a raster's map that differ from those on the ground."""
    if place.crs is None:
        return []
    true, found = true_cell(place, shape), []
    if distortion(place, true) > NOTABLE_DISTORTION:
        found.append(
            f"cells of the terrain are {_sides(true)} on the ground, and taken as {place.cell_size:g} m: "
            f"{name_of(place.crs)} does not keep lengths at {_where(true)}"
        )
    if abs(true.convergence) > NOTABLE_CONVERGENCE:
        side = "east" if true.convergence > 0 else "west"
        found.append(
            f"north of the terrain's map lies {abs(true.convergence):.1f}° {side} of true north "
            f"({name_of(place.crs)} at {_where(true)}); winds given against true north must be turned by that"
        )
    return found


def true_cell(place: Place, shape: tuple[int, int]) -> TrueCell:
    """The cell in the middle of a raster that has a reference system, on the WGS 84 ellipsoid."""
    from rasterio.warp import transform

    x = place.west + shape[1] * place.width / 2
    y = place.south + shape[0] * place.height / 2
    xs, ys = [x, x + place.width, x], [y, y, y + place.height]
    (here, east, north), (low, side, high) = transform(place.crs, "EPSG:4326", xs, ys)
    meridian, parallel = _radii(low)
    along_x = _turn(east - here) * parallel, math.radians(side - low) * meridian
    along_y = _turn(north - here) * parallel, math.radians(high - low) * meridian
    turned = math.degrees(math.atan2(*along_y))
    return TrueCell(math.hypot(*along_x), math.hypot(*along_y), here, low, turned)


def distortion(place: Place, true: TrueCell) -> float:
    """The largest part by which a side of a cell on the map (m) differs from that on the ground."""
    return max(abs(true.width / place.width - 1.0), abs(true.height / place.height - 1.0))


def _radii(latitude: float) -> tuple[float, float]:
    """Radius of the meridian and of the parallel (m) at a latitude."""
    sine = math.sin(math.radians(latitude))
    bulge = 1.0 - ECCENTRICITY_SQUARED * sine**2
    across = EQUATORIAL_RADIUS / math.sqrt(bulge)
    return across * (1.0 - ECCENTRICITY_SQUARED) / bulge, across * math.cos(math.radians(latitude))


def _turn(degrees: float) -> float:
    """A difference of longitudes in radians, the short way round."""
    return math.radians((degrees + 180.0) % 360.0 - 180.0)


def _like_degrees(place: Place, shape: tuple[int, int]) -> bool:
    east, north = place.west + shape[1] * place.width, place.south + shape[0] * place.height
    inside = place.west >= -360 and east <= 360 and place.south >= -90 and north <= 90
    return inside and max(place.width, place.height) < 0.1


def _sides(true: TrueCell) -> str:
    return f"{true.width:.3g} m from west to east and {true.height:.3g} m from south to north"


def _where(true: TrueCell) -> str:
    return f"{abs(true.latitude):.4g}°{'N' if true.latitude >= 0 else 'S'}"


def _advice(longitude: float, latitude: float) -> str:
    """A projection for a place, and how to get there."""
    zone = min(int((longitude + 180.0) % 360.0 // 6) + 1, 60)
    code = (32600 if latitude >= 0 else 32700) + zone
    name = f"EPSG:{code} (UTM zone {zone}{'N' if latitude >= 0 else 'S'})"
    if abs(latitude) > 80:
        code = 3413 if latitude > 0 else 3031
        name = f"EPSG:{code} (polar stereographic)"
    return f"for instance {name}: rio warp FILE new.tif --dst-crs EPSG:{code} --resampling bilinear"
