"""``barchan info``: the contents of a run."""

import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

from barchan.errors import BarchanError
from barchan.words import counted

if TYPE_CHECKING:
    from barchan.archive import RunInfo
    from barchan.scenario import Scenario
    from barchan.simulation import Record

MOST_EVENTS = 20
"""Events that are listed one by one."""


def info(
    run: Path,
    /,
    *,
    wind: Literal["resultant", "last"] = "resultant",
    as_json: Annotated[bool, Parameter(name="--json", negative=())] = False,
    as_csv: Annotated[bool, Parameter(name="--csv", negative=())] = False,
) -> None:
    """Print the contents of a run, its progress, and the measures of its last frame.

    Wind and parameters are those of now; what was changed on the way is listed. A measure marked with ?
    should not be quoted, for the reason that follows.

    Parameters
    ----------
    run
        The run's folder.
    wind
        The wind that windward, lee and downwind refer to: the resultant of a whole cycle of winds, or the
        last one.
    as_json
        Print contents and measures as JSON.
    as_csv
        Print the measures as CSV, a row each.
    """
    from barchan.analysis.balance import balance_of
    from barchan.analysis.forms import form
    from barchan.analysis.time_series import last_values
    from barchan.archive import open_run
    from barchan.cli import measure_table
    from barchan.cli.report import print_table
    from barchan.cli.terminal import console

    if as_json and as_csv:
        raise BarchanError("--json and --csv are both given; give one of them")
    frames, scenario, rows = _contents(run)
    values = []
    if frames:
        with open_run(run) as dataset:
            rows.append(("balance", balance_of(dataset, scenario).text()))
            values = last_values(dataset, scenario, wind)
        if (found := form(values, scenario)) is not None:
            rows.append(("forms", found))
    if as_json:
        data = {"run": str(run), "contents": dict(rows), "measures": measure_table.as_data(values)}
        console.out(json.dumps(data, indent=2, ensure_ascii=False))
    elif as_csv:
        console.out(measure_table.as_csv(values), end="")
    else:
        print_table([(name, value, "") for name, value in rows], left=True)
        if values:
            console.print()
            measure_table.print_values(values, scenario.lattice.cell_size, scenario.step_seconds)


def _contents(run: Path) -> tuple[int, "Scenario", list[tuple[str, str]]]:
    """The number of frames of a run, its scenario, and its contents to read."""
    from barchan.archive import run_info
    from barchan.cli.report import resume_command
    from barchan.scenario.summary import unit_of, wind_in_words

    known = run_info(run)
    scenario = known.now
    if known.writer:
        state = f"being written by process {known.writer}"
    else:
        state = known.stopped or f"not finished; go on with: {resume_command(run)}"
    rows = [
        ("title", scenario.title or "–"),
        ("model", scenario.model.name),
        ("field", scenario.lattice.size_in_words),
        ("unit", unit_of(scenario)),
        *scenario.facts().items(),
        *_forecast(known.scenario, changed=bool(known.events)),
        ("wind", wind_in_words(scenario)),
        ("seed", str(scenario.run.seed)),
        *([("branch of", f"{known.parent.run}, from step {known.parent.step} on")] if known.parent else []),
        *_changes(known.events),
        ("frames", _frames(known)),
        ("checkpoint", "none" if known.checkpoint is None else f"step {known.checkpoint}"),
        ("state", state),
        ("size", f"{known.bytes / 1e6:.1f} MB"),
    ]
    return known.frames, known.scenario, rows


def _forecast(scenario: "Scenario", changed: bool) -> list[tuple[str, str]]:
    """What was predicted of the run before it started; later changes are not part of it."""
    told = ", before what was changed" if changed else ""
    return [(name, f"{text}{told}") for name, text in scenario.forecast().items()]


def _changes(events: Sequence["Record"]) -> list[tuple[str, str]]:
    """What was changed during a run, the last of it where there is much."""
    earlier = len(events) - MOST_EVENTS
    rows = [("changed", str(event)) for event in events[-MOST_EVENTS:]]
    return [("changed", f"{counted(earlier, 'time')} before"), *rows] if earlier > 0 else rows


def _frames(known: "RunInfo") -> str:
    steps = known.scenario.run.steps
    return f"{known.frames}, the last at step {known.last_step} of {steps}" if known.frames else "none"
