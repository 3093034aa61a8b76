"""The true size of a map's cells, on the ellipsoid of its own planet."""

import math
import re
from dataclasses import dataclass
from typing import Any

from barchan.ground.raster import Place, UnreadableError

_SPHEROID = re.compile(r'SPHEROID\["[^"]*",([0-9.eE+]+),([0-9.eE+]+)')

_UNIT = re.compile(r'UNIT\["[^"]+",([0-9.eE+-]+)')

EARTH = 6_378_137.0
"""Equatorial radius of the Earth (m)."""


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
    on_earth: bool

    def distortion(self, place: Place) -> float:
        """The largest part by which a side of a cell on the map (m) differs from that on the ground."""
        return max(abs(self.width / place.width - 1.0), abs(self.height / place.height - 1.0))

    def sides(self) -> str:
        """Both lengths, for people to read."""
        return f"{self.width:.3g} m from west to east and {self.height:.3g} m from south to north"

    def where(self) -> str:
        """The latitude, for people to read."""
        return f"{abs(self.latitude):.4g}°{'N' if self.latitude >= 0 else 'S'}"


def is_local(crs: Any) -> bool:
    """Whether a reference system is one of a site, with no place on a planet."""
    return not _SPHEROID.search(_text(crs))


def true_cell(place: Place, shape: tuple[int, int]) -> TrueCell:
    """The cell in the middle of a raster; its reference system must not be local.

    Raises UnreadableError where the raster lies outside of what its reference system covers.
    """
    from rasterio._err import CPLE_BaseError
    from rasterio.crs import CRS
    from rasterio.errors import RasterioError
    from rasterio.warp import transform

    text = _text(place.crs)
    radius, flattening = (float(number) for number in _SPHEROID.search(text).groups())  # type: ignore[union-attr]
    x = place.west + shape[1] * place.width / 2
    y = place.south + shape[0] * place.height / 2
    xs, ys = [x, x + place.width, x], [y, y, y + place.height]
    try:
        (here, east, north), (low, side, high) = transform(place.crs, CRS.from_wkt(_group(text)), xs, ys)
    except (RasterioError, CPLE_BaseError):
        here = east = north = low = side = high = math.inf
    if not all(map(math.isfinite, (here, east, north, low, side, high))):
        raise UnreadableError(f"has coordinates that its reference system does not cover: {x:.9g}, {y:.9g}")
    turn = math.degrees(_angle(text))
    here, east, north, low, side, high = (turn * angle for angle in (here, east, north, low, side, high))
    meridian, parallel = _radii(low, radius, flattening)
    along_x = _turn(east - here) * parallel, math.radians(side - low) * meridian
    along_y = _turn(north - here) * parallel, math.radians(high - low) * meridian
    turned = math.degrees(math.atan2(*along_y))
    on_earth = abs(radius / EARTH - 1.0) < 0.01
    return TrueCell(math.hypot(*along_x), math.hypot(*along_y), here, low, turned, on_earth)


def _text(crs: Any) -> str:
    return str(crs.to_wkt(version="WKT1_GDAL"))


def _group(text: str) -> str:
    """The geographic reference system that a projected one is made from, as well-known text."""
    start = text.index("GEOGCS[")
    depth = 0
    for at, character in enumerate(text[start:]):
        depth += (character == "[") - (character == "]")
        if character == "]" and not depth:
            return text[start : start + at + 1]
    raise ValueError("well-known text without an end")


def _angle(text: str) -> float:
    """Radians in the unit of a geographic reference system: a degree, or a grad on some old maps."""
    return float(_UNIT.findall(_group(text))[-1])


def _radii(latitude: float, radius: float, flattening: float) -> tuple[float, float]:
    """Radii of meridian and parallel (m) at a latitude; ``flattening`` is the inverse one, 0 of a sphere."""
    part = 1.0 / flattening if flattening else 0.0
    eccentricity = part * (2.0 - part)
    bulge = 1.0 - eccentricity * math.sin(math.radians(latitude)) ** 2
    across = radius / math.sqrt(bulge)
    return across * (1.0 - eccentricity) / bulge, across * math.cos(math.radians(latitude))


def _turn(degrees: float) -> float:
    """A difference of longitudes in radians, the short way round."""
    return math.radians((degrees + 180.0) % 360.0 - 180.0)
