"""``barchan resume``: go on with a run, or with a branch of it."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from barchan.cli import INTERRUPTED
from barchan.cli.options import Threads
from barchan.cli.overrides import Tokens, changes, pairs
from barchan.cli.report import print_outcome, resume_command, saved_when_broken_off
from barchan.cli.terminal import Interrupts, Reporter, console, print_note, work_announced
from barchan.errors import BarchanError

if TYPE_CHECKING:
    from barchan.archive import Outcome


def resume(
    run: Path,
    /,
    *values: Tokens,
    steps: int | None = None,
    at: int | None = None,
    out: Path | None = None,
    overwrite: Annotated[bool, Parameter(negative=())] = False,
    quiet: Annotated[bool, Parameter(name=["--quiet", "-q"], negative=())] = False,
    picture: bool = True,
    threads: Threads = None,
) -> int:
    """Go on with a run that was interrupted, or beyond its last step, or from any step into a branch.

    It goes on from the newest complete checkpoint, with the same result as if it had never stopped. With
    --out it goes on in a folder of its own, which names the run and the step that it came from; there the
    wind and live parameters of the model may change, as in --at 200 --model.hop-length 7 --wind.direction 90
    or --wind '{"kind": "steady", "direction": 90}'.

    Parameters
    ----------
    run
        The run's folder.
    steps
        Total number of steps, to go beyond that of the scenario.
    at
        Step at which a branch begins; the newest checkpoint's without it. Earlier ones are done again.
    out
        Folder for a branch.
    overwrite
        Replace the run that the branch's folder holds.
    quiet
        Print nothing but errors.
    picture
        Draw the last frame and print its measures at the end.
    threads
        Threads that share the work; all cores without it. Results do not depend on it.
    """
    from barchan.kernels.core.threads import state_threads

    if out is None and (at is not None or overwrite or values):
        raise BarchanError("--at, --overwrite and changed values are for branches; say where to with --out")
    state_threads(threads)
    with work_announced(quiet), Interrupts().watched() as stop, saved_when_broken_off(out or run):
        if out is None:
            outcome = _go_on(run, steps, quiet, stop)
        else:
            outcome = _branch(run, values, steps, at, out, overwrite, quiet, stop)
        print_outcome(outcome, quiet, picture)
    if outcome.interrupted:
        console.print(f"go on with: {resume_command(outcome.path)}")
        return INTERRUPTED
    return 0


def _go_on(run: Path, steps: int | None, quiet: bool, stop: Interrupts) -> "Outcome":
    from barchan.archive import reopen

    going = reopen(run, steps)
    if going.remark and not quiet:
        print_note(going.remark)
    with Reporter(going.simulation, quiet) as reporter:
        return going.go_on(progress=reporter, stop=stop)


def _branch(
    run: Path,
    values: tuple[str, ...],
    steps: int | None,
    at: int | None,
    out: Path,
    overwrite: bool,
    quiet: bool,
    stop: Interrupts,
) -> "Outcome":
    from barchan.archive import branch, check_room

    asked = pairs(values, resume)
    check_room(out, overwrite, "--overwrite")
    going = branch(run, at, stop=stop)
    if going.remark and not quiet:
        print_note(going.remark)
    for event in changes(asked, going.simulation.scenario_in_force):
        going.simulation.apply(event)
    if steps is not None:
        going.simulation.extend(steps)
    if not quiet:
        console.print(f"branch of {run} from step {going.parent.step} on")
    with Reporter(going.simulation, quiet) as reporter:
        return going.run(out, overwrite=overwrite, progress=reporter, stop=stop)
