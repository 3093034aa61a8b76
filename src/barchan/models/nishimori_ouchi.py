"""Nishimori & Ouchi's model: ripples from hops that are longer from higher ground, and creep."""

from typing import Any, ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Bed
from barchan.directions import downwind
from barchan.model import Model, Tally
from barchan.parameters import Parameters, parameter
from barchan.streams import Stream, derive
from barchan.wind.segment import Segment


class NishimoriOuchiParameters(Parameters):
    """Parameters of Nishimori & Ouchi's model."""

    kind_key: ClassVar[str] = "name"

    name: Literal["nishimori_ouchi"] = parameter(
        "nishimori_ouchi", unit="-", meaning="Nishimori & Ouchi's model."
    )
    hop_length: float = parameter(
        7.3,
        unit="cells",
        ge=0,
        le=100_000,
        scale="log",
        live=True,
        group="saltation",
        meaning="Length of a hop from ground of no height (L0); a wind that states its speed in cells "
        "overrides it.",
        source="a public program by R. Naruse",
    )
    hop_growth: float = parameter(
        2.0,
        unit="-",
        ge=-100,
        le=100,
        live=True,
        group="saltation",
        meaning="Cells by which a hop is longer for each cell's width of height (b).",
        source="a public program by R. Naruse",
    )
    hop_share: float = parameter(
        0.6,
        unit="cells",
        gt=0,
        le=100,
        live=True,
        group="saltation",
        meaning="Height that hops from each cell in a step, in widths of a cell (q).",
        source="a public program by R. Naruse",
    )
    creep: float = parameter(
        0.8,
        unit="-",
        ge=0,
        le=1,
        live=True,
        group="creep",
        meaning="Share of the difference to the neighbours' mean that creep takes away in a step (D).",
        source="a public program by R. Naruse",
    )


class NishimoriOuchi(Model):
    """The coupled-map model of ripples.

    In each step

    * *saltation*: every cell gives a height ``hop_share``, as far as it has it, which lands downwind after
      L0 + b h, h being the cell's height over the mean;
    * *creep*: every cell exchanges D / 6 of the difference with each of four face neighbours and D / 12 with
      each of four corner neighbours.

    All cells hop at once, then all creep at once. Known deviations: the paper moves real numbers; here whole
    parcels move, each share rounded up or down by a random number so that it is right in the mean, and no
    cell gives more than it has. Hops are rounded likewise. Heights count from the mean and in widths of a
    cell, so that results depend neither on the depth of the sand nor on the parcels. Creep crosses no open
    edge. The paper was not at hand; its rules and values were taken from public programs.
    """

    name = "nishimori_ouchi"
    title = "Nishimori & Ouchi 1993"
    citation = (
        "Nishimori, H. and Ouchi, N. (1993). Formation of ripple patterns and dunes by wind-blown sand. "
        "Physical Review Letters 71(1), 197-200."
    )
    work_unit = "cell updates"
    work_per_second = 1.5e7
    Parameters = NishimoriOuchiParameters
    parameters: NishimoriOuchiParameters

    def expected_work(self, segment: Segment) -> float:
        """All cells in each step, however strong the wind is."""
        return float(segment.steps * self.lattice.cells) if segment.polls else 0.0

    def advance(self, bed: Bed, segment: Segment, stream: Stream) -> Tally:
        """Hop and creep, step by step."""
        from barchan.kernels.coupled_map import CREEP, HOP, TRAVEL_UNIT, creep, hop

        total = Tally()
        lattice, rules = self.lattice, self.parameters
        ground = bed.ground / lattice.thickness
        x, y = downwind(segment.direction)
        base = rules.hop_length if segment.hop_length is None else segment.hop_length
        for step in range(segment.step, segment.step + segment.steps):
            key = derive(stream.key, step)
            height = ((ground + bed.sand) - (ground + bed.sand).mean()) * lattice.aspect
            lengths = np.maximum(base + rules.hop_growth * height, 0.0)
            counts = np.zeros(4, np.int64)
            blows = segment.polls > 0
            if blows:
                hop(
                    *(bed.sand, lengths * x, lengths * y, rules.hop_share / lattice.aspect),
                    *(np.uint64(derive(key, HOP)), *lattice.periodic, counts),
                )
            surface = ground + bed.sand
            crept = creep(surface, bed.sand, rules.creep, np.uint64(derive(key, CREEP)), *lattice.periodic)
            total.add(
                Tally(
                    steps=1,
                    polls=lattice.cells if blows else 0,
                    moved=int(counts[0]),
                    crept=int(crept),
                    left=int(counts[1]),
                    travel_x=int(counts[2]) / TRAVEL_UNIT,
                    travel_y=int(counts[3]) / TRAVEL_UNIT,
                )
            )
        return total

    def relax(self, bed: Bed, where: NDArray[np.bool_] | None = None) -> int:
        """Every slope holds here."""
        return 0

    def facts(self) -> dict[str, str]:
        """How many parcels hop."""
        parcels = self.parameters.hop_share / self.lattice.aspect
        return {"hopping in a step": f"{parcels:.3g} parcels from each cell"}

    def state(self) -> dict[str, Any]:
        """Nothing but the bed."""
        return {}
