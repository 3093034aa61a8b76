"""Ripples: grains in a wind that they slow themselves, that shelter behind crests, and that splash."""

import math
from typing import Any, ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Lattice
from barchan.models.grain_air import focused_wind
from barchan.models.grain_parameters import GrainFlight
from barchan.models.grains import GrainModel
from barchan.parameters import parameter, redeclared
from barchan.wind.segment import Segment, downwind

RESPONSE = 0.05
"""Time (s) over which the wind near the bed adjusts to the grains: about a hop."""

LEAST_SHARE = 0.1
"""Share of the friction velocity that grains leave near the bed at least."""


class RipplesParameters(GrainFlight):
    """Parameters of the ripple model: splash, shelter, a wind that grains slow."""

    kind_key: ClassVar[str] = "name"

    name: Literal["ripples"] = parameter("ripples", unit="-", meaning="The ripple model.")
    drag: Literal["constant", "reynolds"] = redeclared(GrainFlight, "drag", "reynolds", "Cheng 1997")
    footprint: Literal["stack", "patch"] = redeclared(
        GrainFlight, "footprint", "patch", "ours: whole parcels roughen the bed until ripples turn back"
    )
    shelter_angle: float | None = redeclared(
        GrainFlight, "shelter_angle", 15.0, "Werner 1995; seed 000, §3.2: the shadow zone"
    )
    repose_angle: float = redeclared(GrainFlight, "repose_angle", 34.0, "seed 003, §3.4: loose sand 34 to 35")
    time_step: float = redeclared(GrainFlight, "time_step", 5e-4, "ours: for cells of 5 mm")
    load: float = redeclared(GrainFlight, "load", 4.0, "ours: more than the wind carries")
    near_bed: Literal["slowed", "threshold", "log"] = parameter(
        "slowed",
        unit="-",
        live=True,
        group="wind",
        meaning="Wind below the focus: slowed by the momentum that grains take from it, that of the impact "
        "threshold, or the law of the wall all the way down.",
        source="slowed: Owen 1964; Ungar & Haff 1987; threshold: Bagnold 1941; log: seed 003, eq. 2.1",
    )
    wind_every: int = parameter(
        50,
        unit="iterations",
        ge=1,
        le=1_000_000,
        group="wind",
        meaning="How often the wind near the bed is found anew.",
        source="ours",
    )
    weight: float = parameter(
        0.1,
        unit="-",
        gt=0,
        le=1,
        scale="log",
        group="wind",
        meaning="Share of a grain's sand that slows the wind. With 1 the air carries as much sand as real "
        "wind does. With less it carries more and the bed changes faster by so much: a second of flight "
        "counts for so many seconds of wind over the bed.",
        source="ours",
    )
    focus_height: float = parameter(
        0.01,
        unit="m",
        gt=0,
        le=1,
        live=True,
        group="wind",
        meaning="Height of the focus, below which all winds are alike.",
        source="Bagnold 1941: about a centimetre over sand of mixed sizes",
    )
    entrainment: float = parameter(
        1e-3,
        unit="-",
        ge=0,
        le=1,
        live=True,
        group="lift-off",
        meaning="Chance that the wind itself lifts a parcel into a free slot in an iteration.",
        source="ours: enough to start, little beside the splash",
    )
    rebound_most: float = parameter(
        0.95,
        unit="-",
        ge=0,
        le=1,
        live=True,
        group="splash",
        meaning="Chance that the fastest grains rebound.",
        source="Anderson & Haff 1991",
    )
    rebound_rate: float = parameter(
        1.0,
        unit="s/m",
        gt=0,
        le=100,
        live=True,
        group="splash",
        meaning="How fast the chance to rebound grows with impact speed.",
        source="Kok & Renno 2009, after Anderson & Haff 1991: of the order of 1",
    )
    restitution: float = parameter(
        0.55,
        unit="-",
        ge=0,
        le=1,
        live=True,
        group="splash",
        meaning="Speed after a rebound over the speed of impact.",
        source="Kok & Renno 2009",
    )
    rebound_angle: float = parameter(
        40.0,
        unit="degrees",
        gt=0,
        le=89,
        live=True,
        group="splash",
        meaning="Mean angle of rebounds to the surface, of an exponential distribution below 90.",
        source="Kok & Renno 2009",
    )
    ejecta: float = parameter(
        0.02,
        unit="-",
        ge=0,
        le=1,
        live=True,
        group="splash",
        meaning="Grains thrown out by an impact, over impact speed and √(g d).",
        source="Kok & Renno 2009: 0.01 to 0.03",
    )
    ejecta_momentum: float = parameter(
        0.15,
        unit="-",
        ge=0,
        le=1,
        live=True,
        group="splash",
        meaning="Share of the impact's momentum that the ejecta of fast impacts take.",
        source="Kok & Renno 2009",
    )
    ejecta_scale: float = parameter(
        40.0,
        unit="-",
        gt=0,
        le=1000,
        live=True,
        group="splash",
        meaning="Impact speed, over √(g d), from which on ejecta grow no faster.",
        source="Kok & Renno 2009",
    )
    ejecta_angle: float = parameter(
        50.0,
        unit="degrees",
        gt=0,
        le=89,
        live=True,
        group="splash",
        meaning="Mean angle of ejecta to the surface, of an exponential distribution below 90.",
        source="Kok & Renno 2009",
    )
    azimuth_spread: float = parameter(
        15.0,
        unit="degrees",
        ge=0,
        le=180,
        live=True,
        group="splash",
        meaning="Rebounds and ejecta turn aside by up to this.",
        source="ours",
    )

    @property
    def step_seconds(self) -> float | None:
        """Duration (s) of a step, as the bed sees it; complete trajectories have none."""
        return None if self.flight_seconds is None else self.flight_seconds / self.weight


class Ripples(GrainModel):
    """Sand ripples by splash: impacts throw grains out, which hop a little downwind.

    Grains fly as in ``wang_hu``, with drag that depends on the Reynolds number. Four closures are added:

    * near the bed, below the focus, the wind is slowed by the momentum that grains take from it;
    * behind crests the wind blows above a line that falls at ``shelter_angle``;
    * a grain that hits the bed rebounds with a probability that grows with its speed, or stays;
    * it throws others out, more and faster ones the faster it was.

    So the number of grains in the air finds its own balance, where each impact replaces one. The wind itself
    lifts hardly a grain, enough to start. Sand moves where grains fall, on the faces that look upwind, and
    makes short hops downwind from there: the instability of Anderson (1987).

    Known deviations: a simulated grain stands for many, which rebound and are thrown out together, so it
    roughens the bed the more the thicker its sand is; the wind near the bed is the same over the whole field,
    and follows it; ``load`` bounds the number in the air; grains do not collide in the air.
    """

    name = "ripples"
    title = "Ripples with splash"
    citation = (
        "After Anderson, R. S. (1987), Sedimentology 34, 943-956; Anderson, R. S. and Haff, P. K. (1991), "
        "Acta Mechanica Suppl. 1, 21-51; Kok, J. F. and Renno, N. O. (2009), J. Geophys. Res. 114, D17204."
    )
    Parameters = RipplesParameters
    parameters: RipplesParameters

    def __init__(self, parameters: Any, lattice: Lattice) -> None:
        """Set the model up with still air."""
        super().__init__(parameters, lattice)
        self.stress = 0.0
        """Stress (Pa) that grains take from the wind, as of late."""

    def state(self) -> dict[str, NDArray | float | int | str]:
        """The grains in the air, and the stress that they take from the wind."""
        return {**super().state(), "stress": self.stress}

    def restore(self, state: dict[str, Any]) -> None:
        """Take up grains in the air."""
        super().restore(state)
        self.stress = float(state["stress"])

    @property
    def spare_slots(self) -> int:
        """Some to start with, and a sixteenth of those in use."""
        return 64 + self.flying // 16

    @property
    def wind_every(self) -> int:
        """Iterations after which the wind near the bed is found anew."""
        return self.parameters.wind_every

    def feel(self, lost: int, seconds: float) -> None:
        """Let the wind near the bed adjust to the momentum that impacts took."""
        from barchan.kernels.grain_splash import LOST_UNIT

        rules = self.parameters
        thickness = rules.carried * self.lattice.thickness
        mass = rules.weight * rules.grain_density * (1.0 - rules.porosity) * thickness
        taken = mass * lost / LOST_UNIT / self.lattice.cells / seconds
        self.stress += (taken - self.stress) * -math.expm1(-seconds / RESPONSE)

    def near_bed_friction(self, friction: float) -> float:
        """Friction velocity (m/s) of the wind below the focus."""
        if self.parameters.near_bed == "threshold":
            return self.parameters.impact_threshold()
        left = friction**2 - self.stress / self.parameters.air_density
        return math.sqrt(max(left, (LEAST_SHARE * friction) ** 2))

    def wind_profile(self, height: NDArray[np.float64], friction: float) -> NDArray[np.float64]:
        """Wind speed (m/s) at heights (m) above the surface."""
        rules = self.parameters
        if rules.near_bed == "log":
            return super().wind_profile(height, friction)
        return focused_wind(
            *(height, friction, self.near_bed_friction(friction), rules.roughness_length),
            *(rules.focus_height, rules.displacement),
        )

    def lift_off(self, wind: Segment, chance: float = 1.0) -> Any:
        """By the wind, from anywhere that it reaches and that does not face away from it."""
        from barchan.kernels.grain_state import LiftOff

        rules = self.parameters
        friction = rules.friction_velocity(self.speed(wind))
        return LiftOff(
            chance * rules.entrainment if self.moves(wind) else 0.0,
            *(0.8 * friction, 2.0 * friction, math.radians(21.0), math.radians(89.0)),
            *downwind(wind.direction),
            False,
        )

    def bounce(self) -> Any:
        """Grains do not bounce; after ``max_bounces`` rebounds they stay."""
        from barchan.kernels.grain_state import Bounce

        return Bounce(0.0, 0.0, 0.0, self.parameters.max_bounces)

    def splash(self) -> Any:
        """Rebounds and ejecta, in SI units."""
        from barchan.kernels.grain_splash import Splash

        rules = self.parameters
        unit = math.sqrt(rules.gravity * rules.grain_diameter)
        return Splash(
            *(rules.rebound_most, rules.rebound_rate, rules.restitution, math.radians(rules.rebound_angle)),
            rules.ejecta / unit,
            rules.ejecta_momentum / rules.ejecta * unit if rules.ejecta else 0.0,
            *(rules.ejecta_scale * unit, math.radians(rules.ejecta_angle)),
            *(math.radians(rules.azimuth_spread), rules.max_bounces),
        )
