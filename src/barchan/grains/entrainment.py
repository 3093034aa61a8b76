"""Aerodynamic entrainment: grains that the wind itself lifts off the bed."""

import math
from typing import ClassVar, Self

from pydantic import model_validator

from barchan.directions import downwind
from barchan.grains.closure import Closure, Setting
from barchan.kernels.grains.rules import Entrainment as EntrainmentRule
from barchan.parameters import parameter


class Entrainment(Closure):
    """Grains that the wind itself lifts, above the threshold."""

    key: ClassVar[str] = "entrainment"

    probability: float = parameter(
        1.0,
        unit="-",
        ge=0,
        le=1,
        live=True,
        meaning="Probability that the wind lifts a parcel into a free slot in an iteration, if the cell that "
        "is drawn can give one.",
        source="Szabó 2019, listing 5.2: every free slot tries",
    )
    min_lift_speed: float = parameter(
        0.8,
        unit="-",
        gt=0,
        le=10,
        live=True,
        meaning="Least upward speed of a lifted grain, over the friction velocity.",
        source="Szabó 2019, eq. 3.2: B from 0.8 to 2",
    )
    max_lift_speed: float = parameter(
        2.0,
        unit="-",
        gt=0,
        le=10,
        live=True,
        meaning="Greatest upward speed of a lifted grain, over the friction velocity.",
        source="Szabó 2019, eq. 3.2: B from 0.8 to 2",
    )
    min_lift_angle: float = parameter(
        21.0,
        unit="degrees",
        ge=1,
        le=89,
        live=True,
        meaning="Least angle of lift-off to the horizontal.",
        source="Prague thesis, §4.3",
    )
    max_lift_angle: float = parameter(
        89.0,
        unit="degrees",
        ge=1,
        le=89,
        live=True,
        meaning="Greatest angle of lift-off to the horizontal.",
        source="Prague thesis, §4.3: near 90",
    )
    from_lee: bool = parameter(
        False,
        unit="-",
        live=True,
        meaning="Whether faces that look downwind give grains too.",
        source="false: Szabó 2019, listing 5.2; true: Prague thesis",
    )

    @model_validator(mode="after")
    def _ranges_in_order(self) -> Self:
        for name, unit in (("lift_speed", ""), ("lift_angle", " degrees")):
            low, high = getattr(self, f"min_{name}"), getattr(self, f"max_{name}")
            if high < low:
                raise ValueError(f"max_{name} {high:g} is below min_{name} {low:g}{unit}")
        return self

    def struct(self, setting: Setting, probability: float | None = None) -> EntrainmentRule:
        """Entrainment as kernels take it, with another ``probability`` if one is given."""
        rules, ustar = setting.rules, setting.ustar
        wind_x, wind_y = downwind(setting.direction)
        chance = self.probability if probability is None else probability
        return EntrainmentRule(
            probability=chance if ustar > rules.threshold() else 0.0,
            min_speed=self.min_lift_speed * ustar,
            max_speed=self.max_lift_speed * ustar,
            min_angle=math.radians(self.min_lift_angle),
            max_angle=math.radians(self.max_lift_angle),
            wind_x=wind_x,
            wind_y=wind_y,
            from_lee=self.from_lee,
            creeps=rules.too_heavy(ustar) if rules.size_classes else None,
        )


NO_ENTRAINMENT = EntrainmentRule(0.0, 1.0, 1.0, 1.0, 1.0, 1.0, 0.0, False)
"""The rule of a model whose wind lifts nothing."""
