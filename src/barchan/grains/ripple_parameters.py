"""The parameters of ripples by splash, and of sand of several sizes."""

from typing import ClassVar, Literal, Self

from pydantic import ValidationError, model_validator

from barchan.grains.parameters import GrainFlight
from barchan.grains.sizes import MOST, SizeClass, lognormal, mean_diameter, mistakes, spread_mistakes
from barchan.parameters import parameter, redeclared


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
    sharing_width: float | None = parameter(
        0.05,
        unit="m",
        gt=0,
        le=10,
        group="wind",
        meaning="Width (standard deviation) along the wind over which the air shares the momentum that "
        "grains take from it; over the whole field if null, and then grains crowd into lanes.",
        source="ours",
    )
    sharing_across: float = parameter(
        0.02,
        unit="m",
        gt=0,
        le=10,
        group="wind",
        meaning="The same across the wind. Where it is as wide, lanes of grains break ripples up into pits.",
        source="ours: what is slowed spreads by some tenth or fifth of its way",
    )
    streamline_height: float | None = parameter(
        0.01,
        unit="m",
        gt=0,
        le=10,
        group="wind",
        meaning="Height whose streamlines tell how the air rises, falls and speeds up over waves; the wind "
        "blows level and alike where not given.",
        source="frictionless flow over waves (Lamb 1932); the height, that of the focus, is ours",
    )
    wave_speedup: float = parameter(
        0.0,
        unit="-",
        ge=0,
        le=10,
        live=True,
        group="wind",
        meaning="How much faster the wind blows over crests, slower over troughs and across oblique ones, "
        "over what it would without friction; 0: it blows alike everywhere.",
        source="0: ours, for low ripples hardly form otherwise; 1: the same flow as the streamlines (Lamb "
        "1932); 2: near the bed of a turbulent one, whose shear stress is about 4 k h higher on waves of "
        "height h and wave number k (Fourrière et al. 2010; from memory)",
    )
    crest_stress: float = parameter(
        4.0,
        unit="-",
        ge=0,
        le=20,
        live=True,
        group="wind",
        meaning="How much higher the wind's stress on the bed is on crests of waves, and lower in their "
        "troughs, over their height times wave number; it helps pushed grains along. 0: it is alike there.",
        source="Fourrière et al. 2010, from memory: about 4",
    )
    stoss_stress: float = parameter(
        2.0,
        unit="-",
        ge=0,
        le=20,
        live=True,
        group="wind",
        meaning="How much higher it is on faces that look upwind, over their slope; with it the stress is "
        "highest ahead of crests.",
        source="Fourrière et al. 2010, from memory: about 2",
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

    sizes: list[SizeClass] = parameter(
        list,
        unit="-",
        max_length=MOST,
        group="sand",
        meaning="Sand of several sizes, finest first, instead of grain_diameter; none: all grains are alike.",
        source="seed 000, §7.1",
    )
    size_spread: float | None = parameter(
        None,
        unit="-",
        gt=1,
        le=3,
        group="sand",
        meaning="Geometric standard deviation of diameters that are spread lognormally by volume about "
        "grain_diameter, their median, instead of sizes; all grains are alike where not given.",
        source="Folk & Ward 1957: well sorted sand 1.27 to 1.41",
    )
    size_classes: int = parameter(
        3,
        unit="-",
        ge=2,
        le=MOST,
        group="sand",
        meaning="Classes of equal volume that such sand is split into.",
        source="ours",
    )
    active_layer: float = parameter(
        2.0,
        unit="grain diameters",
        gt=0,
        le=100,
        group="sand",
        meaning="Thickness of the layer that impacts reach in sand of several sizes, in mean diameters.",
        source="Hirano 1971 for the layer; its thickness is ours: two layers of grains",
    )
    creep_momentum: float = parameter(
        0.6,
        unit="-",
        ge=0,
        le=1,
        live=True,
        group="splash",
        meaning="Share of the impact's momentum that pushes grains along the bed.",
        source="ours: what rebounds (0.3) and ejecta (0.1) leave",
    )
    creep_speed: float = parameter(
        1.41,
        unit="-",
        gt=0,
        le=20,
        live=True,
        group="splash",
        meaning="Speed at which pushed grains start, over √(g d).",
        source="ours: faster ones would rise over their neighbours, by a diameter, and fly",
    )

    @model_validator(mode="after")
    def _sizes_in_order(self) -> Self:
        found = mistakes(self.sizes) + spread_mistakes(self.size_spread, self.classes, self.sizes)
        if found:
            raise ValidationError.from_exception_data(type(self).__name__, found)
        return self

    @property
    def classes(self) -> list[SizeClass]:
        """Sand of several sizes, finest first, as stated or as spread; none: all grains are alike."""
        if self.size_spread is None:
            return self.sizes
        return lognormal(self.grain_diameter, self.size_spread, self.size_classes)

    @property
    def diameter(self) -> float:
        """Mean diameter (m) of the grains, by volume."""
        return mean_diameter(self.classes) if self.classes else self.grain_diameter

    @property
    def by_size(self) -> list[Self]:
        """The same rules for the grains of each size alone, finest first."""
        alike: dict[str, object] = {"sizes": [], "size_spread": None}
        found = [alike | {"grain_diameter": one.diameter} for one in self.classes]
        return [self.model_copy(update=changes) for changes in found] or [self]

    @property
    def step_seconds(self) -> float | None:
        """Duration (s) of a step, as the bed sees it; complete trajectories have none."""
        return None if self.flight_seconds is None else self.flight_seconds / self.weight
