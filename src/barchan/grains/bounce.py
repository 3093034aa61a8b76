"""Bounces: grains are reflected off the surface, damped, until they are slow."""

from typing import ClassVar

from barchan.grains.closure import Closure
from barchan.kernels.grains.rules import Bounce as BounceRule
from barchan.parameters import parameter


class Bounce(Closure):
    """Damped reflection off the surface."""

    key: ClassVar[str] = "bounce"

    normal_damping: float = parameter(
        0.3,
        unit="-",
        ge=0,
        le=1,
        live=True,
        meaning="Share of the speed across the surface that a bounce leaves.",
        source="ours: f_atten of Szabó 2019, eq. 3.9, has no value there",
    )
    tangential_damping: float = parameter(
        0.4,
        unit="-",
        ge=0,
        le=1,
        live=True,
        meaning="Share of the speed along the surface that a bounce leaves.",
        source="ours: f_frac of Szabó 2019, eq. 3.9, has no value there",
    )
    stop_speed: float = parameter(
        0.3,
        unit="m/s",
        ge=0,
        le=100,
        live=True,
        meaning="A grain that would leave a bounce slower than this stays where it is.",
        source="ours: Szabó 2019 and the Prague thesis have a threshold without a number",
    )

    def struct(self, most: int) -> BounceRule:
        """Bounces as kernels take them, ``most`` for each grain."""
        return BounceRule(self.normal_damping, self.tangential_damping, self.stop_speed, most)
