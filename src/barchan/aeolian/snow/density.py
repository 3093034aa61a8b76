"""How dense snow falls, how dense the wind lays it down, and how it packs under its own weight."""

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

LEAST_DENSITY, GREATEST_DENSITY = 30.0, 917.0
"""Densities (kg/m³) of the lightest fresh snow and of ice."""


def hedstrom_pomeroy(temperature: float, _wind: float) -> float:
    """Density (kg/m³) of fresh snow: 67.92 + 51.25 exp(T / 2.59) (Hedstrom & Pomeroy 1998)."""
    return 67.92 + 51.25 * math.exp(min(temperature, 0.0) / 2.59)


def clm5(temperature: float, wind: float) -> float:
    """Density (kg/m³) of fresh snow by air temperature and wind at 10 m (van Kampenhout et al. 2017)."""
    if temperature > 2.0:
        calm = 50.0 + 1.7 * 17.0**1.5
    elif temperature > -15.0:
        calm = 50.0 + 1.7 * (temperature + 15.0) ** 1.5
    else:
        calm = -3.8328 * temperature - 0.0333 * temperature**2
    return calm + 266.861 * (0.5 * (1.0 + math.tanh(wind / 5.0))) ** 8.8


def pahaut(temperature: float, wind: float) -> float:
    """Density (kg/m³) of fresh snow: 109 + 6 T + 26 √U, at least 50 (Pahaut 1976)."""
    return max(109.0 + 6.0 * temperature + 26.0 * math.sqrt(wind), 50.0)


FRESH_DENSITIES: dict[str, Callable[[float, float], float]] = {
    "hedstrom_pomeroy": hedstrom_pomeroy,
    "clm5": clm5,
    "pahaut": pahaut,
}
"""Densities of fresh snow by name, of air temperature (°C) and wind (m/s at 10 m)."""


def drift_density(wind_at_3m: float, least: float, greatest: float) -> float:
    """Density (kg/m³) of snow that the wind lays down: 33 + 361 log10 U (Groot Zwaaftink et al. 2013)."""
    found = 33.0 + 361.0 * math.log10(max(wind_at_3m, 1e-9))
    return min(max(found, least), greatest)


def vionnet_viscosity(density: NDArray[np.float64], temperature: float) -> NDArray[np.float64]:
    """Viscosity (Pa s) of dry snow, 7.62237e6 · 4 · ρ / 450 exp(0.1 (-T) + 0.023 ρ) (Vionnet et al. 2012)."""
    cold = 0.1 * max(-temperature, 0.0)
    return 7.62237e6 * 4.0 * density / 450.0 * np.exp(cold + 0.023 * density)


def anderson_viscosity(density: NDArray[np.float64], temperature: float) -> NDArray[np.float64]:
    """Viscosity (Pa s) of snow under load, 9e5 exp(0.08 (-T) + 0.023 ρ) (Anderson 1976)."""
    return 9e5 * np.exp(0.08 * max(-temperature, 0.0) + 0.023 * density)


def anderson_settling(density: NDArray[np.float64], temperature: float) -> NDArray[np.float64]:
    """Rate (1/s) at which fresh crystals break down, 2.778e-6 exp(-0.04 (-T) - 0.046 (ρ - 100)+)."""
    cold = 0.04 * max(-temperature, 0.0)
    return 2.778e-6 * np.exp(-cold - 0.046 * np.maximum(density - 100.0, 0.0))


def no_settling(density: NDArray[np.float64], _temperature: float) -> NDArray[np.float64]:
    """No packing but that under load."""
    return np.zeros_like(density)


Closure = Callable[[NDArray[np.float64], float], NDArray[np.float64]]

PACKING: dict[str, tuple[Closure, Closure]] = {
    "vionnet": (vionnet_viscosity, no_settling),
    "anderson": (anderson_viscosity, anderson_settling),
}
"""Viscosity (Pa s) and settling without load (1/s), by name, of density and temperature."""
