"""The wind of a model of grains: its speed, how it blows over a bed, and what it does to grains."""

from collections.abc import Sequence
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.flow_over_relief import ReliefWind
from barchan.grains import checks
from barchan.grains.air import air_of, drag_table, wind_profile
from barchan.grains.bed import GrainGround
from barchan.grains.closure import Setting
from barchan.grains.cost import work_of_step
from barchan.grains.creep import Creep
from barchan.grains.parameters import GrainFlight
from barchan.grains.relief_flow import ReliefFlow
from barchan.grains.wind_feedback import WindFeedback
from barchan.kernels.grains.air_state import Air, Table
from barchan.model import Model
from barchan.wind.segment import Segment

ANY_DIRECTION = 270.0
"""A wind direction where none matters."""


class WindOverGrains(Model):
    """What a model of grains knows of the wind."""

    parameters: GrainFlight
    feedback: WindFeedback | None

    def change(self, parameters: Any) -> None:
        """Take new parameters from now on."""
        super().change(parameters)
        self.__dict__.pop("_drag_table", None)

    def wind_facts(self, speeds: Sequence[float]) -> dict[str, str]:
        """Friction velocity of the winds, and the threshold."""
        return checks.wind_facts(self.parameters, speeds or [self.parameters.wind_speed])

    def setting(self, wind: Segment | None = None) -> Setting:
        """Parameters, lattice and wind for closures."""
        direction = ANY_DIRECTION if wind is None else wind.direction
        return Setting(
            self.parameters, self.lattice, direction, self.parameters.friction_velocity(self.speed(wind))
        )

    def blow(self, ground: GrainGround, wind: Segment) -> Air:
        """Recompute the wind over the ground, and its effect on grains."""
        setting, relief = self.setting(wind), self.parameters.part(ReliefFlow)
        near_bed, over_relief = np.asarray(setting.ustar), ReliefWind()
        if relief is not None:
            surface = ground.arrays.height.reshape(self.lattice.shape)
            over_relief = relief.over(surface, setting)
            ground.bend_wind(over_relief)
        if self.feedback is not None:
            near_bed = self.feedback.near_bed_ustar(setting.ustar)
            if self.feedback.closure.varies_in_space:
                ground.slow(near_bed)
        if self.parameters.part(Creep) is not None:
            ground.drag(near_bed, over_relief)
        ground.roughen(setting.ustar)
        return air_of(setting, self.feedback, self._drag_table)

    @cached_property
    def _drag_table(self) -> Table:
        return drag_table(self.parameters)

    def wind_profile(self, height: NDArray[np.float64], ustar: float) -> NDArray[np.float64]:
        """Wind speed (m/s) at heights (m) above the surface, for a friction velocity ``ustar`` (m/s)."""
        return wind_profile(self.parameters, height, ustar, self.feedback)

    def speed(self, wind: Segment | None) -> float:
        """Speed of the wind (m/s at 10 m); a calm has none."""
        if wind is not None and wind.polls == 0:
            return 0.0
        if wind is None or wind.speed is None:
            return self.parameters.wind_speed
        return wind.speed

    def friction_velocity(self, wind: Segment) -> float:
        """Friction velocity (m/s) over a flat bed."""
        return self.setting(wind).ustar

    def expected_work(self, segment: Segment) -> float:
        """The grains expected in the air, times iterations; of complete trajectories those of a first hop."""
        return segment.steps * work_of_step(self.parameters, self.lattice, self.speed(segment), segment.share)

    def moves(self, wind: Segment | None = None) -> bool:
        """Whether the wind is above the threshold."""
        return self.setting(wind).ustar > self.parameters.threshold()
