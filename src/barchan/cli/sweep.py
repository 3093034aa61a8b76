"""``barchan sweep``: many runs of one scenario with some of its values varied."""

import shlex
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter

from barchan.cli.ensembles import Varied
from barchan.cli.overrides import Tokens, pairs
from barchan.errors import BarchanError
from barchan.words import counted

if TYPE_CHECKING:
    from barchan.ensembles.plan import Plan
    from barchan.scenario.overrides import Override

Only = Literal["failed", "waiting", "stopped"]


def sweep(
    scenario: str,
    /,
    *values: Tokens,
    vary: Varied | None = None,
    design: Literal["grid", "zip", "latin", "sobol"] = "grid",
    points: int | None = None,
    seeds: int = 1,
    first_seed: int | None = None,
    pairing: Literal["common", "independent"] = "common",
    out: Path | None = None,
    workers: int | None = None,
    scheduler: str | None = None,
    only: Only | None = None,
    measure: Annotated[list[str] | None, Parameter(negative=())] = None,
    quiet: Annotated[bool, Parameter(name=["--quiet", "-q"], negative=())] = False,
) -> int:
    """Run a scenario many times with values varied, on all cores or a cluster; go on with such a sweep.

    Each member is an ordinary run in DIR/members. The same command again, or barchan sweep DIR, goes on with
    what is missing: after Ctrl-C, a kill, a full disk. Results: measures.csv, small-multiples.png, a diagram
    for each --measure, and open_ensemble(DIR) in Python.

    Parameters
    ----------
    scenario
        A preset's name, a scenario file, or the folder of a sweep to go on with.
    design
        Which combinations: all (grid), the first values together, then the second (zip), or --points spread
        evenly over the intervals KEY=lin(FROM,TO) and KEY=log(FROM,TO) (latin, sobol).
    points
        Number of points of the designs latin and sobol.
    seeds
        Realizations of each point, with seeds that follow one another.
    first_seed
        Seed of the first realization; without it the scenario's own, or 1.
    pairing
        The same seeds at every point (common), or none twice (independent).
    out
        Folder for the sweep; without it a folder named after the scenario.
    workers
        Processes that run members, one thread each; as many as cores without it.
    scheduler
        Address of a Dask scheduler, as tcp://host:8786, whose workers share the folder.
    only
        Run only members that failed, that wait, or that were stopped.
    measure
        A measure to draw over the varied keys, one or two; may be given again.
    quiet
        Print nothing but errors.
    """
    from barchan.cli.ensembles import MemberReporter, exit_code, workers_of
    from barchan.cli.terminal import Interrupts, console
    from barchan.ensembles.plan import PLAN
    from barchan.ensembles.reports import State
    from barchan.ensembles.running import run_ensemble

    if (Path(scenario) / PLAN).is_file():
        folder, plan = Path(scenario), _plan_in(scenario, stated=bool(vary or values or out))
    else:
        folder = out or Path(f"{Path(scenario).stem}-sweep")
        numbers = {"count": points, "seeds": seeds, "first_seed": first_seed}
        plan = _new_plan(
            scenario, vary or [], pairs(values, sweep), design=design, pairing=pairing, **numbers
        )
    _check_measures(plan, measure or [])
    hands = workers_of(workers, scheduler)
    if not quiet:
        size = f"{counted(len(plan.points), 'point')}, {counted(len(plan.members), 'run')}"
        console.print(f"{size}, {hands.name}: {folder}")
    states = tuple(State) if only is None else (State(only),)
    with Interrupts().watched() as stop:
        outcome = run_ensemble(plan, folder, hands, only=states, told=MemberReporter(quiet), stop=stop)
    for path in _results(folder, plan, measure or []):
        if not quiet:
            console.print(str(path))
    return exit_code(outcome, f"barchan sweep {shlex.quote(str(folder))}", folder)


def _plan_in(folder: str, stated: bool) -> "Plan":
    """The plan of a sweep to go on with; raises BarchanError where another one is ``stated``."""
    from barchan.ensembles.plan import load_plan

    if stated:
        raise BarchanError(
            f"{folder} holds a sweep, which goes on as it is; leave out --vary, --out and values"
        )
    return load_plan(folder)


def _new_plan(scenario: str, vary: list[str], overrides: "list[Override]", **design: Any) -> "Plan":
    """The plan of a new sweep of a scenario; ``design`` as in ``make_plan``."""
    from barchan.archive import source_at
    from barchan.ensembles.plan import make_varied_plan

    return make_varied_plan(source_at(scenario), vary, overrides=overrides, **design)


def _check_measures(plan: "Plan", measures: list[str]) -> None:
    """Raise BarchanError for measures that no member has, before anything runs."""
    from barchan.analysis.declared_measures import measures_of
    from barchan.scenario import load_scenario, nearest

    if not measures:
        return
    known = {m.name for member in plan.members[:1] for m in measures_of(load_scenario(member.scenario))}
    for name in measures:
        if name not in known:
            raise BarchanError(f"--measure {name}: allowed: {', '.join(sorted(known))}{nearest(name, known)}")
    if not 1 <= len(plan.axes) <= 2:
        raise BarchanError(f"--measure: drawn over 1 or 2 varied keys; this sweep has {len(plan.axes)}")


def _results(folder: Path, plan: "Plan", measures: list[str]) -> list[Path]:
    """Write tables and pictures of what is finished; the files written."""
    from barchan.ensembles.pictures import draw_measures, draw_small_multiples
    from barchan.ensembles.reports import State, state_of
    from barchan.ensembles.table import write_tables

    written = write_tables(folder)
    if any(state_of(folder, member.id) == State.DONE for member in plan.members):
        written += draw_small_multiples(folder, plan)
        written += draw_measures(folder, plan, measures)
    return written
