"""Parameters of snow that drifts, bonds and packs."""

from typing import ClassVar, Literal

from pydantic import Field

from barchan.aeolian.snow.density import GREATEST_DENSITY, LEAST_DENSITY
from barchan.lattice import Lattice
from barchan.parameters import Parameters, parameter
from barchan.slabs.parameters import SlabParameters
from barchan.snow.drifting import Abrasion, Drift, Relief, SnowCreep, Threshold
from barchan.snow.resting import Bonding, Packing, Repose, Snowfall


class OldLayer(Parameters):
    """A layer of snow that lies on the ground at the start."""

    mass: float = parameter(
        10.0,
        unit="kg/m²",
        ge=0.001,
        le=1e5,
        meaning="Mass of the layer, rounded to whole quanta.",
        source="ours",
    )
    density: float = parameter(
        350.0,
        unit="kg/m³",
        ge=LEAST_DENSITY,
        le=GREATEST_DENSITY,
        meaning="Density of the layer.",
        source="ours",
    )
    age: float = parameter(
        24.0, unit="h", ge=0, le=1e5, meaning="Age of its bonds, in hours at -10 °C.", source="ours"
    )
    weak_share: float = parameter(
        0.0,
        unit="-",
        ge=0,
        le=1,
        meaning="Share of cells, chosen at random, where the layer is weak: its bonds as young as weak_age.",
        source="ours",
    )
    weak_age: float = parameter(
        0.1,
        unit="h",
        ge=0,
        le=1e5,
        meaning="Age of the bonds of weak cells, in hours at -10 °C.",
        source="ours",
    )


class SnowParameters(Parameters):
    """How quanta of snow are taken, carried and laid down; closures have groups of their own."""

    kind_key: ClassVar[str] = "name"

    quantum: float = parameter(
        1.0,
        unit="kg/m²",
        ge=0.1,
        le=100,
        scale="log",
        meaning="Mass of one quantum of snow on a cell; a start in slabs counts quanta.",
        source="ours",
    )
    layers: int = parameter(
        8,
        unit="layers",
        ge=2,
        le=16,
        meaning="Buried layers that a cell keeps apart; more are merged.",
        source="ours",
    )
    hop: float = parameter(
        0.1,
        unit="m",
        ge=0.001,
        le=100,
        scale="log",
        group="transport",
        meaning="Distance of one hop.",
        source="mean path of saltation, 0.05 to 0.3 m: Kobayashi 1972",
    )
    p_s: float = parameter(
        0.6,
        unit="-",
        ge=0.001,
        le=1,
        group="transport",
        meaning="Chance that a quantum rests where it lands on loose snow on the flat.",
        source="Werner 1995",
    )
    p_ns: float = parameter(
        0.1,
        unit="-",
        ge=0,
        le=1,
        live=True,
        group="transport",
        meaning="The same on bonded snow and on bare ground, from which grains rebound.",
        source="ours",
    )
    erosion_chance: float = parameter(
        0.5,
        unit="-",
        ge=0.001,
        le=1,
        group="transport",
        meaning="Chance that a polled cell of flat, fresh drift gives a quantum while drift is in the air.",
        source="ours",
    )
    max_hops: int = parameter(
        10_000,
        unit="hops",
        ge=1,
        le=1_000_000_000,
        group="transport",
        meaning="Number of hops after which a quantum is put down wherever it is, and counted.",
        source="ours",
    )
    shadow_angle: float = parameter(
        28.0,
        unit="degrees",
        ge=1,
        lt=90,
        live=True,
        group="transport",
        meaning="Angle at which the shadow line falls behind whatever stands upwind.",
        source="ours: the flow separates behind slip faces only",
    )
    neighbourhood: Literal["von_neumann", "moore"] = parameter(
        "von_neumann",
        unit="-",
        live=True,
        group="transport",
        meaning="Cells that snow may slide to: the four faces, or the four corners too.",
        source="ours",
    )
    band_rows: int = parameter(
        32,
        unit="cells",
        ge=1,
        le=65536,
        group="transport",
        meaning="Width of the bands in which a step polls the field, in random order.",
        source="ours",
    )
    temperature: float = parameter(
        -10.0,
        unit="°C",
        ge=-90,
        le=5,
        group="weather",
        meaning="Temperature of air and snow where the wind states none.",
        source="ours",
    )
    reference_wind: float = parameter(
        10.0,
        unit="m/s",
        gt=0,
        le=100,
        group="weather",
        meaning="Wind at 10 m, at the model's temperature, under which a step polls as many cells as the "
        "field has; a step lasts as long as this wind takes to carry what its polls move over fresh drift. "
        "It blows where the wind states no speed.",
        source="ours",
    )
    air_density: float = parameter(
        1.2,
        unit="kg/m³",
        ge=0.1,
        le=10,
        group="weather",
        meaning="Density of the air.",
        source="ours: the value that the thresholds were computed with",
    )
    start_density: float | None = parameter(
        None,
        unit="kg/m³",
        ge=LEAST_DENSITY,
        le=GREATEST_DENSITY,
        group="start",
        meaning="Density of the snow at the start; that of drift under the reference wind where not given.",
        source="ours",
    )
    start_age: float = parameter(
        0.1,
        unit="h",
        ge=0,
        le=1e5,
        group="start",
        meaning="Age of its bonds, in hours at -10 °C.",
        source="ours",
    )
    beneath: tuple[OldLayer, ...] = Field(
        default=(), description="Older layers beneath the snow of the start, the lowest first."
    )
    drift: Drift = Field(default_factory=Drift, description="Drifting snow.")
    threshold: Threshold = Field(default_factory=Threshold, description="What loose grains withstand.")
    bonding: Bonding = Field(default_factory=Bonding, description="Bonds between grains.")
    relief: Relief = Field(default_factory=Relief, description="The wind over relief.")
    creep: SnowCreep = Field(default_factory=SnowCreep, description="Grains that roll.")
    abrasion: Abrasion = Field(default_factory=Abrasion, description="Bonded snow worn by drift.")
    snowfall: Snowfall = Field(default_factory=Snowfall, description="Snow that falls.")
    packing: Packing = Field(default_factory=Packing, description="Snow that packs.")
    repose: Repose = Field(default_factory=Repose, description="How steep snow stands.")

    def as_slabs(self, lattice: Lattice) -> SlabParameters:
        """The parameters that snow shares with slabs of sand; a hop may be any number of cells."""
        return SlabParameters.model_construct(
            hop_length=self.hop / lattice.cell_size,
            p_s=self.p_s,
            p_ns=self.p_ns,
            max_hops=self.max_hops,
            shadow_angle=self.shadow_angle,
            neighbourhood=self.neighbourhood,
            band_rows=self.band_rows,
        )
