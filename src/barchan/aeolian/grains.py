"""One grain in the air: how fast it falls, and how strong a wind sets it off.

Lengths in m, densities in kg/m³, speeds in m/s; grain diameters may be numbers or arrays.
"""

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

GRAVITY = 9.81
"""Acceleration of gravity (m/s²)."""

VISCOSITY = 1.81e-5
"""Dynamic viscosity of air at 15–20 °C (Pa s); it hardly changes with density."""

Numbers = float | NDArray[np.float64]


def shao_lu(diameter: Numbers, grain_density: float, air_density: float) -> Numbers:
    """Threshold friction velocity with cohesion.

    u_t = √(0.0123 (s g d + γ / (ρ d))), s = ρ_grain / ρ, γ = 3·10⁻⁴ kg/s² (Shao & Lu 2000, J. Geophys. Res.
    105, 22437). It has a minimum near 0.08 mm: finer grains cling together.
    """
    weight = grain_density / air_density * GRAVITY * diameter
    return np.sqrt(0.0123 * (weight + 3e-4 / (air_density * diameter)))


def bagnold_threshold(diameter: Numbers, grain_density: float, air_density: float) -> Numbers:
    """Threshold friction velocity without cohesion, 0.1 √((s - 1) g d), s = ρ_grain / ρ (Bagnold 1941)."""
    return 0.1 * np.sqrt((grain_density / air_density - 1.0) * GRAVITY * diameter)


THRESHOLDS: dict[str, Callable[[Numbers, float, float], Numbers]] = {
    "shao_lu": shao_lu,
    "bagnold": bagnold_threshold,
}
"""Threshold friction velocities by name."""


def settling_speed(
    diameter: Numbers, grain_density: float, air_density: float, viscosity: float = VISCOSITY
) -> Numbers:
    """How fast a grain falls through still air.

    w d / ν = (√(25 + 1.2 D²) - 5)^1.5, D = d ((s - 1) g / ν²)^(1/3) (Cheng 1997, J. Hydraul. Eng. 123, 149):
    the balance of weight and the drag coefficient ((32 / Re)^(2/3) + 1)^1.5 of natural grains.
    """
    kinematic = viscosity / air_density
    size = diameter * ((grain_density / air_density - 1.0) * GRAVITY / kinematic**2) ** (1 / 3)
    return kinematic / diameter * (np.sqrt(25.0 + 1.2 * size**2) - 5.0) ** 1.5


def natural_drag(speed: NDArray, diameter: float, viscosity: float) -> NDArray:
    """Drag coefficient of natural sand, ((32 / Re)^(2/3) + 1)^1.5 (Cheng 1997, J. Hydraul. Eng. 123, 149)."""
    reynolds = np.maximum(speed * diameter / viscosity, 1e-12)
    return ((32.0 / reynolds) ** (2.0 / 3.0) + 1.0) ** 1.5


def drag_rate(
    speed: NDArray, coefficient: NDArray | float, diameter: float, density: float, air_density: float
) -> NDArray:
    """Rate (1/s) at which drag takes a velocity difference ``speed`` (m/s) away (Prague thesis, eq. 4.9)."""
    return 0.75 * air_density / (density * diameter) * coefficient * speed


def terminal_speed(rate: Callable[[NDArray], NDArray], gravity: float) -> float:
    """Speed (m/s) of steady fall in still air, where drag at that ``rate`` bears the weight."""
    low, high = 1e-6, 1e3
    for _ in range(100):
        middle = math.sqrt(low * high)
        falls_faster = float(rate(np.array(middle))) * middle < gravity
        low, high = (middle, high) if falls_faster else (low, middle)
    return low
