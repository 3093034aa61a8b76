"""A bench of isotropy: a field of bedforms under a wind at an angle to the lattice, measured and kept.

A variant is data: a model, its options, and options of the lattice, so that a lattice of another kind is one
more variant. Results are kept in ``validation/cache`` by a key of everything that defines the run, so that
an interrupted study goes on where it was; delete the folder when the bits of models have changed.
"""

import hashlib
import json
import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import barchan
from barchan.measures.migration import moved
from barchan.measures.orientation import crest_orientation
from barchan.measures.spacing import dominant_spacing
from barchan.squares import Squares
from validation.orientation import difference

CACHE = Path(__file__).parent / "cache"

EARLY = 100
"""Steps after which the relief shows how fast dunes grow."""

LAG = 10
"""Steps over which migration is measured, from ``EARLY`` on."""


@dataclass(frozen=True, eq=False)
class Variant:
    """A model with its options, on a lattice with options of its own."""

    name: str
    model: str
    options: dict[str, Any] = field(default_factory=dict)
    lattice: dict[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Case:
    """One run: a variant under winds (direction, steps of a turn) that blow in turn, or a single one."""

    variant: Variant
    winds: tuple[tuple[float, int], ...]
    seed: int
    size: int = 256
    steps: int = 800
    mean: int = 10

    @property
    def key(self) -> str:
        """A name for everything that defines the run."""
        told = asdict(self)
        told["variant"].pop("name")
        return hashlib.sha256(json.dumps(told, sort_keys=True).encode()).hexdigest()[:24]

    def scenario(self) -> barchan.Scenario:
        """The scenario of the run; rules that a variant does not name are those of format 4."""
        lattice = {"rows": self.size, "columns": self.size, **self.variant.lattice}
        wind: dict[str, Any] = {"kind": "steady", "direction": self.winds[0][0]}
        if len(self.winds) > 1:
            turns = [{"direction": direction, "steps": steps} for direction, steps in self.winds]
            wind = {"kind": "regimes", "regimes": turns}
        return barchan.load(
            {
                "barchan": 4,
                "lattice": lattice,
                "sand": {"kind": "random", "mean": self.mean},
                "wind": wind,
                "model": {"name": self.variant.model, **self.variant.options},
                "run": {"seed": self.seed, "steps": self.steps, "save_every": self.steps, "threads": 1},
            }
        )


def steady(variant: Variant, angle: float, seed: int, **changes: int) -> Case:
    """A run under a steady wind at an angle (degrees, clockwise) to a wind from 270°."""
    return Case(variant, ((270.0 + angle, 1),), seed, **changes)


def kept(key: str, run: Callable[[], dict[str, float]]) -> dict[str, float]:
    """The result of a run that is known by a key, out of the cache or by running it."""
    path = CACHE / f"{key}.json"
    if not path.exists():
        found = run()
        CACHE.mkdir(exist_ok=True)
        path.with_suffix(".new").write_text(json.dumps(found), "utf-8")
        path.with_suffix(".new").replace(path)
    return dict(json.loads(path.read_text("utf-8")))


def measured(case: Case) -> dict[str, float]:
    """The measures of a run, out of the cache or by running it."""
    return kept(case.key, lambda: _run(case))


def over(cases: Iterable[Case]) -> list[dict[str, float]]:
    """The measures of some runs, one after the other."""
    return [measured(case) for case in cases]


def _run(case: Case) -> dict[str, float]:
    scenario = case.scenario()
    cell, direction = scenario.lattice.cell_size, case.winds[0][0]
    simulation = barchan.Simulation(scenario)
    simulation.advance(EARLY)
    squares = Squares(scenario.lattice)
    early = squares.between(simulation.elevation).copy()
    simulation.advance(LAG)
    shift = moved(early, squares.between(simulation.elevation), (True, True))
    simulation.advance(case.steps - EARLY - LAG)
    surface = squares.between(simulation.elevation)
    crest = crest_orientation(surface, cell)
    x, y = barchan.directions.downwind(direction)
    return {
        "azimuth": crest.azimuth,
        "coherence": crest.coherence,
        "spectral_azimuth": spectral_azimuth(surface, cell),
        "early_relief": float(early.std()),
        "relief": float(surface.std()),
        "early_spacing": dominant_spacing(early, cell, direction),
        "spacing": dominant_spacing(surface, cell, direction),
        "migration": float(shift[1] * x + shift[0] * y) / LAG,
    }


def spectral_azimuth(surface: NDArray[np.floating[Any]], cell: float) -> float:
    """Crest azimuth (degrees) from the power spectrum: across the mean axis of its waves.

    Each wave is weighted with the square of its power, and its axis counts twice its angle, so that a wave
    and
    its opposite are one. It is a check of the structure tensor, which weighs steep slopes.
    """
    power = np.abs(np.fft.fft2(surface - surface.mean())) ** 2
    north = np.fft.fftfreq(surface.shape[0], cell)[:, None]
    east = np.fft.fftfreq(surface.shape[1], cell)[None, :]
    doubled = np.sum(power**2 * np.exp(2j * np.arctan2(north, east)))
    return float(-np.degrees(0.5 * np.angle(doubled)) % 180.0)


def errors(found: Sequence[dict[str, float]], angle: float, name: str = "azimuth") -> list[float]:
    """Errors (degrees, clockwise) of crests from the line across a steady wind."""
    return [difference(result[name], angle % 180.0) for result in found]


def turning(variant: Variant, waves: tuple[int, int], steps: int, seed: int, size: int = 128) -> float:
    """How far (degrees, clockwise) a planted train of ridges turns under a wind straight across it.

    ``waves`` are the whole numbers of waves eastwards and northwards on the periodic field, which give the
    wind's direction; the ridges are sines of 4 slabs about a mean of 10.
    """
    direction = math.degrees(math.atan2(-waves[0], -waves[1])) % 360.0
    case = Case(variant, ((direction, 1),), seed, size, steps)
    return kept(f"turning-{waves[0]}-{waves[1]}-{case.key}", lambda: _turned(case, waves))["turned"]


def _turned(case: Case, waves: tuple[int, int]) -> dict[str, float]:
    size, steps = case.size, case.steps
    flat = barchan.load(case.scenario().data(), sand={"kind": "flat", "mean": case.mean})
    simulation = barchan.Simulation(flat)
    phase = 2 * np.pi * np.add.outer(waves[1] * np.arange(size), waves[0] * np.arange(size)) / size
    sand = np.rint(case.mean + 4 * np.sin(phase)).astype(np.int32)
    missing = int(simulation.bed.sand.sum() - sand.sum())
    sand.flat[: abs(missing)] += np.sign(missing)
    simulation.bed.sand[:] = sand
    cell = simulation.scenario.lattice.cell_size
    before = crest_orientation(simulation.elevation, cell).azimuth
    simulation.advance(steps)
    return {"turned": difference(crest_orientation(simulation.elevation, cell).azimuth, before)}
