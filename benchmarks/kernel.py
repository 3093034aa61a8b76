"""The transport kernel: polls and moved slabs a second on one core."""

import statistics
import time
from dataclasses import dataclass

import numpy as np

from barchan.bed import Bed
from barchan.lattice import Lattice
from barchan.models import models
from barchan.streams import Stream
from barchan.wind.segment import Segment


@dataclass(frozen=True)
class Case:
    """A bed, a wind, a model with some variants and a number of steps from a flat bed."""

    name: str
    size: int = 256
    steps: int = 400
    direction: float = 270.0
    lee_erosion: bool = False
    uneven: bool = False
    model: str = "werner"
    depth: int = 3
    rocks: bool = False
    cell_size: float = 1.0
    speed: float | None = None
    variants: tuple[tuple[str, str | bool | int], ...] = ()

    @property
    def parameters(self):
        kind = models()[self.model].Parameters
        asked = {"lee_erosion": self.lee_erosion, "repose_angle": 33.7, "repose_test": "after"}
        shared = {key: value for key, value in asked.items() if key in kind.model_fields}
        return kind(**(shared | dict(self.variants)))


@dataclass(frozen=True)
class Speed:
    """Medians and extremes over the repetitions, in millions a second."""

    case: Case
    polls: list[float]
    moves: list[float]

    @property
    def nanoseconds_a_poll(self) -> float:
        return 1e3 / statistics.median(self.polls)


CASES = (
    Case("erosion in shadow allowed", lee_erosion=True),
    Case("erosion in shadow forbidden"),
    Case("wind from 247.5°, interpolated ray", direction=247.5),
    Case("wind from 225°, interpolated ray", direction=225.0),
    Case("ground that is not flat", uneven=True),
    Case(
        "Moore neighbourhood, 3 slabs to corners", variants=(("neighbourhood", "moore"), ("corner_limit", 3))
    ),
    Case("random order of neighbours", variants=(("neighbour_order", "random"),)),
    Case("non-repeated polling", variants=(("polling", "non_repeated"),)),
    Case("forced erosion", variants=(("forced_erosion", True),)),
    Case("Momiji", model="momiji"),
    Case("Momiji, exact hops", model="momiji", variants=(("hop_rounding", "none"),)),
    Case("Bishop", model="bishop"),
    Case("Nield & Baas, bare at first", model="nield_baas", variants=(("hop_length", 5.0),)),
    Case("Nield & Baas, hops of one cell", model="nield_baas"),
    Case("after Pelletier, 20 slabs a cell", model="pelletier", depth=20),
    Case("Werner, 20 slabs a cell", depth=20),
    Case("release above 45°", variants=(("static_repose_angle", 45.0),)),
    Case("Momiji among rocks, no path test", model="momiji", rocks=True),
    Case("Momiji among rocks, path test", model="momiji", rocks=True, variants=(("path_test", "hard"),)),
    Case(
        "Momiji among rocks, path test for sand too",
        model="momiji",
        rocks=True,
        variants=(("path_test", "surface"),),
    ),
    Case("snow, all closures, 10 m/s", model="snow", depth=60, steps=100, cell_size=0.1, speed=10.0),
    Case("256², 25 steps", steps=25, lee_erosion=True),
    Case("1024², 25 steps", size=1024, steps=25, lee_erosion=True),
    Case("4096², 25 steps", size=4096, steps=25, lee_erosion=True),
    Case("4096², 25 steps, no bands", size=4096, steps=25, lee_erosion=True, variants=(("band_rows", 4096),)),
    Case("256², 25 steps, no erosion in shadow", steps=25),
    Case("1024², 25 steps, no erosion in shadow", size=1024, steps=25),
    Case("4096², 25 steps, no erosion in shadow", size=4096, steps=25),
)


def measure(case: Case, repetitions: int = 5) -> Speed:
    """Time a case; the kernel is compiled and warm before the clock starts."""
    lattice = Lattice(rows=case.size, columns=case.size, cell_size=case.cell_size)
    model = models()[case.model](case.parameters, lattice)
    ground = np.zeros(lattice.shape)
    if case.uneven:
        ground = 0.3 * np.random.default_rng(1).random(lattice.shape)
    if case.rocks:
        ground[100:140, 60:80] = ground[30:70, 160:180] = 20.0
    stream = Stream(1, "transport")
    polls, moves = [], []
    runs = 1 if case.size > 1024 else repetitions
    for repetition in range(runs + 1):
        bed = Bed(lattice, ground, np.where(ground > 1.0, 0, case.depth), layers=model.layers)
        model.initialise(bed, 1)
        steps = case.steps if repetition else 1
        began = time.perf_counter()
        segment = Segment(
            0,
            steps,
            0,
            lattice.cells,
            case.direction,
            speed=case.speed,
            step_seconds=model.step_seconds,
        )
        tally = model.advance(bed, segment, stream)
        seconds = time.perf_counter() - began
        if repetition:
            polls.append(tally.polls / seconds / 1e6)
            moves.append(tally.moved / seconds / 1e6)
    return Speed(case, polls, moves)
