"""How long a scenario's wind lasts and comes again, in steps of the run."""

import math
from typing import TYPE_CHECKING

import numpy as np

from barchan.wind import SeriesWind
from barchan.wind.clock import spoken
from barchan.wind.regimes import Regimes
from barchan.words import counted

if TYPE_CHECKING:
    from barchan.scenario.definition import Scenario

ROUNDED = 1e-6
"""Part of a step by which the steps of a wind's length may be off by rounding."""

ALIKE = 0.005
"""Part of a wind's length by which a run may differ and still be called as long; ours."""

CYCLES = 3
"""Cycles of the wind within which measures of a run look for an earlier frame."""

MOST_TRIED = 2000
"""Numbers of steps from frame to frame that are tried, the nearest first."""


def wind_steps(scenario: "Scenario") -> float | None:
    """Steps that a record, a series of storms or regimes last once; None of winds that have no length."""
    wind, clock = scenario.wind, scenario.seeded().forcing().clock
    if isinstance(wind, SeriesWind):
        if clock.step_seconds is None:
            return None
        return float(wind.series(clock.seed).ends[-1]) / clock.step_seconds
    if isinstance(wind, Regimes) and len(wind.regimes) > 1:
        return wind.cycle(clock)
    return None


def wind_length_facts(scenario: "Scenario") -> dict[str, str]:
    """How long the wind lasts, in time and in steps, beside the run, for people to read."""
    steps = wind_steps(scenario)
    if steps is None or not math.isfinite(steps):
        return {}
    whole, seconds = math.ceil(steps - ROUNDED), scenario.step_seconds
    lasts = counted(whole, "step")
    if seconds is not None:
        lasts = f"{spoken(steps * seconds)}, {lasts}"
    share = scenario.run.steps / steps
    compared = f"{share:.3g} times that" if share > 1 else f"its first {100 * share:.2g} %"
    if abs(share - 1.0) < ALIKE:
        compared = "as long"
    return {"wind lasts": f"{lasts}; the run (run.steps {scenario.run.steps}) is {compared}"}


def unmatched_frames(scenario: "Scenario") -> list[str]:
    """A remark where no saved frame is whole cycles of the wind after another, with a number that fits."""
    forcing = scenario.seeded().forcing()
    steps, every = scenario.run.steps, scenario.run.save_every
    cycle = forcing.wind.period(max(steps - 1, 0), forcing.clock)
    if not cycle or not math.isfinite(cycle) or cycle > steps or _fits(every, cycle, steps):
        return []
    tried = sorted(range(1, min(steps, MOST_TRIED) + 1), key=lambda one: (abs(one - every), one))
    fitting = next((one for one in tried if _fits(one, cycle, steps)), None)
    advice = "" if fitting is None else f"; run.save_every {fitting} fits"
    every_one = f"no frame is whole cycles of the wind ({cycle:.5g} steps) after another"
    return [f"migration will have no value: {every_one} with run.save_every {every}{advice}"]


def _fits(every: int, cycle: float, steps: int) -> bool:
    """Whether a frame lies whole cycles after another, frames being saved at multiples of ``every``."""
    from barchan.measures.migration import WHOLE  # measures need libraries that the first page does without

    most = int(min(steps, (CYCLES + WHOLE) * cycle) // every)
    cycles = np.arange(1, most + 1) * (every / cycle)
    return bool(((np.rint(cycles) >= 1) & (np.abs(cycles - np.rint(cycles)) <= WHOLE)).any())
