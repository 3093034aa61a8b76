"""The parameters of grains in flight, shared by every model that follows grains."""

import math
from typing import Literal, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import model_validator

from barchan.aeolian.flux import IMPACT_RATIO, KARMAN
from barchan.aeolian.grains import GRAVITY, VISCOSITY, drag_rate, natural_drag, shao_lu
from barchan.aeolian.wall import REFERENCE_HEIGHT
from barchan.grains.air import settling_speed
from barchan.grains.canopy import Stand
from barchan.parameters import Parameters, parameter

PATCH = 16
"""Parcels of a grain with the footprint ``patch``, as ``kernels.grain_state.PATCH``."""


class GrainFlight(Parameters):
    """Sand, air, wind, and how time passes."""

    wind_speed: float = parameter(
        10.0,
        unit="m/s",
        ge=0,
        le=60,
        live=True,
        group="wind",
        meaning="Wind speed at a height of 10 m; a wind that states its speed in m/s overrides it.",
        source="seed 003, ch. 6; seed 000, §6.6",
    )
    roughness: float | None = parameter(
        None,
        unit="m",
        gt=0,
        le=1,
        group="wind",
        meaning="Height at which the wind's speed is zero; a 30th of the grain diameter where not given.",
        source="Bagnold 1941; seed 003, §2.2",
    )
    displacement: float = parameter(
        0.0,
        unit="m",
        ge=0,
        le=1,
        group="wind",
        meaning="Height by which the wind's profile is lifted (zero-plane displacement).",
        source="seed 000, eq. 4.12",
    )
    stability: float = parameter(
        0.0,
        unit="m/s",
        ge=-10,
        le=10,
        group="wind",
        meaning="Term of thermal stability, added to the wind speed above the roughness.",
        source="seed 000, eq. 4.12",
    )
    plants: list[Stand] = parameter(
        list,
        unit="-",
        max_length=100,
        group="plants",
        meaning="Stands of plants that roughen the wind over them; later ones replace earlier ones. Where "
        "any are given, more can be painted.",
        source="ours; seed 000, §3.5",
    )
    plant_roughness: float = parameter(
        0.123,
        unit="-",
        gt=0,
        le=0.5,
        live=True,
        group="plants",
        meaning="Roughness of plants, over their height.",
        source="Brutsaert 1982; Allen et al. 1998 (FAO-56)",
    )
    plant_displacement: float = parameter(
        2.0 / 3.0,
        unit="-",
        ge=0,
        le=1,
        live=True,
        group="plants",
        meaning="Zero-plane displacement of plants, over their height.",
        source="Brutsaert 1982; Allen et al. 1998 (FAO-56)",
    )
    grain_diameter: float = parameter(
        0.15e-3,
        unit="m",
        ge=0.05e-3,
        le=5e-3,
        group="sand",
        meaning="Diameter of the grains.",
        source="seed 003, §4.2; seed 000, §4.3 (printed there as 15 mm)",
    )
    grain_density: float = parameter(
        2655.0,
        unit="kg/m³",
        ge=100,
        le=10_000,
        group="sand",
        meaning="Density of a grain.",
        source="seed 000, §4.3",
    )
    porosity: float = parameter(
        0.40,
        unit="-",
        ge=0,
        le=0.9,
        group="sand",
        meaning="Share of pores in the bed.",
        source="seed 003, Table 4.1",
    )
    air_density: float = parameter(
        1.1644,
        unit="kg/m³",
        ge=0.001,
        le=100,
        group="air",
        meaning="Density of the air.",
        source="seed 000, §4.3: at 30 °C",
    )
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
        source="seed 000, §4.3",
    )
    drag: Literal["constant", "reynolds"] = parameter(
        "constant",
        unit="-",
        group="air",
        meaning="Drag coefficient: one for all, or that of natural sand by its Reynolds number.",
        source="constant: seed 000, eq. 4.9; reynolds: Cheng 1997",
    )
    drag_coefficient: float = parameter(
        0.5,
        unit="-",
        gt=0,
        le=10,
        group="air",
        meaning="The constant drag coefficient.",
        source="seed 000, §4.3: a rough sphere",
    )
    shelter_angle: float | None = parameter(
        None,
        unit="degrees",
        ge=1,
        le=89,
        group="wind",
        meaning="The wind blows above a line that falls from each crest at this angle, and no sand is lifted "
        "below it; no shelter where not given.",
        source="seed 000, §6.6.1, after the shadow zone of Werner 1995",
    )
    shelter_every: int = parameter(
        10,
        unit="iterations",
        ge=1,
        le=1_000_000,
        group="wind",
        meaning="How often the sheltered air is found anew.",
    )
    time_step: float = parameter(
        1e-3,
        unit="s",
        ge=1e-6,
        le=0.1,
        scale="log",
        group="time",
        meaning="Duration of an iteration.",
        source="ours: the seeds do not state it",
    )
    scheme: Literal["euler", "trapezoid"] = parameter(
        "trapezoid",
        unit="-",
        group="time",
        meaning="A step moves a grain by its new velocity, or by the mean of old and new, in the wind half "
        "a step ahead and with drag that decays within the step.",
        source="euler: seed 003, eq. 3.8; trapezoid: ours, exact for a fall",
    )
    clock: Literal["iteration", "step"] = parameter(
        "iteration",
        unit="-",
        group="time",
        meaning="A step of the run is some iterations of all grains in the air, or as many complete "
        "trajectories, one after the other, as the field has cells.",
        source="iteration: seed 003, §5; step: seed 000, Alg. 8",
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
    footprint: Literal["stack", "patch"] = parameter(
        "stack",
        unit="-",
        group="bed",
        meaning="A grain takes one parcel along, from the stack below it, or sixteen, from a patch: four "
        "from that stack, two from each neighbour at its faces, one from those at its corners; it lays them "
        "down alike.",
        source="stack: seed 003, §5.1.2, the nearest vertex; patch: ours, for sand of many grains does not "
        "start and land as one",
    )
    load: float = parameter(
        1.0,
        unit="grains/cell",
        gt=0,
        le=100,
        scale="log",
        group="time",
        meaning="Most simulated grains in the air, for each cell of the field.",
        source="seed 003, ch. 6: 60 to 70 thousand over 256 × 256 cells",
    )
    max_bounces: int = parameter(
        100,
        unit="bounces",
        ge=0,
        le=1_000_000,
        group="bed",
        meaning="After so many bounces a grain stays where it lands, and is counted.",
        source="seed 000, §6.6.1: a bound without a number",
    )
    collapse: Literal["steepest", "filter"] = parameter(
        "steepest",
        unit="-",
        group="bed",
        meaning="Slopes above the angle of repose slide to the steepest neighbour until all hold, or are "
        "smoothed by a filter over eight neighbours, once.",
        source="steepest: seed 003, §5.1.3; filter: Wang & Hu 2009, seed 003, eq. 3.10",
    )
    collapse_every: int = parameter(
        10,
        unit="iterations",
        ge=1,
        le=1_000_000,
        group="bed",
        meaning="How often slopes are looked at; also at the end of each step.",
        source="ours: seed 003, §5.3.1, says after some iterations",
    )
    repose_angle: float = parameter(
        30.0,
        unit="degrees",
        ge=1,
        lt=90,
        live=True,
        group="bed",
        meaning="Angle of repose.",
        source="seed 003, §3.4: 30, in tests 25; loose sand 34 to 35",
    )
    filter_gain: float = parameter(
        1.0,
        unit="-",
        gt=0,
        le=1,
        group="bed",
        meaning="Share of the difference to the neighbours' mean that the filter takes away.",
        source="ours: G of seed 003, eq. 3.10, has no value there",
    )
    filter_scale: float = parameter(
        4.0,
        unit="-",
        gt=0,
        le=100,
        group="bed",
        meaning="Factor on that difference, over the width of a cell, before it is held against the slope.",
        source="ours: T of seed 003, eq. 3.10, has no value there",
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
    def diameter(self) -> float:
        """Mean diameter (m) of the grains."""
        return self.grain_diameter

    @property
    def by_size(self) -> list[Self]:
        """The same rules for the grains of each size alone, finest first."""
        return [self]

    @property
    def carried(self) -> int:
        """Parcels that a simulated grain takes along."""
        return PATCH if self.footprint == "patch" else 1

    @property
    def roughness_length(self) -> float:
        """Height (m) at which the wind's speed is zero."""
        return self.diameter / 30.0 if self.roughness is None else self.roughness

    @property
    def step_seconds(self) -> float | None:
        """Duration (s) of a step of iterations, as the bed sees it; complete trajectories have none."""
        return self.flight_seconds

    @property
    def flight_seconds(self) -> float | None:
        """How long (s) grains fly in a step of iterations."""
        return self.iterations_per_step * self.time_step if self.clock == "iteration" else None

    def friction_velocity(self, speed: float) -> float:
        """Friction velocity (m/s) of a wind speed (m/s) at 10 m: eq. 4.12 of seed 000, solved for it."""
        reach = math.log((REFERENCE_HEIGHT - self.displacement) / self.roughness_length)
        return max(speed - self.stability, 0.0) * KARMAN / reach

    def threshold(self) -> float:
        """Friction velocity (m/s) at which the wind begins to lift grains."""
        weight = self.grain_density * self.gravity / GRAVITY
        return float(shao_lu(self.diameter, weight, self.air_density))

    def impact_threshold(self) -> float:
        """Friction velocity (m/s) at which impacts keep grains going."""
        return IMPACT_RATIO * self.threshold()

    def drag_rate(self, speed: NDArray[np.float64]) -> NDArray[np.float64]:
        """Rate (1/s) at which drag takes a velocity difference ``speed`` (m/s) away."""
        coefficient: NDArray | float = self.drag_coefficient
        if self.drag == "reynolds":
            coefficient = natural_drag(speed, self.diameter, self.viscosity / self.air_density)
        return drag_rate(speed, coefficient, self.diameter, self.grain_density, self.air_density)

    def drag_share(self, speed: NDArray[np.float64]) -> NDArray[np.float64]:
        """Share of a velocity difference ``speed`` (m/s) that drag takes away in a time step."""
        share = self.drag_rate(speed) * self.time_step
        return share if self.scheme == "euler" else -np.expm1(-share)

    def settling_speed(self) -> float:
        """Speed (m/s) of steady fall in still air."""
        return settling_speed(self.drag_rate, self.gravity)
