"""Creep: impacts push grains along the bed."""

import math
from typing import ClassVar

import numpy as np

from barchan.directions import downwind
from barchan.grains.closure import Closure, Setting
from barchan.grains.parameters import GrainFlight
from barchan.kernels.grains.rules import Creep as CreepRule
from barchan.lattice import Lattice
from barchan.parameters import parameter


def calm_depth(rules: GrainFlight, lattice: Lattice) -> float:
    """Depth (m) below the shelter surface in which the wind still reaches the bed: it is not exact."""
    return max(rules.diameter, rules.carried * lattice.thickness)


class Creep(Closure):
    """Grains that impacts push along the bed."""

    key: ClassVar[str] = "creep"

    momentum: float = parameter(
        0.6,
        unit="-",
        ge=0,
        le=1,
        live=True,
        meaning="Share of the impact's momentum that pushes grains along the bed.",
        source="ours: the share that rebounds (0.3) and ejecta (0.1) leave",
    )
    speed: float = parameter(
        1.41,
        unit="-",
        gt=0,
        le=20,
        live=True,
        meaning="Speed at which pushed grains start, over √(g d).",
        source="ours: faster ones would rise over their neighbours, by a diameter, and fly",
    )

    def struct(self, setting: Setting, ejecta_momentum: float) -> CreepRule:
        """Creep as kernels take it.

        Size classes too heavy to be thrown out take the momentum of ejecta as well.
        """
        rules, lattice = setting.rules, setting.lattice
        diameters = np.array(rules.diameters)
        speed = self.speed * np.sqrt(rules.gravity * diameters)
        momentum = self.momentum + np.where(rules.too_heavy(setting.ustar), ejecta_momentum, 0.0)
        wind_x, wind_y = downwind(setting.direction)
        return CreepRule(
            number=momentum / speed,
            reach=speed**2 / (2.0 * rules.gravity * lattice.cell_size),
            threshold=np.array([rules.impact_threshold(one) for one in rules.diameters]),
            friction=math.tan(math.radians(rules.repose_angle)),
            wind_x=wind_x,
            wind_y=wind_y,
            shelter=calm_depth(rules, lattice),
        )
