"""Drifting snow: friction velocity over snow, and the flux of saltation."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.grains import GRAVITY
from barchan.aeolian.wall import REFERENCE_HEIGHT, friction_velocity, speed_at

_SALTATING, _EXPONENT = 0.02264, 1.295
"""Coefficient and exponent of Pomeroy & Gray (1990)."""

IMPACT_STRESS = 0.64
"""Stress at which drift dies out over the stress that starts it: friction velocities as 0.8 to 1."""


def log_law(wind: float, roughness: float) -> float:
    """Friction velocity (m/s) of a wind (m/s at 10 m) over a roughness length (m)."""
    return friction_velocity(wind, REFERENCE_HEIGHT, roughness)


def saltating(wind: float, _roughness: float) -> float:
    """Friction velocity (m/s) over snow that saltates, 0.02264 U^1.295 (Pomeroy & Gray 1990)."""
    return float(_SALTATING * wind**_EXPONENT)


FRICTION_LAWS: dict[str, Callable[[float, float], float]] = {"log": log_law, "saltating": saltating}
"""Friction velocity (m/s) by name, of the wind (m/s at 10 m) and the roughness length (m)."""


def log_wind(ustar: NDArray[np.float64], roughness: float) -> NDArray[np.float64]:
    """Winds (m/s at 10 m) of friction velocities (m/s) over a roughness length (m): ``log_law`` inverted."""
    return speed_at(ustar, REFERENCE_HEIGHT, roughness)


def saltating_wind(ustar: NDArray[np.float64], _roughness: float) -> NDArray[np.float64]:
    """Winds (m/s at 10 m) of friction velocities (m/s) over snow that saltates: ``saltating`` inverted."""
    return np.asarray((ustar / _SALTATING) ** (1.0 / _EXPONENT))


WINDS: dict[str, Callable[[NDArray[np.float64], float], NDArray[np.float64]]] = {
    "log": log_wind,
    "saltating": saltating_wind,
}
"""Winds (m/s at 10 m) by name, of friction velocities (m/s) and the roughness length (m)."""


STRESS_POWERS: dict[str, float] = {"log": 0.5, "saltating": 0.5 / _EXPONENT}
"""Power of the shear stress with which the wind grows, by name of the friction law."""


def sorensen(ustar: NDArray[np.float64], threshold: float, air_density: float) -> NDArray[np.float64]:
    """Mass flux (kg/m/s), (ρ_a / g) u*³ (1 - V⁻²) (2.6 + 2.5 V⁻² + 2 V⁻¹), V = u* / u*_t; 0 below.

    Sørensen (2004) with the coefficients of Vionnet et al. (2014).
    """
    u = np.maximum(np.asarray(ustar, np.float64), threshold)
    below = threshold / u
    flux = air_density / GRAVITY * u**3 * (1.0 - below**2) * (2.6 + 2.5 * below**2 + 2.0 * below)
    return np.asarray(flux)


def pomeroy_gray(ustar: NDArray[np.float64], threshold: float, air_density: float) -> NDArray[np.float64]:
    """Mass flux (kg/m/s), 0.68 (ρ_a / (u* g)) u*_t (u*² - u*_t²) (Pomeroy & Gray 1990); 0 below."""
    u = np.maximum(np.asarray(ustar, np.float64), threshold)
    return np.asarray(0.68 * air_density / GRAVITY * threshold / u * (u**2 - threshold**2))


FLUX_LAWS: dict[str, Callable[[NDArray[np.float64], float, float], NDArray[np.float64]]] = {
    "sorensen": sorensen,
    "pomeroy_gray": pomeroy_gray,
}
"""Mass flux (kg/m/s) by name, of friction velocity, its threshold (m/s) and air density (kg/m³)."""
