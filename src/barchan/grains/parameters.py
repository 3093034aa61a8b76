"""The parameters of grains in flight that every model of grains has, beside its closures."""

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.wall import REFERENCE_HEIGHT, friction_velocity, grain_roughness
from barchan.grains.medium import GrainInAir
from barchan.grains.wind_feedback import Feedback
from barchan.kernels.grains.state import PATCH
from barchan.parameters import parameter


class GrainFlight(GrainInAir):
    """Sand, air, wind, time, and the bed."""

    wind_speed: float = parameter(
        10.0,
        unit="m/s",
        ge=0,
        le=60,
        live=True,
        group="wind",
        meaning="Wind speed at a height of 10 m; a wind that states its speed in m/s overrides it.",
        source="Szabó 2019, ch. 6; Prague thesis, §6.6",
    )
    roughness: float | None = parameter(
        None,
        unit="m",
        gt=0,
        le=1,
        group="wind",
        meaning="Height at which the wind's speed is zero; a 30th of the grain diameter where not given.",
        source="Bagnold 1941; Szabó 2019, §2.2",
    )
    displacement: float = parameter(
        0.0,
        unit="m",
        ge=0,
        le=1,
        group="wind",
        meaning="Height by which the wind's profile is lifted (zero-plane displacement).",
        source="Prague thesis, eq. 4.12",
    )
    stability: float = parameter(
        0.0,
        unit="m/s",
        ge=-10,
        le=10,
        group="wind",
        meaning="Term of thermal stability, added to the wind speed above the roughness.",
        source="Prague thesis, eq. 4.12",
    )
    time_step: float = parameter(
        1e-3,
        unit="s",
        ge=1e-6,
        le=0.1,
        scale="log",
        group="time",
        meaning="Duration of an iteration.",
        source="ours: Szabó 2019 and the Prague thesis do not state it",
    )
    scheme: Literal["euler", "trapezoid"] = parameter(
        "trapezoid",
        unit="-",
        group="time",
        meaning="A step moves a grain by its new velocity, or by the mean of old and new, in the wind half "
        "a step ahead and with drag that decays within the step.",
        source="euler: Szabó 2019, eq. 3.8; trapezoid: ours, exact for a fall",
    )
    clock: Literal["iteration", "step"] = parameter(
        "iteration",
        unit="-",
        group="time",
        meaning="A step of the run is some iterations of all grains in the air, or as many complete "
        "trajectories, one after the other, as the field has cells.",
        source="iteration: Szabó 2019, §5; step: Prague thesis, Alg. 8",
    )
    iterations_per_step: int = parameter(
        1,
        unit="iterations",
        ge=1,
        le=1_000_000,
        scale="log",
        group="time",
        acts_with={"clock": "iteration"},
        meaning="Iterations in a step of the run, where that is the clock.",
    )
    max_grains_per_cell: float = parameter(
        1.0,
        unit="grains/cell",
        gt=0,
        le=100,
        scale="log",
        group="time",
        meaning="Simulated grains in the air at most, for each cell of the field.",
        source="Szabó 2019, ch. 6: 60 to 70 thousand over 256 × 256 cells",
    )
    footprint: Literal["stack", "patch"] = parameter(
        "stack",
        unit="-",
        group="bed",
        meaning="A grain takes one parcel along, from the stack below it, or sixteen, from a patch: four "
        "from that stack, two from each neighbour at its faces, one from those at its corners; it lays them "
        "down in the same way.",
        source="stack: Szabó 2019, §5.1.2, the nearest vertex; patch: ours, for sand of many grains does not "
        "start and land as one",
    )
    max_bounces: int = parameter(
        100,
        unit="bounces",
        ge=0,
        le=1_000_000,
        group="bed",
        meaning="Bounces, or rebounds, after which a grain stays where it lands, and is counted.",
        source="Prague thesis, §6.6.1: a bound without a number",
    )
    collapse: Literal["steepest", "filter"] = parameter(
        "steepest",
        unit="-",
        group="bed",
        meaning="Slopes above the angle of repose slide to the steepest neighbour until all hold, or are "
        "smoothed by a filter over eight neighbours, once.",
        source="steepest: Szabó 2019, §5.1.3; filter: Wang & Hu 2009, in Szabó 2019, eq. 3.10",
    )
    collapse_every: int = parameter(
        10,
        unit="iterations",
        ge=1,
        le=1_000_000,
        group="bed",
        acts_with={"clock": "iteration"},
        meaning="Iterations after which slopes are checked; they also are at the end of each step.",
        source="ours: Szabó 2019, §5.3.1, says after some iterations",
    )
    repose_angle: float = parameter(
        30.0,
        unit="degrees",
        ge=1,
        lt=90,
        live=True,
        group="bed",
        meaning="Angle of repose.",
        source="Szabó 2019, §3.4: 30, in tests 25; loose sand 34 to 35",
    )
    filter_gain: float = parameter(
        1.0,
        unit="-",
        gt=0,
        le=1,
        group="bed",
        acts_with={"collapse": "filter"},
        meaning="Share of the difference to the neighbours' mean that the filter takes away.",
        source="ours: G of Szabó 2019, eq. 3.10, has no value there",
    )
    filter_scale: float = parameter(
        4.0,
        unit="-",
        gt=0,
        le=100,
        group="bed",
        acts_with={"collapse": "filter"},
        meaning="Factor on that difference, over the width of a cell, before it is held against the slope.",
        source="ours: T of Szabó 2019, eq. 3.10, has no value there",
    )

    @property
    def carried(self) -> int:
        """Parcels that a simulated grain takes along."""
        return PATCH if self.footprint == "patch" else 1

    @property
    def roughness_length(self) -> float:
        """Roughness length (m) of the bed."""
        return grain_roughness(self.diameter) if self.roughness is None else self.roughness

    @property
    def step_seconds(self) -> float | None:
        """Duration (s) of a step of iterations, as the bed sees it; complete trajectories have none.

        Where the wind is slowed by a share of a grain's sand, wind lasts as much longer than flight.
        """
        feedback, seconds = self.part(Feedback), self.flight_seconds
        return seconds if feedback is None or seconds is None else seconds / feedback.momentum_weight

    @property
    def flight_seconds(self) -> float | None:
        """Duration (s) of flight in a step of iterations."""
        return self.iterations_per_step * self.time_step if self.clock == "iteration" else None

    def friction_velocity(self, speed: float) -> float:
        """Friction velocity (m/s) of a wind speed (m/s) at 10 m (Prague thesis, eq. 4.12)."""
        moving = max(speed - self.stability, 0.0)
        return friction_velocity(moving, REFERENCE_HEIGHT, self.roughness_length, self.displacement)

    def drag_share(self, speed: NDArray[np.float64], diameter: float | None = None) -> NDArray[np.float64]:
        """Share of a velocity difference ``speed`` (m/s) that drag takes away in a time step."""
        share = self.drag_rate(speed, diameter) * self.time_step
        return share if self.scheme == "euler" else -np.expm1(-share)
