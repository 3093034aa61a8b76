"""Single heaps of sand: cone, block, mound, patch."""

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from barchan.ground.layer import Layer, mean_of
from barchan.ground.places import LONGEST, SHORTEST, distances, offsets
from barchan.lattice import Lattice
from barchan.parameters import parameter
from barchan.streams import Stream


class Heap(Layer):
    """Sand heaped on a layer, which is bare ground unless stated."""

    mean: float = mean_of(0.0, "Sand around and under the heap.")
    height: float = parameter(8.0, unit="m", ge=0, le=1e4, meaning="Height of the heap over that layer.")
    x: float = parameter(
        0.5, unit="-", ge=0, le=1, meaning="Where its middle is, as a fraction of the field from the west."
    )
    y: float = parameter(
        0.5, unit="-", ge=0, le=1, meaning="Where its middle is, as a fraction of the field from the south."
    )


class Cone(Heap):
    """A cone of sand."""

    kind: Literal["cone"] = parameter("cone", unit="-", meaning="A cone of sand.")
    radius: float = parameter(
        20.0, unit="m", ge=SHORTEST, le=LONGEST, scale="log", meaning="Distance from the top to the foot."
    )

    def relief(self, lattice: Lattice, _stream: Stream) -> NDArray[np.float64]:
        """Height (m) over the layer."""
        return self.height * np.maximum(1.0 - distances(lattice, self.x, self.y) / self.radius, 0.0)


class Block(Heap):
    """A rectangular block of sand, whose walls slide to rest at the start."""

    kind: Literal["block"] = parameter(
        "block", unit="-", meaning="A rectangular block of sand, whose walls slide to rest at the start."
    )
    length_x: float = parameter(
        40.0, unit="m", ge=SHORTEST, le=LONGEST, scale="log", meaning="From west to east."
    )
    length_y: float = parameter(
        40.0, unit="m", ge=SHORTEST, le=LONGEST, scale="log", meaning="From south to north."
    )

    def relief(self, lattice: Lattice, _stream: Stream) -> NDArray[np.float64]:
        """Height (m) over the layer."""
        east, north = offsets(lattice, self.x, self.y)
        inside = (2.0 * np.abs(east) < self.length_x) & (2.0 * np.abs(north) < self.length_y)
        return np.where(inside, self.height, 0.0)


class Mound(Heap):
    """A smooth mound of sand: a Gaussian."""

    kind: Literal["mound"] = parameter("mound", unit="-", meaning="A smooth mound of sand: a Gaussian.")
    width: float = parameter(
        20.0, unit="m", ge=SHORTEST, le=LONGEST, scale="log", meaning="Standard deviation of the Gaussian."
    )

    def relief(self, lattice: Lattice, _stream: Stream) -> NDArray[np.float64]:
        """Height (m) over the layer."""
        return self.height * np.exp(-0.5 * (distances(lattice, self.x, self.y) / self.width) ** 2)


class Patch(Heap):
    """A round, even patch of sand."""

    kind: Literal["patch"] = parameter("patch", unit="-", meaning="A round, even patch of sand.")
    height: float = parameter(2.0, unit="m", ge=0, le=1e4, meaning="Depth of the patch over that layer.")
    radius: float = parameter(
        50.0, unit="m", ge=SHORTEST, le=LONGEST, scale="log", meaning="Radius of the patch."
    )

    def relief(self, lattice: Lattice, _stream: Stream) -> NDArray[np.float64]:
        """Height (m) over the layer."""
        return np.where(distances(lattice, self.x, self.y) < self.radius, self.height, 0.0)
