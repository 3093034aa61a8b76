"""The task of a worker: bring one member to its end. Doing it twice does no more than doing it once."""

import time
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from barchan.ensembles.plan import PLAN
from barchan.ensembles.reports import (
    ERRORS,
    STOP,
    Failure,
    State,
    member_folder,
    read_report,
    report_on,
    write_failure,
    write_report,
)
from barchan.errors import ArchiveError, BarchanError, ScenarioError

if TYPE_CHECKING:
    from barchan.scenario import Scenario


@dataclass(frozen=True)
class Ended:
    """How a task ended: a few words and numbers, for they travel between machines."""

    id: str
    state: State
    ran: bool
    """Whether steps were done; False where the member was finished before."""
    seconds: float = 0.0
    message: str = ""
    again: bool = False
    """Whether trying again can help."""


def bring_to_end(folder: str, member: str, text: str) -> Ended:
    """Run a member with the scenario ``text`` in the folder of its ensemble, or go on with it, to its end.

    Works on one thread. Errors are written to the member's file and told, not raised.
    """
    from barchan.kernels.core.threads import asked_for

    home = Path(folder)
    began = time.monotonic()
    try:
        if not (home / PLAN).is_file():
            raise BarchanError(
                f"{folder}: a worker on another machine does not find {PLAN} there; allowed: a folder that "
                "all workers share"
            )
        with asked_for(1):
            return _bring_to_end(home, member, text)
    except Exception as error:
        again = can_help(error)
        message = str(error) or repr(error)
        _note(home, Failure(member, type(error).__name__, message))
        return Ended(member, State.FAILED, True, time.monotonic() - began, message, again)


def can_help(error: BaseException) -> bool:
    """Whether trying again can help: where the system failed, not where the scenario is at fault."""
    if isinstance(error, ScenarioError):
        return False
    return isinstance(error, OSError) or isinstance(error.__cause__, OSError)


def _note(home: Path, failure: Failure) -> None:
    try:
        write_failure(home, failure)
    except OSError:
        return


def _bring_to_end(home: Path, member: str, text: str) -> Ended:
    import json

    from barchan.archive.folder import writer_of
    from barchan.archive.reading import stopped
    from barchan.scenario import load_scenario

    run = member_folder(home, member)
    if read_report(home, member) is not None and run.is_dir():
        return Ended(member, State.DONE, False)
    if writer_of(run) is not None:
        return Ended(member, State.RUNNING, False, message=f"process {writer_of(run)} is at it")
    (home / ERRORS / f"{member}.json").unlink(missing_ok=True)
    scenario = load_scenario(json.loads(text))
    began, processor = time.monotonic(), time.process_time()
    ran = stopped(run) is None
    if ran and not _advance(home, run, scenario):
        return Ended(member, State.STOPPED, True, time.monotonic() - began)
    seconds, used = time.monotonic() - began, time.process_time() - processor
    write_report(home, report_on(home, member, scenario, seconds, used))
    return Ended(member, State.DONE, ran, seconds)


def _advance(home: Path, run: Path, scenario: "Scenario") -> bool:
    """Go on from the newest checkpoint, or begin; whether the run came to its end."""
    from barchan.archive import reopen
    from barchan.archive import run as run_into
    from barchan.archive.checkpoint import read_checkpoint
    from barchan.archive.folder import CHECKPOINT, SCENARIO
    from barchan.simulation import Simulation

    def stop() -> bool:
        return (home / STOP).exists()

    if stop():
        return False
    if (run / SCENARIO).is_file() and (run / CHECKPOINT).is_file():
        try:
            read_checkpoint(run / CHECKPOINT)
        except ArchiveError:
            pass  # damaged: the same bits come of beginning again
        else:
            return not reopen(run).go_on(stop=stop).interrupted
    run.parent.mkdir(parents=True, exist_ok=True)
    return not run_into(Simulation(scenario), run, overwrite=True, stop=stop).interrupted


def compile_kernels(text: str) -> None:
    """Do one step of a scenario and forget it, so that its kernels are compiled and cached."""
    import json

    from barchan.kernels.core.threads import asked_for
    from barchan.scenario import load_scenario
    from barchan.simulation import Simulation

    with asked_for(1):
        Simulation(load_scenario(json.loads(text))).advance(1)
