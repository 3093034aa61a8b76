"""``barchan info``: the contents of a run."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from barchan.simulation import Record

MOST_EVENTS = 20
"""Events that are listed one by one."""


def info(run: Path, /) -> None:
    """Print the contents of a run, its progress, and the measures of its last frame.

    Wind and parameters are those of now; what was changed on the way is listed.

    Parameters
    ----------
    run
        The run's folder.
    """
    from barchan.archive import open_run, run_info
    from barchan.cli.report import print_measures, print_table, resume_command
    from barchan.cli.terminal import console

    known = run_info(run)
    scenario = known.now
    lattice = scenario.lattice
    if known.writer:
        state = f"being written by process {known.writer}"
    else:
        state = known.stopped or f"not finished; go on with: {resume_command(run)}"
    rows = [
        ("title", scenario.title or "–"),
        ("model", scenario.model.name),
        ("field", f"{lattice.columns} × {lattice.rows} cells of {lattice.cell_size:g} m"),
        ("slab height", f"{lattice.thickness:.4g} m"),
        *scenario.facts().items(),
        ("wind", scenario.wind.summary()),
        ("seed", str(scenario.run.seed)),
        *([("branch of", f"{known.parent.run}, from step {known.parent.step} on")] if known.parent else []),
        *_changes(known.events),
        ("frames", f"{known.frames}, the last at step {known.last_step} of {scenario.run.steps}"),
        ("checkpoint", "none" if known.checkpoint is None else f"step {known.checkpoint}"),
        ("state", state),
        ("size", f"{known.bytes / 1e6:.1f} MB"),
    ]
    print_table([(name, value, "") for name, value in rows], left=True)
    if known.frames:
        console.print()
        with open_run(run) as dataset:
            print_measures(dataset, known.scenario)


def _changes(events: Sequence["Record"]) -> list[tuple[str, str]]:
    """What was changed during a run, the last of it where there is much."""
    earlier = len(events) - MOST_EVENTS
    rows = [("changed", str(event)) for event in events[-MOST_EVENTS:]]
    return [("changed", f"{earlier} times before"), *rows] if earlier > 0 else rows
