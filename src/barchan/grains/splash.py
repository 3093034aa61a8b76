"""Splash: grains that hit the bed rebound, and throw others out of it."""

import math
from typing import ClassVar

import numpy as np

from barchan.grains.closure import Closure, Setting
from barchan.grains.creep import Creep
from barchan.kernels.grains.rules import SizeSplash
from barchan.kernels.grains.rules import Splash as SplashRule
from barchan.parameters import parameter


class Splash(Closure):
    """Rebounds and ejecta."""

    key: ClassVar[str] = "splash"

    rebound_probability: float = parameter(
        0.95,
        unit="-",
        ge=0,
        le=1,
        live=True,
        meaning="Probability that the fastest grains rebound.",
        source="Anderson & Haff 1991",
    )
    rebound_speed_scale: float = parameter(
        1.0,
        unit="m/s",
        gt=0,
        le=100,
        live=True,
        meaning="Impact speed at which the probability of a rebound has grown to 0.63 of its greatest value.",
        source="Kok & Renno 2009, after Anderson & Haff 1991: of the order of 1",
    )
    restitution: float = parameter(
        0.55,
        unit="-",
        ge=0,
        le=1,
        live=True,
        meaning="Speed after a rebound over the speed of impact.",
        source="Kok & Renno 2009",
    )
    rebound_angle: float = parameter(
        40.0,
        unit="degrees",
        gt=0,
        le=89,
        live=True,
        meaning="Mean angle of rebounds to the surface, of an exponential distribution below 90.",
        source="Kok & Renno 2009",
    )
    ejecta_per_speed: float = parameter(
        0.02,
        unit="-",
        ge=0,
        le=1,
        live=True,
        meaning="Grains thrown out by an impact for each √(g d) of impact speed.",
        source="Kok & Renno 2009: 0.01 to 0.03",
    )
    ejecta_momentum: float = parameter(
        0.15,
        unit="-",
        ge=0,
        le=1,
        live=True,
        meaning="Share of the impact's momentum that the ejecta of fast impacts take.",
        source="Kok & Renno 2009",
    )
    ejecta_speed_scale: float = parameter(
        40.0,
        unit="-",
        gt=0,
        le=1000,
        live=True,
        meaning="Impact speed, over √(g d), from which on the speed of ejecta hardly grows.",
        source="Kok & Renno 2009",
    )
    ejecta_angle: float = parameter(
        50.0,
        unit="degrees",
        gt=0,
        le=89,
        live=True,
        meaning="Mean angle of ejecta to the surface, of an exponential distribution below 90.",
        source="Kok & Renno 2009",
    )
    azimuth_spread: float = parameter(
        15.0,
        unit="degrees",
        ge=0,
        le=180,
        live=True,
        meaning="Rebounds and ejecta turn to either side of the impact's azimuth by up to this angle.",
        source="ours",
    )

    def struct(self, setting: Setting) -> SplashRule:
        """Splash as kernels take it, with the model's creep and size classes."""
        rules = setting.rules
        unit = math.sqrt(rules.gravity * rules.diameter)
        number = self.ejecta_per_speed
        creep = rules.part(Creep)
        return SplashRule(
            rebound_probability=self.rebound_probability,
            rebound_rate=1.0 / self.rebound_speed_scale,
            restitution=self.restitution,
            rebound_angle=math.radians(self.rebound_angle),
            number=number / unit,
            fastest=self.ejecta_momentum / number * unit if number else 0.0,
            scale=self.ejecta_speed_scale * unit,
            ejecta_angle=math.radians(self.ejecta_angle),
            spread=math.radians(self.azimuth_spread),
            creep=None if creep is None else creep.struct(setting, self.ejecta_momentum),
            by_size=splash_by_size(setting) if rules.size_classes else None,
        )


def splash_by_size(setting: Setting) -> SizeSplash:
    """Number and speed of ejecta by the size class that hits (rows) and the one that is hit (columns).

    A parcel holds grains in proportion to 1 / d³, so (d_i / d_s) ejected grains for each grain that hits are
    (d_s / d_i)² parcels.
    """
    diameters = np.array(setting.rules.diameters)
    ratio = diameters / diameters[:, None]
    too_heavy = setting.rules.too_heavy(setting.ustar)
    return SizeSplash(np.where(too_heavy, 0.0, ratio**2), np.minimum(ratio**-2, 1.0))
