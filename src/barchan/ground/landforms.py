"""Landforms: hills, valleys, cliffs and slopes made from a few numbers."""

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from barchan.ground.places import LONGEST, SHORTEST, distances, extent, offsets, shares
from barchan.ground.terrain import HIGHEST, TALLEST, Terrain
from barchan.lattice import Lattice
from barchan.parameters import parameter
from barchan.streams import Stream

Side = Literal["west", "east", "south", "north"]

HUMP = "Szabó 2019, Fig. 5.4 b: a two-dimensional Gaussian; its sizes are not published"
DUNE_FORM = "Szabó 2019, Fig. 5.4 c: another Gaussian, a gentle dune; its sizes are not published"
VALLEY = "Szabó 2019, Fig. 5.4 d: a stretched sine; its sizes are not published"


class FlatGround(Terrain):
    """Level ground."""

    kind: Literal["flat"] = parameter("flat", unit="-", meaning="Level ground.")
    level: float = parameter(0.0, unit="m", ge=-HIGHEST, le=HIGHEST, meaning="Elevation of the ground.")

    def elevation(self, lattice: Lattice, _stream: Stream) -> NDArray[np.float64]:
        """Elevation (m) on the lattice."""
        return np.full(lattice.shape, self.level)


class Bump(Terrain):
    """A single rounded hill on level ground."""

    kind: Literal["bump"] = parameter("bump", unit="-", meaning="A single rounded hill with a foot.")
    height: float = parameter(10.0, unit="m", ge=-TALLEST, le=TALLEST, meaning="Height of the hill's top.")
    radius: float = parameter(
        40.0, unit="m", ge=SHORTEST, le=LONGEST, scale="log", meaning="Distance from the top to the foot."
    )
    x: float = parameter(
        0.3, unit="-", ge=0, le=1, meaning="Where the top is, as a fraction of the field from the west."
    )
    y: float = parameter(
        0.5, unit="-", ge=0, le=1, meaning="Where the top is, as a fraction of the field from the south."
    )

    def elevation(self, lattice: Lattice, _stream: Stream) -> NDArray[np.float64]:
        """Elevation (m) on the lattice: a cosine bell."""
        share = np.minimum(distances(lattice, self.x, self.y) / self.radius, 1.0)
        return self.height * 0.5 * (1.0 + np.cos(np.pi * share))


class Hump(Terrain):
    """A smooth hump: a Gaussian hill."""

    kind: Literal["hump"] = parameter("hump", unit="-", meaning="A smooth hump: a Gaussian hill.")
    height: float = parameter(
        15.0, unit="m", ge=-TALLEST, le=TALLEST, meaning="Height of the top.", source=HUMP
    )
    width: float = parameter(
        25.0,
        unit="m",
        ge=SHORTEST,
        le=LONGEST,
        scale="log",
        meaning="Standard deviation of the Gaussian.",
        source=HUMP,
    )
    x: float = parameter(
        0.5, unit="-", ge=0, le=1, meaning="Where the top is, as a fraction of the field from the west."
    )
    y: float = parameter(
        0.5, unit="-", ge=0, le=1, meaning="Where the top is, as a fraction of the field from the south."
    )

    def elevation(self, lattice: Lattice, _stream: Stream) -> NDArray[np.float64]:
        """Elevation (m) on the lattice."""
        return self.height * _bell(distances(lattice, self.x, self.y) / self.width)


class DuneForm(Terrain):
    """Ground in the form of a gentle dune: a Gaussian longer along its crest than across it."""

    kind: Literal["dune_form"] = parameter(
        "dune_form", unit="-", meaning="A gentle dune: a Gaussian longer along its crest than across it."
    )
    height: float = parameter(
        10.0, unit="m", ge=-TALLEST, le=TALLEST, meaning="Height of the top.", source=DUNE_FORM
    )
    length: float = parameter(
        60.0,
        unit="m",
        ge=SHORTEST,
        le=LONGEST,
        scale="log",
        meaning="Standard deviation along the crest.",
        source=DUNE_FORM,
    )
    width: float = parameter(
        30.0,
        unit="m",
        ge=SHORTEST,
        le=LONGEST,
        scale="log",
        meaning="Standard deviation across the crest.",
        source=DUNE_FORM,
    )
    crest: float = parameter(
        0.0, unit="degrees", ge=0, lt=180, meaning="Azimuth of the crest, clockwise from north."
    )
    x: float = parameter(
        0.5, unit="-", ge=0, le=1, meaning="Where the top is, as a fraction of the field from the west."
    )
    y: float = parameter(
        0.5, unit="-", ge=0, le=1, meaning="Where the top is, as a fraction of the field from the south."
    )

    def elevation(self, lattice: Lattice, _stream: Stream) -> NDArray[np.float64]:
        """Elevation (m) on the lattice."""
        east, north = offsets(lattice, self.x, self.y)
        sine, cosine = np.sin(np.radians(self.crest)), np.cos(np.radians(self.crest))
        along, across = sine * east + cosine * north, cosine * east - sine * north
        return self.height * _bell(np.hypot(along / self.length, across / self.width))


class Valley(Terrain):
    """A gentle valley: one wave of a sine over the field."""

    kind: Literal["valley"] = parameter("valley", unit="-", meaning="A gentle valley: one wave of a sine.")
    depth: float = parameter(
        10.0, unit="m", ge=0, le=TALLEST, meaning="From the edges down to the floor.", source=VALLEY
    )
    runs: Literal["east-west", "north-south"] = parameter(
        "north-south", unit="-", meaning="The direction in which the valley runs."
    )

    def elevation(self, lattice: Lattice, _stream: Stream) -> NDArray[np.float64]:
        """Elevation (m) on the lattice: zero at the edges, lowest in the middle."""
        across = _from_side(lattice, "west" if self.runs == "north-south" else "south")
        return -self.depth * 0.5 * (1.0 - np.cos(2.0 * np.pi * across))


class Cliff(Terrain):
    """A plateau with upright walls, across the whole field."""

    kind: Literal["cliff"] = parameter("cliff", unit="-", meaning="A plateau with upright walls.")
    height: float = parameter(10.0, unit="m", ge=0, le=TALLEST, meaning="Height of the plateau.")
    faces: Side = parameter("west", unit="-", meaning="Where the first wall faces.")
    foot: float = parameter(
        0.4,
        unit="-",
        ge=0,
        le=1,
        meaning="Where the first wall stands, as a fraction of the field from the side it faces.",
    )
    length: float = parameter(
        0.4,
        unit="-",
        ge=0,
        le=1,
        meaning="From the first wall to the one behind, as a fraction of the field; the plateau ends at "
        "the field's edge at the latest.",
    )

    def elevation(self, lattice: Lattice, _stream: Stream) -> NDArray[np.float64]:
        """Elevation (m) on the lattice."""
        along = _from_side(lattice, self.faces)
        on_top = (along >= self.foot) & (along < self.foot + self.length)
        return np.where(on_top, self.height, 0.0)


class Escarpment(Terrain):
    """A steep face and behind it a gentle slope down to the edge of the field."""

    kind: Literal["escarpment"] = parameter(
        "escarpment", unit="-", meaning="A steep face, and a gentle slope down behind it."
    )
    height: float = parameter(10.0, unit="m", ge=0, le=TALLEST, meaning="Height of the edge.")
    face_angle: float = parameter(
        45.0, unit="degrees", ge=1, le=89, meaning="How steep the face is, from the horizontal."
    )
    faces: Side = parameter("west", unit="-", meaning="Where the face looks.")
    foot: float = parameter(
        0.3,
        unit="-",
        ge=0,
        le=1,
        meaning="Where the face begins, as a fraction of the field from the side it looks to.",
    )

    def elevation(self, lattice: Lattice, _stream: Stream) -> NDArray[np.float64]:
        """Elevation (m) on the lattice."""
        width, height = extent(lattice)
        length = width if self.faces in ("west", "east") else height
        along = _from_side(lattice, self.faces) * length
        foot = self.foot * length
        face = (along - foot) * np.tan(np.radians(self.face_angle))
        behind = self.height * (length - along) / max(length - foot, lattice.cell_size)
        return np.clip(np.minimum(face, behind), 0.0, self.height)


class Ramp(Terrain):
    """An even slope from edge to edge; where those edges are joined, it ends in an upright drop."""

    kind: Literal["ramp"] = parameter("ramp", unit="-", meaning="An even slope from edge to edge.")
    height: float = parameter(10.0, unit="m", ge=0, le=TALLEST, meaning="Height over the rest of the field.")
    faces: Side = parameter("west", unit="-", meaning="The side where it is lowest.")

    def elevation(self, lattice: Lattice, _stream: Stream) -> NDArray[np.float64]:
        """Elevation (m) on the lattice."""
        return self.height * _from_side(lattice, self.faces)


def _bell(distance: NDArray[np.float64]) -> NDArray[np.float64]:
    """A Gaussian of height one, at a distance in standard deviations."""
    return np.exp(-0.5 * distance**2)


def _from_side(lattice: Lattice, side: Side) -> NDArray[np.float64]:
    """Distance of the cells' centres from a side, as a fraction of the field."""
    x, y = shares(lattice)
    if side in ("east", "north"):
        # counted from the other end, so that opposite slopes mirror each other to the last bit
        x, y = x[:, ::-1] - 2.0 * lattice.shift[:, None] / lattice.width, y[::-1]
    return np.broadcast_to(x if side in ("west", "east") else y, lattice.shape).copy()
