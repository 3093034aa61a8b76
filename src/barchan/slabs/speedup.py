"""Slab transport under a wind that speeds up with height: what Momiji's and Bishop's models share."""

from typing import Any, ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Bed
from barchan.model import Curve, Derived, ModelMeasure
from barchan.parameters import parameter
from barchan.slabs.model import SlabModel
from barchan.slabs.parameters import SlabParameters
from barchan.slabs.rules import HopRule, Rules
from barchan.wind.segment import Segment


class SpeedupParameters(SlabParameters):
    """Slab transport with hops that grow with height above a reference."""

    speedup_linear: float = parameter(
        0.4,
        unit="cells/slab",
        ge=0,
        le=1000,
        live=True,
        group="transport",
        meaning="How much longer (below the reference: shorter) a hop is for each slab of height, C1.",
        source="Momiji et al. 2000; Bishop et al. 2002; Prague thesis, eq. 3.2",
    )
    speedup_quadratic: float = parameter(
        0.002,
        unit="cells/slab²",
        ge=0,
        le=1000,
        live=True,
        group="transport",
        meaning="How much longer a hop is for each slab of height squared, above the reference only, C2.",
        source="Momiji et al. 2000; Bishop et al. 2002; Prague thesis, eq. 3.2",
    )
    hop_rounding: Literal["nearest", "none"] = parameter(
        "nearest",
        unit="-",
        live=True,
        group="transport",
        meaning="Whether a hop is rounded to whole cells (halves up; a cell whose hop rounds to zero gives "
        "no slab) or keeps its length: then slabs start anywhere within their cell and the mean is exact.",
        source="ours: the papers' rule was not found",
    )
    hop_from: Literal["every_landing", "start"] = parameter(
        "every_landing",
        unit="-",
        live=True,
        group="transport",
        meaning="Whether a slab that hops on goes by the height where it landed (and is put down where that "
        "hop is zero), or by the height where it was taken up.",
        source="ours: Prague thesis, eq. 3.2 gives the wind at the cell; the papers' rule was not found",
    )


def hops_at(
    parameters: SpeedupParameters, hop_length: float, rise: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Hop length (cells) at heights (slabs) above the reference, before it is rounded."""
    hops = hop_length + parameters.speedup_linear * rise
    hops += np.where(rise > 0.0, parameters.speedup_quadratic * rise**2, 0.0)
    return hops


class SpeedupModel(SlabModel):
    """A slab model whose hops grow with height; see ``follows_relief`` for the reference."""

    Parameters = SpeedupParameters
    parameters: SpeedupParameters
    follows_relief = False
    """Whether heights are measured from the mean less half the mean distance from it, or from the mean."""
    derived: tuple[Derived, ...] = (
        *SlabModel.derived,
        Derived(
            "hop",
            "cells",
            "hop length",
            lambda model, bed, wind: model.open_hops(bed, wind),
            centred=True,
            sheltered=True,
            along_wind=True,
            least=0.0,
        ),
        Derived(
            "speedup",
            "1",
            "hop length over that on a flat bed",
            lambda model, bed, wind: model.open_hops(bed, wind) / model.hop_length(wind),
            centred=True,
            sheltered=True,
            along_wind=True,
            least=0.0,
        ),
    )

    measures: ClassVar[tuple[ModelMeasure, ...]] = (
        ModelMeasure(
            "reference_height",
            "reference height of hops",
            "m",
            lambda model, bed, _: model.reference_height(bed) * model.lattice.thickness,
        ),
    )

    @classmethod
    def curves(cls, parameters: Any) -> list[Curve]:
        """Hops by the height above the reference; below it only their linear part counts."""
        rises = np.linspace(-10.0, 40.0, 51)
        return [
            Curve(
                title="hop",
                x=tuple(rises.tolist()),
                y=tuple(hops_at(parameters, parameters.hop_length, rises).tolist()),
                x_title="height above the reference (slabs)",
                y_title="hop length (cells)",
                source="Momiji et al. 2000; Bishop et al. 2002",
            )
        ]

    def rules(self) -> Rules:
        """Hops that grow with height."""
        return Rules(
            hop=HopRule(
                linear=self.parameters.speedup_linear,
                quadratic=self.parameters.speedup_quadratic,
                follows_relief=self.follows_relief,
                whole=self.parameters.hop_rounding == "nearest",
                every_hop=self.parameters.hop_from == "every_landing",
            )
        )

    def reference_height(self, bed: Bed) -> float:
        """The height (slabs) at which a hop has its plain length."""
        heights = bed.elevation / self.lattice.thickness
        mean = float(heights.mean())
        return mean - 0.5 * float(np.abs(heights - mean).mean()) if self.follows_relief else mean

    def hops(self, bed: Bed, hop_length: float) -> NDArray[np.float64]:
        """Hop length (cells) from each cell, before it is rounded; negative: against the wind."""
        rise = bed.elevation / self.lattice.thickness - self.reference_height(bed)
        return hops_at(self.parameters, hop_length, rise)

    def open_hops(self, bed: Bed, wind: Segment) -> NDArray[np.float64]:
        """Hop length (cells) of slabs that the wind takes: 0 in shadow, unless ``lee_erosion`` is on.

        The law of hops knows only heights, so just behind a crest it still gives long hops; the shadow
        keeps slabs there. Together they are the wind as the model has it: fast on the crest, gone
        in the lee.
        """
        return self.unsheltered(self.hops(bed, self.hop_length(wind)), bed, wind.direction)
