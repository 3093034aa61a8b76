"""Closures of snow at rest: groups of parameters of bonds, snowfall, packing and repose."""

from typing import Literal

from barchan.aeolian.snow.bonding import activation_energy_parameter
from barchan.aeolian.snow.density import FRESH_DENSITIES, GREATEST_DENSITY, LEAST_DENSITY
from barchan.parameters import NOT_GIVEN, Parameters, parameter


class Bonding(Parameters):
    """Bonds that grow between grains at rest."""

    grows: bool = parameter(
        True,
        unit="-",
        live=True,
        meaning="Whether bonds grow; without, all snow stays as loose as after six minutes at -10 °C.",
        source="ours",
    )
    exponent: float = parameter(
        0.27,
        unit="-",
        ge=0,
        le=1,
        meaning="Exponent of time in the growth of bonds.",
        source="between 0.18 (strength) and 0.36 (area of bonds) of van Herwijnen & Miller 2013, fixed on "
        "the medians of Li & Pomeroy 1997",
    )
    activation_energy: float = activation_energy_parameter()
    loose_hours: float = parameter(
        3.0,
        unit="h",
        ge=0.1,
        le=240,
        live=True,
        meaning="Age, in hours at -10 °C, from which snow counts as bonded.",
        source="ours",
    )
    detachment: float = parameter(
        2.0,
        unit="-",
        ge=0,
        le=10,
        live=True,
        meaning="Exponent of the detachment factor: bonded snow yields less by the threshold of fresh drift "
        "over its own, to this power.",
        source="ours: 0.05 after five days, the rate of rescal-snow",
    )
    impact_mass: float = parameter(
        0.0,
        unit="kg/m²",
        ge=0,
        le=100,
        live=True,
        acts_with={"grows": True},
        meaning="Mass of loose snow at the surface whose bonds impacts of drift break as fast as they grow, "
        "where the stress keeps drift going and nothing shelters; 0: bonds grow under drift too.",
        source="ours, a design with an assumed depth, after Sommer et al. 2018: no hardening while snow "
        "erodes",
    )


class Snowfall(Parameters):
    """Snow that falls."""

    density_law: Literal["hedstrom_pomeroy", "clm5", "pahaut"] = parameter(
        "hedstrom_pomeroy",
        unit="-",
        live=True,
        acts_with={"density": NOT_GIVEN},
        meaning="Density of fresh snow by air temperature and wind; snow that falls in drift lands as drift.",
        source="Hedstrom & Pomeroy 1998; van Kampenhout et al. 2017; Pahaut 1976",
    )
    density: float | None = parameter(
        None,
        unit="kg/m³",
        ge=LEAST_DENSITY,
        le=GREATEST_DENSITY,
        live=True,
        meaning="Density of fresh snow; by density_law where it is not given.",
        source="ours",
    )

    def fresh_density(self, temperature: float, wind: float) -> float:
        """Density (kg/m³) of snow that falls at an air temperature (°C) in a wind (m/s at 10 m)."""
        if self.density is not None:
            return self.density
        found = FRESH_DENSITIES[self.density_law](temperature, wind)
        return min(max(found, LEAST_DENSITY), GREATEST_DENSITY)


class Packing(Parameters):
    """Snow that packs under its own weight; masses do not change."""

    law: Literal["vionnet", "anderson", "none"] = parameter(
        "vionnet",
        unit="-",
        live=True,
        meaning="Law of the viscosity of snow under load; none: densities do not change.",
        source="Vionnet et al. 2012; Anderson 1976",
    )


class Repose(Parameters):
    """How steep snow stands."""

    drift: float = parameter(
        38.0,
        unit="degrees",
        ge=5,
        le=89,
        live=True,
        meaning="Angle of repose of loose drift.",
        source="ours, after the 35 to 38 degrees of rescal-snow",
    )
    fallen: float = parameter(
        60.0,
        unit="degrees",
        ge=5,
        le=89,
        live=True,
        meaning="Angle of repose of dry fallen snow.",
        source="ours, between that of drift and of fresh crystals",
    )
    wet: float = parameter(
        25.0,
        unit="degrees",
        ge=5,
        le=89,
        live=True,
        meaning="Angle of repose of loose snow above 0 °C.",
        source="ours, between dry snow and slush, 15 degrees",
    )
    fallen_below: float = parameter(
        150.0,
        unit="kg/m³",
        ge=0,
        le=917,
        live=True,
        meaning="Density below which loose snow counts as fallen, not drifted.",
        source="ours",
    )
