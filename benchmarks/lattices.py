"""What a poll costs on hexagons against one on squares, on beds that have grown under the same wind."""

import time
from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from barchan.bed import Bed
from barchan.lattice import Lattice
from barchan.models import models
from barchan.streams import Stream
from barchan.wind.segment import Segment

SIZE, DEPTH = 256, 10
GROWN, SPELL, SPELLS = 300, 20, 15
"""Steps until a bed has grown, and steps and number of the spells that are timed."""

SHADOWS: dict[str, dict[str, str]] = {
    "from the centre": {"shadow_from": "centre"},
    "from the place, level tops": {"shadow_from": "place", "stack_tops": "level"},
    "from the place, sloping tops": {"shadow_from": "place", "stack_tops": "sloping"},
}

CASES = (
    (0.0, "from the centre"),
    *((20.0, shadow) for shadow in SHADOWS),
)
"""Angle of the wind to the rows (degrees), and shadow lines."""


@dataclass
class Growing:
    """A bed on one lattice under one wind, and what its polls took (ns) in each spell."""

    kind: str
    angle: float
    model: str
    shadow: str
    taken: list[float] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.lattice = Lattice(rows=SIZE, columns=SIZE, kind=self.kind)
        slabs = models()[self.model]
        self.slabs = slabs(slabs.Parameters(**SHADOWS[self.shadow]), self.lattice)
        depth = np.full(self.lattice.shape, DEPTH)
        self.bed = Bed(self.lattice, np.zeros(self.lattice.shape), depth, layers=self.slabs.layers)
        self.slabs.initialise(self.bed, 1)
        self.steps = 0
        self.grow(GROWN)

    def grow(self, steps: int) -> float:
        """Advance by some steps; processor time a poll (ns)."""
        wind = Segment(self.steps, steps, 0, self.lattice.cells, 270.0 - self.angle)
        began = time.process_time()
        tally = self.slabs.advance(self.bed, wind, Stream(1, "transport"))
        self.steps += steps
        return (time.process_time() - began) / tally.polls * 1e9

    @property
    def nanoseconds(self) -> float:
        return min(self.taken)


def report() -> Iterator[str]:
    """The table, line by line."""
    yield "| squares and hexagons | shadow | ns a poll on squares | on hexagons |"
    yield "|---|---|---|---|"
    for model in ("werner", "momiji"):
        for angle, shadow in CASES:
            pair = [Growing(kind, angle, model, shadow) for kind in ("square", "hex")]
            for _ in range(SPELLS):
                for bed in pair:
                    bed.taken.append(bed.grow(SPELL))
            squares, hexagons = (bed.nanoseconds for bed in pair)
            wind = f"{angle:g}° off the rows" if angle else "along the rows"
            ratio = f"{hexagons / squares:.2f} times"
            yield f"| {model}, wind {wind} | {shadow} | {squares:.0f} | {hexagons:.0f} ({ratio}) |"
    yield ""
    yield (
        f"{SIZE} × {SIZE} cells, {DEPTH} slabs a cell, after {GROWN} steps from a flat bed; the fastest of "
        f"{SPELLS} spells of {SPELL} steps, in turns on both lattices, on one thread. Beds differ between "
        "lattices, and with them how soon a line meets what shelters."
    )
