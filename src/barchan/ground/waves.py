"""Ripples and transverse dunes laid out before the wind blows."""

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from barchan.errors import Problem, ScenarioError
from barchan.ground.layer import Layer, mean_of
from barchan.ground.places import LONGEST, SHORTEST, extent, shares
from barchan.lattice import Lattice
from barchan.parameters import parameter
from barchan.streams import Stream

SOURCE = "Prague thesis, §6.5.2; the number is ours"


class Waves(Layer):
    """Sand in parallel waves."""

    wavelength: float = parameter(
        8.0,
        unit="m",
        ge=SHORTEST,
        le=LONGEST,
        scale="log",
        meaning="From crest to crest; changed slightly so that whole waves fit between joined edges.",
        source=SOURCE,
    )
    direction: float = parameter(
        270.0,
        unit="degrees",
        ge=0,
        lt=360,
        meaning="The wind that they lie across: where it comes from, clockwise from north.",
    )

    def phase(self, lattice: Lattice) -> NDArray[np.float64]:
        """Waves passed on the way down the wind, from the south-west corner."""
        waves = []
        heading = np.radians(self.direction)
        joined = (lattice.boundary_x == "periodic", lattice.boundary_y == "periodic")
        for length, part, closed in zip(
            extent(lattice), (-np.sin(heading), -np.cos(heading)), joined, strict=True
        ):
            count = length * part / self.wavelength
            waves.append(np.rint(count) if closed else count)
        if not any(waves):
            message = f"is {self.wavelength:g} m; allowed: waves of which the field holds at least one"
            raise ScenarioError([Problem("sand.wavelength", message)])
        along_x, along_y = shares(lattice)
        return waves[0] * along_x + waves[1] * along_y


class RippledSand(Waves):
    """Sand ripples: sinusoidal waves."""

    kind: Literal["ripples"] = parameter("ripples", unit="-", meaning="Sinusoidal sand ripples.")
    amplitude: float = parameter(
        0.5, unit="m", ge=0, le=1e4, meaning="Height of the crests over the mean.", source=SOURCE
    )

    def relief(self, lattice: Lattice, _stream: Stream) -> NDArray[np.float64]:
        """Height (m) over the layer."""
        return self.amplitude * np.sin(2.0 * np.pi * self.phase(lattice))


class TransverseSand(Waves):
    """Transverse dunes: a long stoss side and a short lee side."""

    kind: Literal["transverse"] = parameter(
        "transverse", unit="-", meaning="Transverse dunes with a long stoss side and a short lee side."
    )
    mean: float = mean_of(10.0, "Mean sand on a cell; depths are rounded to whole slabs.")
    wavelength: float = parameter(
        32.0,
        unit="m",
        ge=SHORTEST,
        le=LONGEST,
        scale="log",
        meaning="From crest to crest; changed slightly so that whole waves fit between joined edges.",
        source=SOURCE,
    )
    height: float = parameter(5.0, unit="m", ge=0, le=1e4, meaning="From trough to crest.", source=SOURCE)
    stoss: float = parameter(
        0.7, unit="-", ge=0.05, le=0.95, meaning="Share of the wavelength that rises.", source=SOURCE
    )

    def relief(self, lattice: Lattice, _stream: Stream) -> NDArray[np.float64]:
        """Height (m) over the layer."""
        share = self.phase(lattice) % 1.0
        return self.height * (np.minimum(share / self.stoss, (1.0 - share) / (1.0 - self.stoss)) - 0.5)
