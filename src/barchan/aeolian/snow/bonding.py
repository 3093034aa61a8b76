"""Bonds between snow grains: how fast they grow, and how strong a wind they withstand."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.parameters import parameter

GAS_CONSTANT = 8.314462618
"""Molar gas constant (J/mol/K)."""

FREEZING = 273.15
"""Melting point of ice (K)."""

REFERENCE_TEMPERATURE = -10.0
"""Temperature (°C) at which an hour of bonding counts as one hour."""

ICE_DENSITY = 917.0
"""Density of ice (kg/m³)."""

LI_POMEROY_RATIO = 0.03697
"""Friction velocity over the wind at 10 m in the threshold winds of Li & Pomeroy (1997)."""

WET_THRESHOLD = 9.9
"""Threshold wind (m/s) of wet snow (Li & Pomeroy 1997)."""

LOOSEST_BONDS = 0.1
"""Age (h) below which bonds are not told apart."""

Numbers = float | NDArray[np.float64]


def activation_energy_parameter() -> Any:
    """The parameter of every model whose snow bonds faster when it is warm."""
    return parameter(
        41_000.0,
        unit="J/mol",
        ge=0,
        le=200_000,
        live=True,
        meaning="Activation energy of bonding: how much faster warm snow bonds.",
        source="Bahaloo et al. 2022; 38.8 kJ/mol in SNOWPACK, 51 through the vapour",
    )


def bonding_rate(temperature: Numbers, activation_energy: float) -> Numbers:
    """Speed at which bonds grow, over that at -10 °C: exp[E / R (1 / 263.15 K - 1 / T)].

    ``activation_energy`` E in J/mol. Sintering of ice takes 41 kJ/mol (Bahaloo et al. 2022), equi-temperature
    growth of bonds in SNOWPACK 38.8, the path through the vapour 51.
    """
    reference = FREEZING + REFERENCE_TEMPERATURE
    kelvin = FREEZING + np.asarray(temperature, np.float64)
    return np.exp(activation_energy / GAS_CONSTANT * (1.0 / reference - 1.0 / kelvin))


def coordination_number(density: Numbers) -> NDArray[np.float64]:
    """Mean number of bonds of a grain, by the density of the snow (SNOWPACK, Lehning et al. 2002)."""
    rho = np.asarray(density, np.float64)
    middle = 1.4153 - 7.5580e-5 * rho + 5.1495e-5 * rho**2 - 1.7345e-7 * rho**3 + 1.8082e-10 * rho**4
    return np.where(rho <= 100.0, 1.75 * rho / 100.0, np.where(rho <= 670.0, middle, 10.5))


def weight_threshold(grain_radius: float, sphericity: float) -> float:
    """Shear stress (Pa) that the weight of unbonded grains withstands: 0.02 ρ_ice g r (sphericity + 1).

    The first term of the threshold of Schmidt (1980) as in SNOWPACK (Lehning et al. 2000); radius in m.
    """
    return 0.02 * ICE_DENSITY * 9.81 * grain_radius * (sphericity + 1.0)


def hourly_threshold_wind(temperature: float) -> float:
    """Threshold wind (m/s at 10 m) of snow one hour old (Li & Pomeroy 1997); of wet snow above 0 °C."""
    if temperature > 0.0:
        return WET_THRESHOLD
    return 9.43 + 0.18 * temperature + 0.0033 * temperature**2


def threshold_stress(
    density: Numbers,
    age: Numbers,
    temperature: float,
    *,
    air_density: float,
    weight: float,
    exponent: float,
) -> NDArray[np.float64]:
    """Shear stress (Pa) above which the wind takes snow of a density from a bed of an age.

        τ_w + τ_b N(ρ) / N(100) t^n,    τ_b = ρ_a (0.03697 U(T))² - τ_w

    with the ``weight`` term τ_w (Pa), the coordination number N, the age t in hours of bonding at -10 °C, at
    least 0.1, and Li & Pomeroy's threshold wind U of snow at 100 kg/m³ and one hour.
    """
    hourly = max(air_density * (LI_POMEROY_RATIO * hourly_threshold_wind(temperature)) ** 2 - weight, 0.0)
    bonds = coordination_number(density) / coordination_number(100.0)
    aged = np.maximum(np.asarray(age, np.float64), LOOSEST_BONDS) ** exponent
    return np.asarray(weight + hourly * bonds * aged)
