"""Wang & Hu's model: grains that fly, bounce and build ripples, as both seeds made it."""

import math
from typing import Any, ClassVar, Literal, Self

from pydantic import model_validator

from barchan.directions import downwind
from barchan.grains.air import log_table
from barchan.grains.model import GrainModel
from barchan.grains.parameters import GrainFlight
from barchan.kernels.grains.state import Bounce, LiftOff
from barchan.parameters import parameter
from barchan.wind.segment import Segment


class WangHuParameters(GrainFlight):
    """Parameters of Wang & Hu's model: lift-off anywhere, bounces with damping."""

    kind_key: ClassVar[str] = "name"

    name: Literal["wang_hu"] = parameter("wang_hu", unit="-", meaning="Wang & Hu's model.")
    lift_least: float = parameter(
        0.8,
        unit="-",
        gt=0,
        le=10,
        live=True,
        group="lift-off",
        meaning="Least upward speed of a lifted grain, over the friction velocity.",
        source="seed 003, eq. 3.2: B from 0.8 to 2",
    )
    lift_most: float = parameter(
        2.0,
        unit="-",
        gt=0,
        le=10,
        live=True,
        group="lift-off",
        meaning="Greatest upward speed of a lifted grain, over the friction velocity.",
        source="seed 003, eq. 3.2: B from 0.8 to 2",
    )
    flattest: float = parameter(
        21.0,
        unit="degrees",
        ge=1,
        le=89,
        live=True,
        group="lift-off",
        meaning="Least angle of lift-off to the horizontal.",
        source="seed 000, §4.3",
    )
    steepest: float = parameter(
        89.0,
        unit="degrees",
        ge=1,
        le=89,
        live=True,
        group="lift-off",
        meaning="Greatest angle of lift-off to the horizontal.",
        source="seed 000, §4.3: near 90",
    )
    lift_from_lee: bool = parameter(
        False,
        unit="-",
        live=True,
        group="lift-off",
        meaning="Whether faces that look downwind give grains too.",
        source="false: seed 003, listing 5.2; true: seed 000",
    )
    normal_damping: float = parameter(
        0.3,
        unit="-",
        ge=0,
        le=1,
        live=True,
        group="bounce",
        meaning="Share of the speed across the surface that a bounce leaves.",
        source="ours: f_atten of seed 003, eq. 3.9, has no value there",
    )
    tangential_damping: float = parameter(
        0.4,
        unit="-",
        ge=0,
        le=1,
        live=True,
        group="bounce",
        meaning="Share of the speed along the surface that a bounce leaves.",
        source="ours: f_frac of seed 003, eq. 3.9, has no value there",
    )
    stop_speed: float = parameter(
        0.3,
        unit="m/s",
        ge=0,
        le=100,
        live=True,
        group="bounce",
        meaning="A grain that would leave a bounce slower than this stays where it is.",
        source="ours: seeds 000 and 003 have a threshold without a number",
    )

    @model_validator(mode="after")
    def _ranges_in_order(self) -> Self:
        if self.lift_most < self.lift_least:
            raise ValueError(f"lift_most {self.lift_most:g} is below lift_least {self.lift_least:g}")
        if self.steepest < self.flattest:
            raise ValueError(f"steepest {self.steepest:g} is below flattest {self.flattest:g} degrees")
        return self


class WangHu(GrainModel):
    """Grains that the wind lifts anywhere and that bounce until they are slow.

    In each iteration every grain in the air flies for ``time_step``: gravity and drag change its velocity
    in a wind that follows the law of the wall over the surface below it. A grain below the surface

    * bounces: the part of its velocity across the surface is turned round and damped, and so is the part
      along it;
    * or stays, where it would be slower than ``stop_speed`` then, and raises the bed by a parcel.

    Slots without a grain draw a cell. Where it holds sand and does not face downwind, a parcel is lifted with
    an upward speed of B times the friction velocity and an angle drawn evenly, along the wind. Below the
    threshold none is. Every few iterations slopes above the angle of repose slide.

    With ``clock`` "step" grains fly one after the other from lift-off to rest, as in seed 000.

    A parcel is one unit of the bed: a grain diameter high over a whole cell. Known deviations: Wang & Hu's
    papers were read in the words of the two seeds only; both damping factors, the stopping speed, the time
    step and the filter's factors stand in neither.
    """

    name = "wang_hu"
    title = "Wang & Hu 2012"
    citation = (
        "Wang, N. and Hu, B.-G. (2012). Real-time simulation of aeolian sand movement and sand ripple "
        "evolution: a method based on the physics of blown sand. Journal of Computer Science and "
        "Technology 27(1), 135-146; after seeds 000 and 003."
    )
    Parameters = WangHuParameters
    parameters: WangHuParameters

    def wind_tables(self, friction: float) -> tuple[Any, Any]:
        """Those of the law of the wall, which all winds of a speed share."""
        rules = self.parameters
        return log_table(friction, rules.roughness_length, rules.displacement, rules.stability), None

    def lift_off(self, wind: Segment, chance: float = 1.0) -> Any:
        """From anywhere, with a speed and an angle drawn evenly."""
        rules = self.parameters
        friction = rules.friction_velocity(self.speed(wind))
        return LiftOff(
            chance if self.moves(wind) else 0.0,
            *(rules.lift_least * friction, rules.lift_most * friction),
            *(math.radians(rules.flattest), math.radians(rules.steepest)),
            *downwind(wind.direction),
            rules.lift_from_lee,
        )

    def fastest(self) -> float:
        """The greatest upward speed (m/s) of lift-off."""
        return self.parameters.lift_most * self.parameters.friction_velocity(self.parameters.wind_speed)

    def bounce(self) -> Any:
        """Damped reflection off the surface."""
        rules = self.parameters
        return Bounce(rules.normal_damping, rules.tangential_damping, rules.stop_speed, rules.max_bounces)
