"""Ripples: grains in a wind that they slow themselves, that shelter behind crests, and that splash."""

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.flow_over_relief import wind_over_waves
from barchan.aeolian.wall import focused_wind
from barchan.bed import Bed
from barchan.directions import downwind
from barchan.grains.air import tables_about_focus
from barchan.grains.bed import GrainGround
from barchan.grains.model import GrainModel
from barchan.grains.ripple_parameters import RipplesParameters
from barchan.grains.sizes import SortedSand
from barchan.grains.splash import creep, sorting
from barchan.grains.wind_feedback import SlowedWind
from barchan.kernels.grains.state import Bounce, LiftOff, Splash
from barchan.lattice import Lattice
from barchan.model import Derived, ModelMeasure
from barchan.wind.segment import Segment


class Ripples(GrainModel):
    """Sand ripples by splash: impacts throw grains out, which hop a little downwind.

    Grains fly as in ``wang_hu``, with drag that depends on the Reynolds number. Seven closures are added:

    * near the bed, below the focus, the wind is slowed by the momentum that grains take from it;
    * over waves the air rises and falls along the streamlines of ``streamline_height``; with
      ``wave_speedup`` it is faster over crests too, and turns across oblique ones;
    * its stress on the bed is higher on crests and on faces that look upwind (Fourrière et al. 2010);
    * behind crests the wind blows above a line that falls at ``shelter_angle``;
    * a grain that hits the bed rebounds with a probability that grows with its speed, or stays;
    * it throws others out, more and faster ones the faster it was;
    * what is left of its momentum pushes grains along the bed, until friction and slope stop them; the wind
      helps, and where its stress is that of the impact threshold it keeps them going.

    So the number of grains in the air finds its own balance, where each impact replaces one. The wind itself
    lifts hardly a grain, enough to start. Sand moves where grains fall, on the faces that look upwind, and
    makes short ways downwind from there: the instability of Anderson (1987). Crests that reach into wind
    beyond the impact threshold lose what comes: there ripples saturate.

    Sand of several ``sizes`` keeps in each cell how many parcels of each lie in an active layer (Hirano 1971)
    and below it. An impact of size i at speed v throws out (a v / √(g D)) (d_i / d_s) f_s grains of size s,
    D being the mean diameter and f_s the share of s in the layer (Kok & Renno 2009), hence (d_s / d_i)² times
    as many parcels as their share, for a parcel holds the fewer grains the coarser they are. Their speed is
    that of ejecta in sand of one size, times (d_i / d_s)² where they are coarser: no size takes more than its
    share of the momentum. Sizes whose impact threshold is above the wind's friction velocity are not thrown
    out, they only creep.

    Known deviations: a simulated grain stands for many, which rebound and are thrown out together, so it
    roughens the bed the more the thicker its sand is; the wind over waves is that of one height for all
    heights; ``load`` bounds the number in the air; grains do not collide in the air; rebounds do not depend
    on size.
    """

    name = "ripples"
    title = "Ripples with splash"
    citation = (
        "After Anderson, R. S. (1987), Sedimentology 34, 943-956; Anderson, R. S. and Haff, P. K. (1991), "
        "Acta Mechanica Suppl. 1, 21-51; Kok, J. F. and Renno, N. O. (2009), J. Geophys. Res. 114, D17204."
    )
    Parameters = RipplesParameters
    parameters: RipplesParameters
    derived = (
        Derived(
            "surface_diameter",
            "m",
            "mean diameter of the grains at the surface",
            lambda model, bed, _: model.surface_diameter(bed),
        ),
    )
    measures = (
        ModelMeasure(
            "coarse_crests",
            "grain diameter, crests over troughs",
            "-",
            lambda model, bed, _: model.coarse_crests(bed),
        ),
    )

    def __init__(self, parameters: Any, lattice: Lattice) -> None:
        """Set the model up with still air."""
        super().__init__(parameters, lattice)
        self.near_bed = SlowedWind(self.parameters, lattice)

    def state(self) -> dict[str, NDArray | float | int | str]:
        """The grains in the air, and the stress that they take from the wind."""
        return {**super().state(), "stress": self.near_bed.stress}

    def restore(self, state: dict[str, Any]) -> None:
        """Take up grains in the air."""
        super().restore(state)
        self.near_bed.stress[...] = state["stress"]

    @property
    def stress(self) -> float:
        """Stress (Pa) that grains take from the wind, as of late: its mean over the field."""
        return float(self.near_bed.stress.mean())

    @property
    def spare_slots(self) -> int:
        """Some to start with, and a sixteenth of those in use."""
        return 64 + self.flying // 16

    @property
    def wind_every(self) -> int:
        """Iterations after which the wind near the bed is found anew."""
        return self.parameters.wind_every

    def feel(self, ground: GrainGround, seconds: float) -> None:
        """Let the wind near the bed adjust to the momentum that impacts took."""
        self.near_bed.feel(ground.lost_speed(), seconds, ground.direction)

    def blow(self, ground: GrainGround, wind: Segment) -> Any:
        """Slow the wind over the ground, let it follow that, and find what it does to grains."""
        rules, surface = self.parameters, ground.arrays.height.reshape(self.lattice.shape)
        about = rules.streamline_height, rules.wave_speedup, (rules.crest_stress, rules.stoss_stress)
        friction = rules.friction_velocity(self.speed(wind))
        near = self.near_bed.friction(friction)
        over_waves = wind_over_waves(surface, self.lattice, wind.direction, *about)
        ground.bend_wind(over_waves)
        if self.near_bed.by_place:
            ground.slow(near)
        ground.drag(near, over_waves)
        return super().blow(ground, wind)

    def near_bed_friction(self, friction: float) -> float:
        """Friction velocity (m/s) of the wind below the focus; its mean over the field."""
        return float(self.near_bed.friction(friction).mean())

    def wind_tables(self, friction: float) -> tuple[Any, Any]:
        """The wind by height, or where it has places its shape below the focus and what comes to it above."""
        if not self.near_bed.by_place:
            return super().wind_tables(friction)
        rules = self.parameters
        return tables_about_focus(friction, rules.roughness_length, rules.focus_height, rules.displacement)

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
        rules = self.parameters
        friction = rules.friction_velocity(self.speed(wind))
        return LiftOff(
            chance * rules.entrainment if self.moves(wind) else 0.0,
            *(0.8 * friction, 2.0 * friction, math.radians(21.0), math.radians(89.0)),
            *downwind(wind.direction),
            False,
            None if self.sizes is None else self.creeping(wind),
        )

    def bounce(self) -> Any:
        """Grains do not bounce; after ``max_bounces`` rebounds they stay."""
        return Bounce(0.0, 0.0, 0.0, self.parameters.max_bounces)

    def splash(self, wind: Segment) -> Any:
        """Rebounds and ejecta, in SI units."""
        rules = self.parameters
        unit = math.sqrt(rules.gravity * rules.diameter)
        return Splash(
            *(rules.rebound_most, rules.rebound_rate, rules.restitution, math.radians(rules.rebound_angle)),
            rules.ejecta / unit,
            rules.ejecta_momentum / rules.ejecta * unit if rules.ejecta else 0.0,
            *(rules.ejecta_scale * unit, math.radians(rules.ejecta_angle)),
            *(math.radians(rules.azimuth_spread), rules.max_bounces),
            creep(rules, self.lattice, self.creeping(wind), wind.direction),
            None if self.sizes is None else sorting(rules, self.creeping(wind)),
        )

    def creeping(self, wind: Segment) -> NDArray[np.bool_]:
        """Which sizes the wind cannot keep in the air: it is below the threshold that impacts leave them.

        Sand of one size splashes under any wind.
        """
        if self.sizes is None:
            return np.zeros(1, np.bool_)
        friction = self.parameters.friction_velocity(self.speed(wind))
        return np.array([one.impact_threshold() > friction for one in self.parameters.by_size])

    def sorted_sand(self) -> SortedSand | None:
        """Sand of several sizes, where the scenario has it."""
        rules = self.parameters
        if not rules.classes:
            return None
        thickness = rules.active_layer * rules.diameter
        return SortedSand(rules.classes, max(1, round(thickness / self.lattice.thickness)))

    def surface_diameter(self, bed: Bed) -> NDArray[np.float64]:
        """Mean diameter (m) of the grains in the active layer."""
        if self.sizes is None:
            return np.full(self.lattice.shape, self.parameters.diameter)
        return self.sizes.surface(bed)

    def coarse_crests(self, bed: Bed) -> float:
        """Mean diameter at the surface of the upper third of the bed over that of the lower third."""
        low, high = np.quantile(bed.elevation, (1 / 3, 2 / 3))
        diameter = self.surface_diameter(bed)
        return float(diameter[bed.elevation >= high].mean() / diameter[bed.elevation <= low].mean())
