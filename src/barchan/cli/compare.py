"""``barchan compare``: models and values side by side, with a report."""

import shlex
import sys
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from barchan.cli.ensembles import Varied
from barchan.cli.overrides import Tokens, pairs
from barchan.errors import BarchanError
from barchan.words import counted

if TYPE_CHECKING:
    from barchan.comparison.comparing import Comparison
    from barchan.scenario.overrides import Override


def compare(
    scenario: str | None = None,
    /,
    *values: Tokens,
    models: str | None = None,
    preset_set: str | None = None,
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

    With --preset-set the set-ups of a publication run instead, beside the numbers that it reports.

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
    preset_set
        Published results to set up again, instead of a scenario: thesis, all tables and figures of chapter 6
        of the Prague thesis.
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
    from barchan.cli.ensembles import MemberReporter, exit_code, workers_of
    from barchan.cli.terminal import Interrupts, console

    hands = workers_of(workers, scheduler)
    command = shlex.join(["barchan", *sys.argv[1:]])
    if preset_set is not None:
        _refuse_beside_set(scenario=scenario, models=models, vary=vary, step=step, values=values)
        task = _reproduction(preset_set, seeds, first_seed or 1)
    else:
        task = _comparison(scenario, models, vary, seeds, first_seed, step, pairs(values, compare))
    folder = out or Path(task.folder)
    if not quiet:
        console.print(f"{task.size}, {hands.name}: {folder}")
    with Interrupts().watched() as stop:
        done = task.run(folder, workers=hands, command=command, told=MemberReporter(quiet), stop=stop)
    if done.report and not quiet:
        console.print(f"report: {done.report}")
    return exit_code(done.outcome, command, folder)


@dataclass(frozen=True)
class _Task:
    run: "Callable[..., Comparison]"
    size: str
    folder: str
    """The name of its folder where none is stated."""


def _comparison(
    scenario: str | None,
    models: str | None,
    vary: list[str] | None,
    seeds: int,
    first_seed: int | None,
    step: list[int] | None,
    overrides: "list[Override]",
) -> _Task:
    from barchan.archive import source_at
    from barchan.comparison.comparing import axis_of_models
    from barchan.comparison.comparing import compare as compare_plan
    from barchan.ensembles.plan import make_varied_plan

    if scenario is None:
        raise BarchanError("barchan compare needs a scenario, or --preset-set thesis")
    axes = [axis_of_models(models.split(","))] if models else []
    plan = make_varied_plan(
        source_at(scenario),
        vary or [],
        axes,
        seeds=seeds,
        first_seed=first_seed,
        overrides=overrides,
    )
    run = partial(compare_plan, plan, steps=step or ())
    size = f"{counted(len(plan.points), 'variant')}, {counted(len(plan.members), 'run')}"
    return _Task(run, size, f"{Path(scenario).stem}-compared")


def _reproduction(name: str, seeds: int, first_seed: int) -> _Task:
    from barchan.comparison.published.reproducing import reproduce
    from barchan.comparison.published.results import load_set

    chosen = load_set(name)
    size = f"{len(chosen.experiments)} figures and sections, {counted(len(chosen.cases) * seeds, 'run')}"
    return _Task(partial(reproduce, chosen, seeds=seeds, first_seed=first_seed), size, name)


def _refuse_beside_set(**given: object) -> None:
    """Raise BarchanError for anything that has no meaning for a set of published results."""
    stated = [name for name, value in given.items() if value]
    if stated:
        words = ", ".join(
            "a scenario" if name == "scenario" else "changed values" if name == "values" else f"--{name}"
            for name in stated
        )
        raise BarchanError(f"--preset-set is stated with {words}; a set states its own scenarios and values")
