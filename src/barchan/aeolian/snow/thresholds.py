"""Thresholds of drifting snow that ask for less than bonds: for temperature and time, or density alone."""

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.snow.bonding import ICE_DENSITY, LOOSEST_BONDS, Numbers

_MAR_FRICTION, _MAR_DENSITY = 0.211, 300.0
"""Threshold friction velocity (m/s) of snow of a density (kg/m³) in the model MAR."""

_COMPACT = 300.0
"""Density (kg/m³) from which the threshold of SnowTran-3D rises steeply."""

_ICE_OF_MAR = 920.0


def li_pomeroy_median(temperature: float, hours: Numbers) -> NDArray[np.float64]:
    """Wind (m/s at 10 m) at which dry snow drifts in half of all cases (Li & Pomeroy 1997b).

    11 + 0.365 T + 0.00706 T² + 0.91 ln t, by air temperature T (°C, at most 0) and the time t (h, at least
    0.1) since it fell.
    """
    cold = min(temperature, 0.0)
    aged = np.log(np.maximum(np.asarray(hours, np.float64), LOOSEST_BONDS))
    return np.asarray(11.0 + 0.365 * cold + 0.00706 * cold**2 + 0.91 * aged)


def li_pomeroy_spread(temperature: float) -> float:
    """Standard deviation (m/s) of these winds: 4.23 + 0.145 T + 0.00196 T²."""
    cold = min(temperature, 0.0)
    return 4.23 + 0.145 * cold + 0.00196 * cold**2


def normal_share(deviations: float) -> float:
    """Share of a normal distribution below its mean and so many standard deviations."""
    return 0.5 * math.erfc(-deviations / math.sqrt(2.0))


def snowtran(density: Numbers) -> NDArray[np.float64]:
    """Threshold friction velocity (m/s), 0.1 e^(0.003 ρ), from 300 kg/m³ on 0.005 e^(0.013 ρ).

    As in SnowTran-3D (Liston et al. 2007).
    """
    rho = np.asarray(density, np.float64)
    return np.where(rho <= _COMPACT, 0.10 * np.exp(0.003 * rho), 0.005 * np.exp(0.013 * rho))


def mar(density: Numbers) -> NDArray[np.float64]:
    """Threshold friction velocity (m/s), 0.211 exp(n₀/(1 - n₀) - n/(1 - n)), n the porosity.

    n₀ is that of 300 kg/m³; as in the regional climate model MAR (Gallée et al. 2001).
    """
    porosity = 1.0 - np.minimum(np.asarray(density, np.float64), ICE_DENSITY) / _ICE_OF_MAR
    usual = 1.0 - _MAR_DENSITY / _ICE_OF_MAR
    return np.asarray(_MAR_FRICTION * np.exp(usual / (1.0 - usual) - porosity / (1.0 - porosity)))


BY_DENSITY: dict[str, Callable[[Numbers], NDArray[np.float64]]] = {"snowtran": snowtran, "mar": mar}
"""Threshold friction velocities (m/s) by name, of the density (kg/m³)."""
