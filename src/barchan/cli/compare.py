"""``barchan compare``: models and values side by side, with a report."""

import shlex
import sys
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from barchan.cli.ensembles import Varied
from barchan.cli.overrides import Tokens, pairs


def compare(
    scenario: str,
    /,
    *values: Tokens,
    models: str | None = None,
    vary: Varied | None = None,
    seeds: int = 3,
    first_seed: int | None = None,
    step: Annotated[list[int] | None, Parameter(negative=())] = None,
    out: Path | None = None,
    workers: int | None = None,
    scheduler: str | None = None,
    quiet: Annotated[bool, Parameter(name=["--quiet", "-q"], negative=())] = False,
) -> int:
    """Run models side by side on the same ground, wind and random numbers, and report on them.

    DIR/report.html shows maps, contours, sections, measures over time with their spread over seeds, a table
    of final measures with tests of difference, slopes, differences of surfaces, and what ran; it needs no
    other file. The data stand beside it as CSV. The same command again goes on with what is missing.

    Parameters
    ----------
    scenario
        A preset's name, a scenario file, or the folder of a run.
    models
        Names of models with commas between, as werner,momiji,bishop; the first is what others are compared
        with. Parameters that models have in common keep the scenario's values.
    seeds
        Realizations of each variant; tests of difference need two or more.
    first_seed
        Seed of the first realization; without it the scenario's own, or 1.
    step
        A saved step to draw; may be given again. The middle and the last without it.
    out
        Folder for the runs and the report; without it a folder named after the scenario.
    workers
        Processes that run members, one thread each; as many as cores without it.
    scheduler
        Address of a Dask scheduler, as tcp://host:8786, whose workers share the folder.
    quiet
        Print nothing but errors.
    """
    from barchan.archive import source_at
    from barchan.cli.ensembles import MemberReporter, exit_code, workers_of
    from barchan.cli.terminal import Interrupts, console
    from barchan.comparison.comparing import axis_of_models
    from barchan.comparison.comparing import compare as compare_plan
    from barchan.ensembles.axes import parse_axes
    from barchan.ensembles.plan import make_plan

    axes = [axis_of_models(models.split(","))] if models else []
    plan = make_plan(
        source_at(scenario),
        [*axes, *parse_axes(vary or [])],
        seeds=seeds,
        first_seed=first_seed,
        overrides=pairs(values, compare),
    )
    folder = out or Path(f"{Path(scenario).stem}-compared")
    command = shlex.join(["barchan", *sys.argv[1:]])
    hands = workers_of(workers, scheduler)
    if not quiet:
        console.print(f"{len(plan.points)} variants, {len(plan.members)} runs, {hands.name}: {folder}")
    with Interrupts().watched() as stop:
        done = compare_plan(
            plan,
            folder,
            workers=hands,
            steps=step or (),
            command=command,
            told=MemberReporter(quiet),
            stop=stop,
        )
    if done.report and not quiet:
        console.print(f"report: {done.report}")
    return exit_code(done.outcome, command, folder)
