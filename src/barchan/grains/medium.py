"""The parameters of one grain in air, beside its physics: thresholds, drag and settling."""

from collections.abc import Sequence
from typing import Literal, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import model_validator

from barchan.aeolian.flux import IMPACT_RATIO
from barchan.aeolian.grains import GRAVITY, VISCOSITY, drag_rate, natural_drag, shao_lu, terminal_speed
from barchan.aeolian.sand import Air, Sand
from barchan.grains.closure import Composition
from barchan.grains.sizes import SizeClass, Sizes, mean_diameter
from barchan.parameters import parameter, redeclared


class GrainInAir(Composition, Air, Sand):
    """Sand and air."""

    grain_diameter: float = redeclared(
        Sand, "grain_diameter", 0.15e-3, "Szabó 2019, §4.2; Prague thesis, §4.3 (printed there as 15 mm)"
    )
    grain_density: float = redeclared(Sand, "grain_density", 2655.0, "Prague thesis, §4.3")
    porosity: float = redeclared(Sand, "porosity", 0.40, "Szabó 2019, Table 4.1")
    air_density: float = redeclared(Air, "air_density", 1.1644, "Prague thesis, §4.3: at 30 °C")

    viscosity: float = parameter(
        VISCOSITY,
        unit="Pa s",
        gt=0,
        le=1e-2,
        group="air",
        acts_with={"drag": "reynolds"},
        meaning="Dynamic viscosity of the air, for drag that depends on the Reynolds number.",
        source="air at 15 to 20 °C",
    )
    gravity: float = parameter(
        9.81,
        unit="m/s²",
        gt=0,
        le=100,
        group="air",
        meaning="Acceleration of gravity.",
        source="Prague thesis, §4.3",
    )
    drag: Literal["constant", "reynolds"] = parameter(
        "constant",
        unit="-",
        group="air",
        meaning="Drag coefficient: one for all, or that of natural sand by its Reynolds number.",
        source="constant: Prague thesis, eq. 4.9; reynolds: Cheng 1997",
    )
    drag_coefficient: float = parameter(
        0.5,
        unit="-",
        gt=0,
        le=10,
        group="air",
        acts_with={"drag": "constant"},
        meaning="The constant drag coefficient.",
        source="Prague thesis, §4.3: a rough sphere",
    )

    threshold_velocity: float | None = parameter(
        None,
        unit="m/s",
        gt=0,
        le=10,
        group="sand",
        meaning="Friction velocity at which the wind begins to lift grains of mean diameter; by the law of "
        "Shao & Lu where not given. Other sizes lie as far above or below as by that law.",
        source="Shao & Lu 2000",
    )

    @model_validator(mode="after")
    def _heavier_than_air(self) -> Self:
        if self.grain_density <= 2.0 * self.air_density:
            raise ValueError(
                f"grain_density {self.grain_density:g} kg/m³ is not twice air_density "
                f"{self.air_density:g} kg/m³; allowed: grains that fall"
            )
        return self

    @property
    def size_classes(self) -> list[SizeClass]:
        """The size classes of the sand, finest first; none: all grains have one size."""
        sizes = self.part(Sizes)
        return [] if sizes is None else sizes.of(self.grain_diameter)

    @property
    def diameters(self) -> Sequence[float]:
        """Diameters (m) of the size classes, finest first; of sand of one size its diameter."""
        return [one.diameter for one in self.size_classes] or [self.grain_diameter]

    @property
    def diameter(self) -> float:
        """Mean diameter (m) of the grains, by volume."""
        classes = self.size_classes
        return mean_diameter(classes) if classes else self.grain_diameter

    def threshold(self, diameter: float | None = None) -> float:
        """Friction velocity (m/s) at which the wind begins to lift grains, by default of mean diameter."""
        size = self.diameter if diameter is None else diameter
        by_law = self._shao_lu(size)
        if self.threshold_velocity is None:
            return by_law
        return self.threshold_velocity * by_law / self._shao_lu(self.diameter)

    def _shao_lu(self, diameter: float) -> float:
        weight = self.grain_density * self.gravity / GRAVITY
        return float(shao_lu(diameter, weight, self.air_density))

    def impact_threshold(self, diameter: float | None = None) -> float:
        """Friction velocity (m/s) at which impacts keep grains going."""
        return IMPACT_RATIO * self.threshold(diameter)

    def too_heavy(self, ustar: float) -> NDArray[np.bool_]:
        """Whether the wind cannot keep each size class in the air: it is below its impact threshold.

        Sand of one size splashes under any wind.
        """
        if not self.size_classes:
            return np.zeros(1, np.bool_)
        return np.array([self.impact_threshold(one) > ustar for one in self.diameters])

    def drag_rate(self, speed: NDArray[np.float64], diameter: float | None = None) -> NDArray[np.float64]:
        """Rate (1/s) at which drag takes a velocity difference ``speed`` (m/s) away."""
        size = self.diameter if diameter is None else diameter
        coefficient: NDArray | float = self.drag_coefficient
        if self.drag == "reynolds":
            coefficient = natural_drag(speed, size, self.viscosity / self.air_density)
        return drag_rate(speed, coefficient, size, self.grain_density, self.air_density)

    def settling_speed(self, diameter: float | None = None) -> float:
        """Speed (m/s) of steady fall in still air."""
        return terminal_speed(lambda speed: self.drag_rate(speed, diameter), self.gravity)
