"""The law of the wall: wind speed by height, over a bed and in a layer of grains."""

import math
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

KARMAN = 0.4
"""The constant of von Kármán."""

Speed = TypeVar("Speed", float, NDArray[np.float64], float | NDArray[np.float64])

REFERENCE_HEIGHT = 10.0
"""Height (m) at which wind speeds are stated."""


def grain_roughness(diameter: float) -> float:
    """Roughness length (m) of a bed of grains at rest, a 30th of their diameter (m; Bagnold 1941)."""
    return diameter / 30.0


def friction_velocity(speed: Speed, height: float, roughness: float, displacement: float = 0.0) -> Speed:
    """Friction velocity (m/s) of a wind speed (m/s) at a height (m): the law of the wall, solved for it."""
    return speed * KARMAN / math.log((height - displacement) / roughness)


def speed_at(ustar: float, height: float, roughness: float) -> float:
    """Wind speed (m/s) at a height (m) of a friction velocity (m/s)."""
    return ustar * math.log(height / roughness) / KARMAN


def log_wind(height: NDArray, friction: float, roughness: float, displacement: float = 0.0) -> NDArray:
    """Wind speed (m/s) at heights (m) above the surface: the law of the wall, calm below the roughness."""
    ratio = np.maximum((height - displacement) / roughness, 1.0)
    return friction / KARMAN * np.log(ratio)


def unstable_wind(
    height: NDArray, friction: float, roughness: float, displacement: float, stability: float
) -> NDArray:
    """The law of the wall with ``stability`` (m/s) added to the speed above the roughness."""
    speed = log_wind(height, friction, roughness, displacement)
    return speed + np.where(speed > 0.0, stability, 0.0)


def focused_wind(
    height: NDArray, friction: float, least: float, roughness: float, focus: float, displacement: float
) -> NDArray:
    """Wind speed (m/s) in a layer of grains: below ``focus`` (m) that of the friction velocity ``least``.

    The grains take up what the wind exceeds the impact threshold by, so near the bed all winds are equal and
    their profiles meet at the focus (Bagnold 1941; Ungar & Haff 1987).
    """
    near = log_wind(height, min(least, friction), roughness, displacement)
    at_focus = float(log_wind(np.array(focus), min(least, friction), roughness, displacement))
    return np.where(
        height < focus, near, at_focus + above_focus(height, friction, roughness, focus, displacement)
    )


def above_focus(
    height: NDArray, friction: float, roughness: float, focus: float, displacement: float
) -> NDArray:
    """Wind speed (m/s) gained above the focus (m)."""
    ratio = np.maximum((height - displacement) / max(focus - displacement, roughness), 1.0)
    return friction / KARMAN * np.log(ratio)
