"""The parameters of slab transport, shared by every slab model."""

import math
from typing import Annotated, ClassVar, Literal, NamedTuple, Self

from pydantic import Field, model_validator

from barchan.heights import LARGEST_STEP
from barchan.lattice import Lattice
from barchan.parameters import Parameters, parameter

_ROUNDING = 1e-9
"""Slack for limits that are whole slabs but for rounding, as atan(2/3) at an aspect of 1/3."""


ShadowRule = Literal["centre", "edge", "place"]
"""Where shadow lines start."""

OrderRule = Literal["wind", "random", "downslope"]
"""To which neighbour slabs slide."""


class ActingRules(NamedTuple):
    """The rules that act where ``auto`` leaves it to the winds of the run."""

    shadow: ShadowRule
    order: OrderRule


class SlabParameters(Parameters):
    """How slabs are polled, carried and deposited, and how they slide."""

    kind_key: ClassVar[str] = "name"

    hop_length: float = parameter(
        5.0,
        unit="cells",
        gt=0,
        le=100_000,
        scale="log",
        live=True,
        group="transport",
        meaning="Distance of one hop; a wind that states its speed in cells overrides it.",
        source="Werner 1995; Prague thesis, Table 6.1",
    )
    p_s: float = parameter(
        0.6,
        unit="-",
        ge=0,
        le=1,
        live=True,
        group="transport",
        meaning="Chance that a slab is deposited where it lands on sand.",
        source="Werner 1995; Prague thesis; Elder 2009",
    )
    p_ns: float = parameter(
        0.4,
        unit="-",
        ge=0,
        le=1,
        live=True,
        group="transport",
        meaning="Chance that a slab is deposited where it lands on bare ground.",
        source="Werner 1995; Prague thesis; Elder 2009",
    )
    max_hops: int = parameter(
        10_000,
        unit="hops",
        ge=1,
        le=1_000_000_000,
        group="transport",
        meaning="Number of hops after which a slab is put down wherever it is, and counted.",
    )
    shadow_angle: float = parameter(
        15.0,
        unit="degrees",
        ge=1,
        lt=90,
        live=True,
        group="shadow",
        meaning="Angle at which the shadow line falls behind whatever stands upwind.",
        source="Werner 1995",
    )
    shadow_from: Literal["auto", "centre", "edge", "place"] = parameter(
        "auto",
        unit="-",
        live=True,
        group="shadow",
        meaning="Where the line starts: at the upwind cell's centre; at its downwind edge so that a cell is "
        "sheltered when more than half of its top lies under the line; or at that edge, with each slab "
        "sheltered or not at its own place in its cell, which treats every wind direction alike. auto is "
        "place where any wind of the run blows off the lattice's axes, because the lattice steers crests "
        "under the other two rules then, and centre elsewhere.",
        source="centre: Prague thesis, Alg. 6; edge: Elder 2009, Fig. 2; place, auto: ours",
    )
    stack_tops: Literal["level", "sloping"] = parameter(
        "sloping",
        unit="-",
        live=True,
        group="shadow",
        acts_with={"shadow_from": ["auto", "place"]},
        meaning="Tops of stacks for shadow lines from a slab's place under oblique winds: level, which makes "
        "a staircase of slopes across the wind that shelters itself; or sloping across the wind as the "
        "surface about them does, up to the repose limit, which lets horns grow as along an axis.",
        source="ours",
    )
    lee_erosion: bool = parameter(
        False,
        unit="-",
        live=True,
        group="shadow",
        meaning="Whether cells in shadow may erode, as in the original of 1995.",
        source="Werner 1995 (true); Momiji et al. 2000 (false)",
    )
    repose_angle: float = parameter(
        33.7,
        unit="degrees",
        ge=1,
        le=89,
        live=True,
        group="avalanches",
        meaning="Angle of repose; whole slabs hold only some angles, see repose_test.",
        source="Momiji et al. 2000; Elder 2009",
    )
    repose_test: Literal["before", "after"] = parameter(
        "after",
        unit="-",
        live=True,
        group="avalanches",
        meaning="Whether a slope is tested after the slab is moved (the geometric rule) or before, which "
        "lets it stand one slab steeper.",
        source="before: Prague thesis, Alg. 4 and 5",
    )
    static_repose_angle: float | None = parameter(
        None,
        unit="degrees",
        ge=1,
        lt=90,
        live=True,
        group="avalanches",
        meaning="Static angle of repose: above it sand at rest starts to slide, and comes to rest again "
        "at the repose angle; the repose angle itself where it is not given.",
        source="Prague thesis, §2.1.2: 35 degrees, coming to rest at 32 to 33",
    )
    neighbourhood: Literal["von_neumann", "moore"] = parameter(
        "von_neumann",
        unit="-",
        live=True,
        group="avalanches",
        meaning="Cells that a slab may slide to: the four faces, or the four corners too; of hexagons always "
        "the six faces.",
        source="von_neumann: Prague thesis, Fig. 5.5; moore: Elder 2009, Fig. 3",
    )
    corner_limit: Literal["face", "geometric"] | Annotated[int, Field(ge=1, le=1_000_000)] = parameter(
        "face",
        unit="slabs",
        live=True,
        group="avalanches",
        acts_with={"neighbourhood": "moore"},
        meaning="Largest stable step to a corner neighbour before repose_test: the same as to a face, the "
        "repose angle over the longer distance, or a number of slabs (3 is isotropic at an aspect of 1/3).",
        source="face: Elder 2009",
    )
    neighbour_order: Literal["auto", "wind", "random", "downslope"] = parameter(
        "auto",
        unit="-",
        live=True,
        group="avalanches",
        meaning="To which neighbour a slab slides from a step that does not stand: the steepest, of equally "
        "steep ones the first downwind (for one that falls in, upwind) or in a sequence drawn each time, "
        "faces before corners; or, downslope, one drawn in proportion to the steps to all that lie lower by "
        "more than a slab, so that on average slabs slide straight down a slope, wherever it faces. auto is "
        "downslope where any wind of the run blows off the lattice's axes, and wind elsewhere.",
        source="wind: Prague thesis, Fig. 5.5; random: Elder 2009; downslope, auto: ours",
    )
    upwind_avalanches: bool = parameter(
        True,
        unit="-",
        live=True,
        group="avalanches",
        meaning="Whether sand may slide against the wind; without it profiles become asymmetric.",
        source="Elder 2009, Fig. 5",
    )
    path_test: Literal["off", "hard", "surface"] = parameter(
        "off",
        unit="-",
        live=True,
        group="transport",
        meaning="What stops a slab in flight: nothing (it hops over whatever lies between), ground that "
        "stands above the surface it has come over by more than the repose limit, or sand as steep too.",
        source="hard: Prague thesis, Alg. 7; surface: Prague thesis, §4.4 and Fig. 4.2",
    )
    polling: Literal["repeated", "non_repeated"] = parameter(
        "repeated",
        unit="-",
        live=True,
        group="polling",
        meaning="Cells are polled at random with repetition, or each once a step in random order.",
        source="repeated: Werner 1995; non_repeated: Nield & Baas 2008",
    )
    forced_erosion: bool = parameter(
        False,
        unit="-",
        live=True,
        group="polling",
        meaning="Whether every poll moves a slab: a cell that cannot erode is passed over for another.",
        source="Prague thesis, Alg. 2",
    )
    band_rows: int = parameter(
        32,
        unit="cells",
        ge=1,
        le=65536,
        group="polling",
        meaning="Width of a band across the wind's nearer axis. The polls of a step go through the field "
        "band by band, the bands in random order; the field's width or more means no bands.",
    )

    @model_validator(mode="after")
    def _starts_to_slide_above_rest(self) -> Self:
        if self.static_repose_angle is not None and self.static_repose_angle < self.repose_angle:
            raise ValueError(
                f"static_repose_angle {self.static_repose_angle} degrees is below "
                f"repose_angle {self.repose_angle}; "
                "sand cannot start to slide on a slope where it comes to rest"
            )
        return self

    def acting(self, winds_off_axes: bool) -> ActingRules:
        """What acts of ``shadow_from`` and ``neighbour_order``, by whether any wind blows off the axes."""
        shadow, order = self.shadow_from, self.neighbour_order
        return ActingRules(
            ("place" if winds_off_axes else "centre") if shadow == "auto" else shadow,
            ("downslope" if winds_off_axes else "wind") if order == "auto" else order,
        )

    def face_limit(self, lattice: Lattice, angle: float | None = None) -> int:
        """Largest step (slabs) to a face neighbour that stands, at the repose angle or another one."""
        angle = self.repose_angle if angle is None else angle
        return self._limit(math.tan(math.radians(angle)) / lattice.aspect)

    def corner_step_limit(self, lattice: Lattice, angle: float | None = None) -> int:
        """Largest step (slabs) to a corner neighbour that stands."""
        if self.corner_limit == "face" or lattice.hexagonal:
            return self.face_limit(lattice, angle)
        slope = math.tan(math.radians(self.repose_angle if angle is None else angle)) / lattice.aspect
        if self.corner_limit == "geometric":
            return self._limit(math.sqrt(2) * slope)
        return self._limit(self.corner_limit)

    def _limit(self, slabs: float) -> int:
        earlier = 1 if self.repose_test == "before" else 0
        return max(1, math.floor(min(slabs + _ROUNDING, LARGEST_STEP))) + earlier

    def limits(self, lattice: Lattice, angle: float | None = None) -> tuple[int, int]:
        """Largest steps (slabs) that stand towards faces and corners; of hexagons the two are one."""
        return self.face_limit(lattice, angle), self.corner_step_limit(lattice, angle)

    def effective_angles(self, lattice: Lattice, angle: float | None = None) -> tuple[float, float | None]:
        """Steepest stable slopes (degrees) towards faces and, in a Moore neighbourhood, corners."""
        face, corner = self.limits(lattice, angle)
        steepest = math.degrees(math.atan(face * lattice.aspect))
        if self.neighbourhood == "von_neumann" or lattice.hexagonal:
            return steepest, None
        return steepest, math.degrees(math.atan(corner * lattice.aspect / math.sqrt(2)))
