"""Nield and Baas's model: slabs of sand among plants whose growth follows erosion and deposition."""

import math
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from barchan.bed import Bed
from barchan.fields import FieldInfo
from barchan.model import Curve, Derived, ModelMeasure, Overlay
from barchan.parameters import parameter, redeclared
from barchan.plants.layouts import UniformPlants, Vegetation
from barchan.plants.positions import COVER_BY_POSITION
from barchan.plants.species import SPECIES, Grass, Mesquite, Shrub, Species
from barchan.slabs.model import SlabModel
from barchan.slabs.parameters import SlabParameters
from barchan.slabs.rules import ErosionChance, Rules
from barchan.streams import Stream
from barchan.wind.clock import YEAR, spoken
from barchan.wind.segment import Segment

STEPS_PER_YEAR = 80
"""Steps of a year where neither a scenario nor its clock says otherwise."""

_ROUNDING = 1e-9
"""Slack for ends of years that are whole steps but for rounding."""


class NieldBaasParameters(SlabParameters):
    """Parameters of Nield and Baas's model."""

    name: Literal["nield_baas"] = parameter("nield_baas", unit="-", meaning="Nield and Baas's model.")
    hop_length: float = redeclared(SlabParameters, "hop_length", 1.0, "Nield & Baas 2008")
    polling: Literal["repeated", "non_repeated"] = redeclared(
        SlabParameters, "polling", "non_repeated", "Nield & Baas 2008"
    )
    repose_angle: float = redeclared(SlabParameters, "repose_angle", 30.0, "Nield & Baas 2008")
    erosion_chance: float = parameter(
        1.0,
        unit="-",
        ge=0,
        le=1,
        live=True,
        group="vegetation",
        meaning="Chance that a polled cell without plants gives a slab; plants take their effectiveness off.",
        source="Nield & Baas 2008; Prague thesis, eq. 4.4",
    )
    stabilised_repose_angle: float = parameter(
        40.0,
        unit="degrees",
        ge=1,
        le=89,
        live=True,
        group="vegetation",
        meaning="Angle of repose where plants hold the sand.",
        source="Nield & Baas 2008; Prague thesis, §4.7",
    )
    stabilised_cover: float = parameter(
        0.3,
        unit="-",
        ge=-10,
        le=10,
        live=True,
        group="vegetation",
        meaning="Effectiveness from which on plants hold the sand.",
        source="Nield & Baas 2008; Prague thesis, §4.7",
    )
    steps_per_year: int | None = parameter(
        None,
        unit="steps",
        ge=1,
        le=1_000_000,
        scale="log",
        group="vegetation",
        meaning="Steps after which plants grow or die by the year's sediment balance; where it is not given, "
        "80, or with a clock those of a calendar year.",
        source="Nield & Baas 2008; Prague thesis, Tables 6.4-6.6",
    )
    grass: Grass = Field(
        default_factory=Grass, description="Pioneer grass; its curve is that of DECAL's descendants."
    )
    mesquite: Mesquite = Field(
        default_factory=Mesquite,
        description="Mesquite; its curve is assumed, for the published one was not found: like the shrub's "
        "under erosion, with a broad optimum under moderate burial.",
    )
    shrub: Shrub = Field(
        default_factory=Shrub, description="Woody shrub; its curve is that of DECAL's descendants."
    )
    vegetation: Vegetation = Field(default_factory=UniformPlants, description="Plants at the start.")


def _cover_of(name: str) -> FieldInfo:
    return FieldInfo(name, "float64", "1", f"effectiveness of {name}")


def _mean_of(name: str) -> ModelMeasure:
    return ModelMeasure(
        f"mean_{name}", f"mean {name}", "-", lambda _model, bed, _wind: float(bed.arrays[name].mean())
    )


PLANTS = tuple(map(_cover_of, SPECIES))
BALANCE = FieldInfo("balance", "float64", "m", "sand gained in the last full year", centre=0.0)
YEAR_START = FieldInfo("year_start", "int32", "slabs", "sand at the start of the year", in_frames=False)


class NieldBaas(SlabModel):
    """Dunes that plants hold: nebkhas, parabolic dunes, blowouts.

    Each cell has an effectiveness of grass, mesquite and shrub; rho is their sum, which may leave 0 to 1.
    A polled cell gives a slab with probability p_e = ``erosion_chance`` - rho, and a slab settles with
    p_d = p + rho (1 - p), where p is ``p_s`` on sand and ``p_ns`` on bare ground; both are held within 0
    and 1.
    From ``stabilised_cover`` on, sand rests at ``stabilised_repose_angle``. After each year,
    ``steps_per_year`` steps or by the clock, every species changes by its curve of growth at the cell's
    sediment balance of the year, within its range.

    Known deviations: the Prague thesis prints p_d with the sign of rho reversed; plants increase deposition.
    The curve of mesquite is assumed. An oblique wind is exact here, where the paper polls a third of the
    slabs along one axis and two thirds along the other.
    """

    name = "nield_baas"
    title = "Nield & Baas 2008"
    citation = (
        "Nield, J. M. & Baas, A. C. W. (2008). Investigating parabolic and nebkha dune formation using a "
        "cellular automaton modelling approach. Earth Surface Processes and Landforms 33(5), 724-740."
    )
    Parameters = NieldBaasParameters
    parameters: NieldBaasParameters
    fields = (*PLANTS, BALANCE, YEAR_START)
    derived = (
        *SlabModel.derived,
        Derived(
            "effectiveness",
            "1",
            "effectiveness of all plants",
            lambda model, bed, _: model.effectiveness(bed),
        ),
    )
    measures = (*map(_mean_of, SPECIES), *COVER_BY_POSITION)
    overlays = (Overlay("effectiveness", "plants", "Greens", SPECIES),)

    def initialise(self, bed: Bed, seed: int) -> None:
        """Plant what stands there at first."""
        super().initialise(bed, seed)
        cover = self.parameters.vegetation.cover(self.lattice, Stream(seed, "vegetation"))
        for field in PLANTS:
            kind: Species = getattr(self.parameters, field.name)
            bed.add(field, np.clip(cover[field.name], kind.lowest, kind.highest))
        bed.add(BALANCE, np.zeros(self.lattice.shape))
        bed.add(YEAR_START, bed.sand)

    def paintable(self) -> dict[str, tuple[float, float]]:
        """Each species, from none to its greatest effectiveness."""
        kinds: dict[str, Species] = {name: getattr(self.parameters, name) for name in SPECIES}
        return {name: (max(kind.lowest, 0.0), max(kind.highest, 0.0)) for name, kind in kinds.items()}

    def start(self, bed: Bed) -> None:
        """Begin the first year."""
        bed.arrays["year_start"][...] = bed.sand

    def effectiveness(self, bed: Bed) -> NDArray[np.float64]:
        """Sum of the effectiveness of all plants of each cell: rho."""
        return np.sum([bed.arrays[name] for name in SPECIES], axis=0)

    def mobility(self, bed: Bed, direction: float) -> NDArray[np.float64]:
        """The share of each cell that no plant covers."""
        return 1.0 - self.effectiveness(bed)

    def rules(self) -> Rules:
        """Chances that plants change, and where they hold the sand."""
        return Rules(
            erosion=ErosionChance(offset=self.parameters.erosion_chance - 1.0),
            stabilised_angle=self.parameters.stabilised_repose_angle,
            stabilised_mobility=1.0 - self.parameters.stabilised_cover,
        )

    def problems(self, step_seconds: float | None) -> list[tuple[str, str]]:
        """Refuse a year of growth other than the calendar year where a clock defines its duration."""
        return [*super().problems(step_seconds), *self._year_problems(step_seconds)]

    def _year_problems(self, step_seconds: float | None) -> list[tuple[str, str]]:
        if step_seconds is None:
            return []
        if step_seconds > YEAR:
            text = f"a step lasts {spoken(step_seconds)} by the clock, and plants grow once a year"
            return [("name", f"{text}; allowed: steps of a year or less")]
        stated, calendar = self.parameters.steps_per_year, round(YEAR / step_seconds)
        if stated is None or stated == calendar:
            return []
        text = f"is {stated}, but a calendar year has {calendar} steps of {spoken(step_seconds)} by the clock"
        return [("steps_per_year", f"{text}; leave one of them out")]

    def _year_end(self, step: int, step_seconds: float | None) -> int:
        """After how many steps of the run the year of a step ends."""
        year: float = self.parameters.steps_per_year or STEPS_PER_YEAR
        if step_seconds is not None:
            year = YEAR / step_seconds
        years = math.floor(step / year)
        ends = (math.ceil(k * year - _ROUNDING) for k in (years + 1, years + 2))
        return next(end for end in ends if end > step)

    def steps_until_update(self, segment: Segment) -> int:
        """Steps until the year ends."""
        return self._year_end(segment.step, segment.step_seconds) - segment.step

    def after_steps(self, bed: Bed, segment: Segment) -> None:
        """Let plants grow when a year is over."""
        done = segment.step + segment.steps
        if segment.ends and self._year_end(done - 1, segment.step_seconds) == done:
            self._grow(bed)

    def _grow(self, bed: Bed) -> None:
        balance = (bed.sand - bed.arrays["year_start"]) * self.lattice.thickness
        was_stabilised = self.effectiveness(bed) >= self.parameters.stabilised_cover
        for name in SPECIES:
            cover = bed.arrays[name]
            cover[...] = getattr(self.parameters, name).grown(cover, balance)
        bed.arrays["balance"][...] = balance
        loosened = was_stabilised & (self.effectiveness(bed) < self.parameters.stabilised_cover)
        if loosened.any():
            self.relax(bed, loosened)
        bed.arrays["year_start"][...] = bed.sand

    @classmethod
    def curves(cls, parameters: NieldBaasParameters) -> list[Curve]:
        """The growth of each species."""
        return [
            Curve(
                title=name,
                x=tuple(vertex.balance for vertex in getattr(parameters, name).curve),
                y=tuple(vertex.change for vertex in getattr(parameters, name).curve),
                x_title="sediment balance (m/yr)",
                y_title="change of effectiveness (1/yr)",
                remark="assumed" if name == "mesquite" else "",
            )
            for name in SPECIES
        ]
