"""The parameters of grains in flight that every model of grains has, beside its closures."""

from collections.abc import Sequence
from typing import Literal, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import model_validator

from barchan.aeolian.flux import IMPACT_RATIO
from barchan.aeolian.grains import GRAVITY, VISCOSITY, drag_rate, natural_drag, shao_lu, terminal_speed
from barchan.aeolian.sand import Air, Sand
from barchan.aeolian.wall import REFERENCE_HEIGHT, friction_velocity, grain_roughness
from barchan.grains.closure import Composition
from barchan.grains.sizes import SizeClass, Sizes, mean_diameter
from barchan.grains.wind_feedback import Feedback
from barchan.kernels.grains.state import PATCH
from barchan.parameters import parameter, redeclared


class GrainFlight(Composition, Air, Sand):
    """Sand, air, wind, time, and the bed."""

    grain_diameter: float = redeclared(
        Sand, "grain_diameter", 0.15e-3, "Szabó 2019, §4.2; Prague thesis, §4.3 (printed there as 15 mm)"
    )
    grain_density: float = redeclared(Sand, "grain_density", 2655.0, "Prague thesis, §4.3")
    porosity: float = redeclared(Sand, "porosity", 0.40, "Szabó 2019, Table 4.1")
    air_density: float = redeclared(Air, "air_density", 1.1644, "Prague thesis, §4.3: at 30 °C")

    viscosity: float = parameter(
        VISCOSITY,
        unit="Pa s",
        gt=0,
        le=1e-2,
        group="air",
        meaning="Dynamic viscosity of the air, for drag that depends on the Reynolds number.",
        source="air at 15 to 20 °C",
    )
    gravity: float = parameter(
        9.81,
        unit="m/s²",
        gt=0,
        le=100,
        group="air",
        meaning="Acceleration of gravity.",
        source="Prague thesis, §4.3",
    )
    drag: Literal["constant", "reynolds"] = parameter(
        "constant",
        unit="-",
        group="air",
        meaning="Drag coefficient: one for all, or that of natural sand by its Reynolds number.",
        source="constant: Prague thesis, eq. 4.9; reynolds: Cheng 1997",
    )
    drag_coefficient: float = parameter(
        0.5,
        unit="-",
        gt=0,
        le=10,
        group="air",
        meaning="The constant drag coefficient.",
        source="Prague thesis, §4.3: a rough sphere",
    )
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
        "down alike.",
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
        meaning="Share of the difference to the neighbours' mean that the filter takes away.",
        source="ours: G of Szabó 2019, eq. 3.10, has no value there",
    )
    filter_scale: float = parameter(
        4.0,
        unit="-",
        gt=0,
        le=100,
        group="bed",
        meaning="Factor on that difference, over the width of a cell, before it is held against the slope.",
        source="ours: T of Szabó 2019, eq. 3.10, has no value there",
    )

    @model_validator(mode="after")
    def _heavier_than_air(self) -> Self:
        if self.grain_density <= 2.0 * self.air_density:
            raise ValueError(
                f"grain_density {self.grain_density:g} kg/m³ is not twice air_density "
                f"{self.air_density:g} kg/m³; allowed: grains that fall"
            )
        return self

    @property
    def size_classes(self) -> list[SizeClass]:
        """The size classes of the sand, finest first; none: all grains have one size."""
        sizes = self.part(Sizes)
        return [] if sizes is None else sizes.of(self.grain_diameter)

    @property
    def diameters(self) -> Sequence[float]:
        """Diameters (m) of the size classes, finest first; of sand of one size its diameter."""
        return [one.diameter for one in self.size_classes] or [self.grain_diameter]

    @property
    def diameter(self) -> float:
        """Mean diameter (m) of the grains, by volume."""
        classes = self.size_classes
        return mean_diameter(classes) if classes else self.grain_diameter

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

    def threshold(self, diameter: float | None = None) -> float:
        """Friction velocity (m/s) at which the wind begins to lift grains, by default of mean diameter."""
        weight = self.grain_density * self.gravity / GRAVITY
        return float(shao_lu(self.diameter if diameter is None else diameter, weight, self.air_density))

    def impact_threshold(self, diameter: float | None = None) -> float:
        """Friction velocity (m/s) at which impacts keep grains going."""
        return IMPACT_RATIO * self.threshold(diameter)

    def too_heavy(self, ustar: float) -> NDArray[np.bool_]:
        """Whether the wind cannot keep each size class in the air: it is below its impact threshold.

        Sand of one size splashes under any wind.
        """
        if not self.size_classes:
            return np.zeros(1, np.bool_)
        return np.array([self.impact_threshold(one) > ustar for one in self.diameters])

    def drag_rate(self, speed: NDArray[np.float64], diameter: float | None = None) -> NDArray[np.float64]:
        """Rate (1/s) at which drag takes a velocity difference ``speed`` (m/s) away."""
        size = self.diameter if diameter is None else diameter
        coefficient: NDArray | float = self.drag_coefficient
        if self.drag == "reynolds":
            coefficient = natural_drag(speed, size, self.viscosity / self.air_density)
        return drag_rate(speed, coefficient, size, self.grain_density, self.air_density)

    def drag_share(self, speed: NDArray[np.float64], diameter: float | None = None) -> NDArray[np.float64]:
        """Share of a velocity difference ``speed`` (m/s) that drag takes away in a time step."""
        share = self.drag_rate(speed, diameter) * self.time_step
        return share if self.scheme == "euler" else -np.expm1(-share)

    def settling_speed(self, diameter: float | None = None) -> float:
        """Speed (m/s) of steady fall in still air."""
        return terminal_speed(lambda speed: self.drag_rate(speed, diameter), self.gravity)
