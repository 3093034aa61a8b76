"""The section over time as a file: a picture with a colour bar, or a table."""

import csv
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from barchan.errors import BarchanError
from barchan.scenario import Scenario
from barchan.simulation import Simulation, State
from barchan.studio.worker.background import Count
from barchan.studio.worker.spacetime import Diagram, diagram_of

PICTURES = (".png", ".svg", ".pdf")

DPI = 200
"""Dots per inch of the picture: 1440 × 1000 pixels."""


@dataclass(frozen=True)
class Beside:
    """What the picture of one of two runs has so that it can be compared with that of the other."""

    name: str
    """How the run is named beside the other."""
    limits: tuple[float, float]
    """Elevations (m) from which to which colours reach."""

    def __post_init__(self) -> None:
        if not (np.isfinite(self.limits).all() and self.limits[0] <= self.limits[1]):
            raise BarchanError("a scale of colours needs a lowest and a highest elevation in metres")


def write_space_time(
    states: Sequence[State], line: list[float], target: Path, count: Count, beside: Beside | None = None
) -> str:
    """Write the section along a line (m) at every state; the name of the file.

    Raises BarchanError for a suffix other than ``.csv`` and those of ``PICTURES``, and where that is no line.
    """
    if target.suffix not in (".csv", *PICTURES):
        raise BarchanError(f"'{target.name}' is of an unknown kind; allowed: .csv, {', '.join(PICTURES)}")
    found = diagram_of(states, line, count)
    target.parent.mkdir(parents=True, exist_ok=True)
    if target.suffix == ".csv":
        _write_table(found, target)
    else:
        _draw(found, line, Simulation.from_state(states[-1]).scenario, target, beside)
    return target.name


def _write_table(found: Diagram, target: Path) -> None:
    """A row for each state: step, time (s) where there is one, elevation (m) at each distance (m)."""
    timed = found.seconds is not None
    places = [f"{place:.4f}" for place in found.distance]
    with target.open("w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["step", *(["time_s"] if timed else []), *places])
        for number, (step, heights) in enumerate(zip(found.steps, found.heights, strict=True)):
            moment = [f"{found.seconds[number]:.6g}"] if found.seconds is not None else []
            table.writerow([step, *moment, *(f"{height:.4f}" for height in heights)])


def _draw(found: Diagram, line: list[float], scenario: Scenario, target: Path, beside: Beside | None) -> None:
    from barchan.figures.space_time import section_over_time, suited_times

    half = found.distance[1] / 2
    edges = np.append(found.distance - half, found.distance[-1] + half)
    seconds = None if found.seconds is None else np.array(found.seconds)
    times = suited_times(np.array(found.steps), seconds)
    x0, y0, x1, y1 = (f"{place:.4g}" for place in line)
    whose, limits = ("", None) if beside is None else (f"{beside.name}, ", beside.limits)
    place = f"{whose}from x {x0}, y {y0} m to x {x1}, y {y1} m"
    text = f"{scenario.title or 'Run'}, seed {scenario.seed}\n{place}"
    section_over_time(edges, times, found.heights, scenario, text, limits=limits).savefig(target, dpi=DPI)
