"""``barchan run``: run a scenario, save it, draw the last frame."""

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from barchan.cli import INTERRUPTED
from barchan.cli.options import Threads
from barchan.cli.overrides import Tokens, pairs
from barchan.cli.report import print_facts, print_outcome, resume_command, saved_when_broken_off
from barchan.cli.terminal import Interrupts, Reporter, console, work_announced


def run(
    scenario: str,
    /,
    *values: Tokens,
    out: Path | None = None,
    overwrite: Annotated[bool, Parameter(negative=())] = False,
    quiet: Annotated[bool, Parameter(name=["--quiet", "-q"], negative=())] = False,
    picture: bool = True,
    threads: Threads = None,
) -> int:
    """Run a preset or a scenario, save it, and draw the last frame.

    Ctrl-C stops the run, saves it and prints the command to go on.

    Parameters
    ----------
    scenario
        A preset's name, a scenario file, or the folder of a run to run again.
    out
        Folder for the run; without it a new folder named after the scenario.
    overwrite
        Replace the run that the folder holds.
    quiet
        Print nothing but errors.
    picture
        Draw the last frame and print its measures at the end.
    threads
        Threads that share the work; all cores without it. Results do not depend on it.
    """
    from barchan.archive import check_room, source_at
    from barchan.archive import run as run_into
    from barchan.kernels.core.threads import state_threads
    from barchan.scenario.files import load_scenario
    from barchan.simulation import Simulation

    state_threads(threads)
    chosen = load_scenario(source_at(scenario), pairs(values, run))
    folder = out or _new_folder(scenario)
    check_room(folder, overwrite, "--overwrite")
    random_seed = chosen.run.seed is None
    with work_announced(quiet), Interrupts().watched() as stop, saved_when_broken_off(folder):
        simulation = Simulation(chosen)
        if not quiet:
            print_facts(simulation, random_seed)
        with Reporter(simulation, quiet) as reporter:
            outcome = run_into(simulation, folder, overwrite=overwrite, progress=reporter, stop=stop)
        print_outcome(outcome, quiet, picture)
    if outcome.interrupted:
        console.print(f"go on with: {resume_command(folder)}")
        return INTERRUPTED
    return 0


def _new_folder(scenario: str) -> Path:
    """A folder that does not exist yet, named after the scenario."""
    name = Path(scenario).stem or "run"
    number = 1
    while True:
        folder = Path(name if number == 1 else f"{name}-{number}")
        if not folder.exists():
            return folder
        number += 1
