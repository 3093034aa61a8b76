"""``barchan resume``: go on with a run."""

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from barchan.cli import INTERRUPTED
from barchan.cli.report import print_outcome, resume_command
from barchan.cli.terminal import Interrupts, Reporter, compilation_announced, console, print_note


def resume(
    run: Path,
    /,
    *,
    steps: int | None = None,
    quiet: Annotated[bool, Parameter(name=["--quiet", "-q"], negative=())] = False,
    picture: bool = True,
) -> int:
    """Go on with a run that was interrupted, or beyond its last step.

    It goes on from the newest complete checkpoint, with the same result as if it had never stopped.

    Parameters
    ----------
    run
        The run's folder.
    steps
        Total number of steps, to go beyond what the scenario asked for.
    quiet
        Print nothing but errors.
    picture
        Draw the last frame and print its measures at the end.
    """
    from barchan.archive import reopen

    with compilation_announced(quiet), Interrupts().watched() as stop:
        going = reopen(run, steps)
        if going.remark and not quiet:
            print_note(going.remark)
        with Reporter(going.simulation, quiet) as reporter:
            outcome = going.go_on(progress=reporter, stop=stop)
        print_outcome(outcome, quiet, picture)
    if outcome.interrupted:
        console.print(f"go on with: {resume_command(run)}")
        return INTERRUPTED
    return 0
