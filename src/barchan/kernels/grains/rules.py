"""What may happen to grains at the bed, as the kernels take it: bounces, entrainment, splash, creep."""

from typing import NamedTuple

import numpy as np


class Bounce(NamedTuple):
    """Bounces off the surface."""

    normal: float
    """Share of the speed across the surface that is kept."""
    tangential: float
    """Share of the speed along the surface that is kept."""
    stop_speed: float
    """Speed (m/s) below which a grain stays where it is."""
    most: int
    """Bounces, or rebounds, after which a grain stays where it lands."""


class Entrainment(NamedTuple):
    """Grains that the wind itself lifts, from anywhere on the bed."""

    probability: float
    """Probability that a free slot tries in an iteration; 0 below the threshold."""
    min_speed: float
    """Least upward speed (m/s)."""
    max_speed: float
    min_angle: float
    """Least angle to the horizontal (rad)."""
    max_angle: float
    wind_x: float
    """Direction to which the wind blows (unit vector)."""
    wind_y: float
    from_lee: bool
    """Whether faces that look downwind give grains too."""
    creeps: np.ndarray | None = None
    """Whether each size class is too heavy to be lifted; None: sand of one size."""


class Creep(NamedTuple):
    """Grains that impacts push along the bed; arrays by size class."""

    number: np.ndarray
    """Parcels set in motion for each m/s of an impact on sand of that size."""
    reach: np.ndarray
    """Distance (cells) that they go against a resistance as great as their weight."""
    threshold: np.ndarray
    """Friction velocity (m/s) near the bed of a wind that keeps them going by itself."""
    friction: float
    """Resistance of the bed over their weight, as a slope (rise over run)."""
    wind_x: float
    """Direction to which the wind blows (unit vector)."""
    wind_y: float
    shelter: float
    """Depth (m) below the shelter surface in which the wind still reaches grains: that surface is not
    recomputed for each grain that leaves."""


class SizeSplash(NamedTuple):
    """Splash by size class: an impact of one class (rows) on parcels of another (columns)."""

    number: np.ndarray
    """Parcels thrown out over those of sand of one size; 0 for classes too heavy."""
    speed: np.ndarray
    """Mean speed of ejecta over that of sand of one size."""


class Splash(NamedTuple):
    """Rebounds and ejecta; angles in rad, speeds in m/s."""

    rebound_probability: float
    """Probability that the fastest grains rebound."""
    rebound_rate: float
    """Growth of that probability with impact speed (s/m)."""
    restitution: float
    """Speed after a rebound over the speed before."""
    rebound_angle: float
    """Mean angle to the surface."""
    number: float
    """Ejecta for each m/s of impact speed."""
    fastest: float
    """Mean speed of ejecta of the fastest impacts."""
    scale: float
    """Impact speed at which the mean speed of ejecta comes near to ``fastest``."""
    ejecta_angle: float
    """Mean angle to the surface."""
    spread: float
    """Half the range of azimuths about the impact's own."""
    creep: Creep | None = None
    """None: impacts push nothing along the bed."""
    by_size: SizeSplash | None = None
    """None: sand of one size."""


class Rules(NamedTuple):
    """What may happen to a grain at the bed."""

    bounce: Bounce
    entrainment: Entrainment
    splash: Splash | None = None
    """None: grains bounce, and impacts throw nothing out."""


class Filter(NamedTuple):
    """The smoothing filter of Wang & Hu."""

    gain: float
    """Share of the difference to the neighbours' mean that is taken away."""
    least: float
    """Difference to the neighbours' mean (parts) from which on the filter works."""
