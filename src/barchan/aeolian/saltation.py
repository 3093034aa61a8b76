"""The sand that a wind meets: from a wind speed to a flux."""

from typing import Literal, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import model_validator

from barchan.aeolian.flux import LawName, Sorting, mass_flux
from barchan.aeolian.flux import Sand as FluxSand
from barchan.aeolian.grains import THRESHOLDS, Numbers, settling_speed
from barchan.aeolian.sand import Air, Sand
from barchan.aeolian.wall import Speed, friction_velocity, grain_roughness, speed_at
from barchan.parameters import NOT_GIVEN, parameter


class Saltation(Air, Sand):
    """Sand, air, roughness and the law of the flux: from a wind speed to the sand that it moves.

    A speed U at ``height`` gives the friction velocity u* by the law of the wall, u* and its threshold give
    the flux by ``law``. No law moves anything at or below the threshold.
    """

    sorting: Sorting = parameter(
        "dune",
        unit="-",
        meaning="Grains of one size, as on dunes, or of many sizes; for the laws of Bagnold and tsoar.",
        source="Bagnold (1941)",
    )
    law: LawName = parameter("kawamura", unit="-", meaning="The flux law.", source="Kawamura (1951)")
    threshold: float | None = parameter(
        None,
        unit="m/s",
        gt=0,
        le=100,
        meaning="Wind speed at its height above which sand moves; from the grains where it is not given.",
    )
    threshold_law: Literal["shao_lu", "bagnold"] = parameter(
        "shao_lu",
        unit="-",
        acts_with={"threshold": NOT_GIVEN},
        meaning="How the threshold follows from the grains: with cohesion or without.",
        source="Shao & Lu (2000); Bagnold (1941)",
    )
    roughness: float | None = parameter(
        1e-3,
        unit="m",
        gt=0,
        le=1,
        meaning="Roughness length of the ground; null: a 30th of the grain diameter. It changes u* much: "
        "10 m/s at 10 m are u* = 0.43 m/s over 1 mm, 0.29 m/s over grains of 0.25 mm at rest.",
        source="the value used with reanalyses in pydune; sand in saltation",
    )
    height: float = parameter(
        10.0, unit="m", gt=0, le=1000, meaning="Height of the wind speed.", source="meteorological stations"
    )

    @model_validator(mode="after")
    def _stands_in_the_wind(self) -> Self:
        if self.roughness_length >= self.height:
            raise ValueError(
                f"height is {self.height:g} m; "
                f"allowed: above the roughness length, {self.roughness_length:g} m"
            )
        return self

    @property
    def sand(self) -> FluxSand:
        """Sand and air as the laws ask for them."""
        return FluxSand(self.grain_diameter, self.grain_density, self.air_density, self.sorting)

    @property
    def roughness_length(self) -> float:
        """Roughness length (m)."""
        return grain_roughness(self.grain_diameter) if self.roughness is None else self.roughness

    @property
    def settling_speed(self) -> float:
        """How fast a grain falls through still air (m/s)."""
        return float(settling_speed(self.grain_diameter, self.grain_density, self.air_density))

    def friction_velocity(self, speed: Numbers) -> Numbers:
        """Friction velocity (m/s) of a wind speed (m/s)."""
        return friction_velocity(speed, self.height, self.roughness_length)

    def threshold_friction_velocity(self) -> float:
        """Friction velocity (m/s) above which sand moves."""
        if self.threshold is not None:
            return float(self.friction_velocity(self.threshold))
        law = THRESHOLDS[self.threshold_law]
        return float(law(self.grain_diameter, self.grain_density, self.air_density))

    def threshold_speed(self) -> float:
        """Wind speed (m/s) at ``height`` above which sand moves."""
        if self.threshold is not None:
            return self.threshold
        return speed_at(self.threshold_friction_velocity(), self.height, self.roughness_length)

    def at_own_height(self, speed: Speed, height: float | None) -> Speed:
        """Wind speeds (m/s) at a height (m) as they are at its own ``height``, by the law of the wall.

        A height of None is its own. Raises ValueError at a height within the roughness length.
        """
        if height is None or height == self.height:
            return speed
        if height <= self.roughness_length:
            raise ValueError(
                f"the record's height is {height:g} m; allowed: above the roughness length, "
                f"{self.roughness_length:g} m"
            )
        return speed_at(
            friction_velocity(speed, height, self.roughness_length), self.height, self.roughness_length
        )

    def mass_flux(self, speed: Numbers) -> NDArray[np.float64]:
        """Mass of sand per time and metre of width (kg/m/s) under wind speeds (m/s)."""
        return mass_flux(
            self.law, self.friction_velocity(speed), self.threshold_friction_velocity(), self.sand
        )

    def volume_flux(self, speed: Numbers) -> NDArray[np.float64]:
        """Volume of sand as it lies, with pores, per time and metre of width (m²/s)."""
        return self.mass_flux(speed) / (self.grain_density * (1.0 - self.porosity))
