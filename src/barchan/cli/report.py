"""The output of a run before it starts and when it ends."""

import shlex
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from rich.text import Text

from barchan.analysis.balance import balance_now
from barchan.archive import Outcome, open_run
from barchan.cli import INTERRUPTED
from barchan.cli.terminal import console, print_note
from barchan.scenario.cost import spoken_time
from barchan.scenario.summary import field_size
from barchan.simulation import Simulation
from barchan.words import counted

if TYPE_CHECKING:
    from barchan.analysis.declared_measures import Value

PICTURE = "last.png"


def print_facts(simulation: Simulation, random_seed: bool) -> None:
    """Print the facts of a run about to start."""
    scenario = simulation.scenario
    if scenario.title:
        source = f" ({scenario.citation})" if scenario.citation else ""
        console.print(Text.assemble((scenario.title, "bold"), source))
    if scenario.look_for:
        console.print(f"look for: {scenario.look_for}")
    seed = f"seed {scenario.run.seed}" + (" (random)" if random_seed else "")
    console.print(f"{field_size(scenario)}, {counted(scenario.run.steps, 'step')}, {seed}")
    console.print(f"expected time: {spoken_time(scenario)}")
    for name, fact in {**scenario.facts(), **scenario.forecast()}.items():
        console.print(f"{name}: {fact}")
    for remark in scenario.remarks(simulation.bed.ground):
        print_note(remark)


def print_outcome(outcome: Outcome, quiet: bool, picture: bool) -> None:
    """Print the outcome of a run: its picture, its measures, its folder."""
    drawn = None
    if picture and not outcome.interrupted:
        drawn = _draw(outcome, quiet)
    if quiet:
        return
    tally, slabs = outcome.simulation.tally, outcome.simulation.bed.layers[-1].unit
    speed = outcome.work_per_second / 1e6
    pace = f" ({speed:.1f} million {outcome.simulation.model.work_unit}/s)" if speed else ""
    console.print(f"{outcome.reason} at step {outcome.simulation.steps_done}{pace}")
    if tally.left:
        console.print(f"{tally.left} {slabs} left through open edges")
    if tally.capped:
        console.print(f"{tally.capped} {slabs} never settled and were put down")
    if tally.exhausted:
        console.print(f"{counted(tally.exhausted, 'step')} ended early because no cell could erode")
    if tally.fallen:
        console.print(f"balance: {balance_now(outcome.simulation).text()}")
    console.print(f"run: {outcome.path}")
    if drawn:
        console.print(f"picture: {drawn}")


def _draw(outcome: Outcome, quiet: bool) -> str | None:
    """Draw the last frame, and print its measures unless ``quiet``: both at once."""
    from barchan.analysis.time_series import last_values
    from barchan.cli.measure_table import print_values
    from barchan.figures.maps import relief_map
    from barchan.kernels.core.threads import at_once

    scenario = outcome.simulation.scenario
    with open_run(outcome.path) as dataset:
        path = outcome.path / PICTURE
        last = dataset.isel(step=-1).load()

        def draw() -> "list[Value]":
            relief_map(last, scenario).savefig(path)
            return []

        def measure() -> "list[Value]":
            return last_values(dataset, scenario)

        *_, values = at_once([draw] if quiet else [draw, measure])
    if values:
        print_values(values, scenario.lattice.cell_size, scenario.step_seconds)
    return str(path)


def print_table(rows: list[tuple[str, str, str]], left: bool = False) -> None:
    """A small table of names, values and units; values stand to the right, or to the ``left``."""
    names = max(len(name) for name, _, _ in rows)
    values = 0 if left else max(len(value) for _, value, _ in rows)
    for name, value, unit in rows:
        console.out(f"{name:{names}}  {value:>{values}}  {'' if unit == '-' else unit}".rstrip())


def resume_command(run: Path) -> str:
    """The command that goes on with a run, to be pasted."""
    return f"barchan resume {shlex.quote(str(run))}"


@contextmanager
def saved_when_broken_off(folder: Path) -> Iterator[None]:
    """Say what is saved of a run whose work is broken off, and end the command."""
    from barchan.archive.folder import CHECKPOINT

    try:
        yield
    except KeyboardInterrupt:
        if (folder / CHECKPOINT).is_file():
            console.print("interrupted within a step; what is saved is the run up to its last checkpoint")
            console.print(f"go on with: {resume_command(folder)}")
        else:
            console.print("interrupted before the first step; nothing is saved")
        sys.exit(INTERRUPTED)
