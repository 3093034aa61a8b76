"""Closures of drifting snow: groups of parameters of the wind's part, each of which can be switched off."""

from typing import Literal, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import model_validator

from barchan.aeolian.snow.bonding import weight_threshold
from barchan.aeolian.snow.density import GREATEST_DENSITY, LEAST_DENSITY, drift_density
from barchan.aeolian.snow.drift import FLUX_LAWS, FRICTION_LAWS, STRESS_POWERS, WINDS, log_law
from barchan.aeolian.wall import speed_at
from barchan.parameters import NOT_GIVEN, Parameters, parameter


class Drift(Parameters):
    """Drifting snow: how hard the wind pulls, how much it carries, and how dense it lays it down."""

    friction: Literal["log", "saltating"] = parameter(
        "log",
        unit="-",
        meaning="Friction velocity of a wind: by the law of the wall, or 0.02264 U^1.295, which holds the "
        "roughness that saltation adds.",
        source="log: law of the wall; saltating: Pomeroy & Gray 1990",
    )
    roughness: float = parameter(
        2.4e-4,
        unit="m",
        ge=1e-7,
        le=0.1,
        meaning="Roughness length of flat snow.",
        source="ours: the value that rescal-snow uses, measured at Niwot Ridge",
    )
    flux: Literal["sorensen", "pomeroy_gray"] = parameter(
        "sorensen",
        unit="-",
        meaning="Law of the saturated flux, which gives a step its duration.",
        source="sorensen: Sørensen 2004, Vionnet et al. 2014; pomeroy_gray: Pomeroy & Gray 1990",
    )
    density: float | None = parameter(
        None,
        unit="kg/m³",
        ge=LEAST_DENSITY,
        le=GREATEST_DENSITY,
        meaning="Density of snow that the wind lays down; by the wind where it is not given.",
        source="33 + 361 log10 U at 3 m: Groot Zwaaftink et al. 2013",
    )
    least_density: float = parameter(
        150.0,
        unit="kg/m³",
        ge=LEAST_DENSITY,
        le=GREATEST_DENSITY,
        acts_with={"density": NOT_GIVEN},
        meaning="Least density of drift that follows the wind.",
        source="ours",
    )
    greatest_density: float = parameter(
        400.0,
        unit="kg/m³",
        ge=LEAST_DENSITY,
        le=GREATEST_DENSITY,
        acts_with={"density": NOT_GIVEN},
        meaning="Greatest density of drift that follows the wind.",
        source="ours: dunes of 380 to 500 kg/m³ (Birnbaum et al. 2010) have packed further",
    )

    @model_validator(mode="after")
    def _ordered(self) -> Self:
        if self.least_density > self.greatest_density:
            raise ValueError(
                f"least_density is {self.least_density:g} kg/m³, above greatest_density, "
                f"{self.greatest_density:g} kg/m³"
            )
        return self

    def friction_velocity(self, wind: float) -> float:
        """Friction velocity (m/s) of a wind (m/s at 10 m)."""
        return FRICTION_LAWS[self.friction](wind, self.roughness)

    def laid_density(self, wind: float) -> float:
        """Density (kg/m³) of drift that a wind (m/s at 10 m) lays down."""
        if self.density is not None:
            return self.density
        at_3m = speed_at(log_law(wind, self.roughness), 3.0, self.roughness)
        return drift_density(at_3m, self.least_density, self.greatest_density)

    def mass_flux(self, ustar: float, threshold: float, air_density: float) -> float:
        """Saturated flux (kg/m/s)."""
        return float(FLUX_LAWS[self.flux](ustar, threshold, air_density))  # type: ignore[arg-type]

    @property
    def stress_power(self) -> float:
        """Power of the stress with which the wind grows."""
        return STRESS_POWERS[self.friction]

    def speed_of(self, ustar: NDArray[np.float64]) -> NDArray[np.float64]:
        """Winds (m/s at 10 m) of friction velocities (m/s)."""
        return WINDS[self.friction](ustar, self.roughness)


class Threshold(Parameters):
    """The wind that snow withstands."""

    law: Literal["bonds", "li_pomeroy", "snowtran", "mar"] = parameter(
        "bonds",
        unit="-",
        meaning="What the threshold follows from. bonds: weight of the grains, and bonds by age, temperature "
        "and density; li_pomeroy: a chance to give by time and temperature, normal about a median wind; "
        "snowtran, mar: density alone.",
        source="bonds: see the documentation; Li & Pomeroy 1997b; snowtran: Liston et al. 2007; mar: Gallée "
        "et al. 2001",
    )

    grain_radius: float = parameter(
        1.5e-4,
        unit="m",
        ge=1e-5,
        le=2e-3,
        meaning="Radius of the grains.",
        source="Lehning et al. 2000: grains of 0.3 mm",
    )
    sphericity: float = parameter(
        0.5,
        unit="-",
        ge=0,
        le=1,
        meaning="Roundness of the grains: 0.5 fallen, 0.75 broken by the wind.",
        source="Lehning et al. 2000",
    )

    @property
    def weight(self) -> float:
        """Shear stress (Pa) that the weight of loose grains withstands."""
        return weight_threshold(self.grain_radius, self.sphericity)


class Relief(Parameters):
    """The wind over relief: shear stress by linear theory."""

    acts: bool = parameter(
        True,
        unit="-",
        live=True,
        meaning="Whether relief changes the stress; without, it is uniform.",
        source="ours",
    )
    every: int = parameter(
        5,
        unit="steps",
        ge=1,
        le=1000,
        meaning="Steps after which the stress is computed again.",
        source="ours: less than a hundredth of a dune's turnover",
    )
    smoothing: float = parameter(
        2.0,
        unit="cells",
        ge=0,
        le=100,
        live=True,
        meaning="Width over which the surface is smoothed before its stress is computed.",
        source="ours",
    )
    saturation_angle: float = parameter(
        20.0,
        unit="degrees",
        ge=1,
        le=89,
        live=True,
        meaning="Windward slope above which the stress no longer grows.",
        source="Pelletier 2009, abstract: about 20 degrees",
    )


class SnowCreep(Parameters):
    """Grains that roll down a slope after they have landed."""

    law: Literal["impacts", "threshold"] = parameter(
        "impacts",
        unit="-",
        live=True,
        meaning="Law of creep. impacts: every impact of saltating grains pushes grains down the slope, so "
        "that the flux of creep is the flux of saltation times slope times gain; threshold: grains that land "
        "roll to the lowest neighbour the more often the nearer the wind is to its threshold, on any slope.",
        source="impacts: flux of reptation in proportion to impacts (Anderson 1987) and reduced by the slope "
        "(Yizhaq et al. 2004); threshold: ours",
    )
    gain: float = parameter(
        1.0,
        unit="-",
        ge=0,
        le=20,
        live=True,
        meaning="Flux of creep down a slope of one, over the flux of saltation, where creep follows impacts; "
        "0: nothing rolls.",
        source="ours, see the calibration in the documentation",
    )
    strength: float = parameter(
        0.8,
        unit="-",
        ge=0,
        le=10,
        live=True,
        meaning="Chance to roll times the excess of the stress over its impact threshold, over that "
        "threshold, where creep follows the threshold; 0: nothing rolls.",
        source="ours, from the effect of slope on the threshold",
    )
    greatest: float = parameter(
        0.8, unit="-", ge=0, le=1, live=True, meaning="Greatest chance to roll.", source="ours"
    )


class Abrasion(Parameters):
    """Bonded snow worn by drift where it stands out of the bed."""

    rate: float = parameter(
        0.02,
        unit="-",
        ge=0,
        le=1,
        live=True,
        meaning="Mass worn off an exposed face for each mass of drift that hits it, of snow that withstands "
        "0.09 Pa; 0: no abrasion.",
        source="ours, within a factor 3: steps retreat 0.1 to 0.3 m/h at a friction velocity of 1 m/s",
    )
    height: float = parameter(
        0.03,
        unit="m",
        gt=0,
        le=10,
        live=True,
        meaning="Height of the saltation layer, above which faces are worn no faster.",
        source="ours: mass decays within centimetres of the bed",
    )
