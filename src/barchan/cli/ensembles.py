"""What sweeps and comparisons share on the command line: workers, progress, the list of failures."""

import shlex
import time
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from barchan.cli import FAILED, INTERRUPTED
from barchan.cli.terminal import LOG_EVERY, console, print_warning
from barchan.words import counted

if TYPE_CHECKING:
    from barchan.ensembles.running import EnsembleOutcome
    from barchan.ensembles.task import Ended
    from barchan.ensembles.workers import Workers

Varied = Annotated[
    list[str],
    Parameter(
        negative=(),
        help="A key and its values: KEY=1,3,5, "
        "KEY=lin(FROM,TO,NUMBER) or KEY=log(FROM,TO,NUMBER); once for each key.",
    ),
]


def workers_of(count: int | None, scheduler: str | None) -> "Workers":
    """The workers that the options ask for."""
    from barchan.ensembles.workers import dask_cluster, processes
    from barchan.errors import BarchanError

    if scheduler is None:
        return processes(count)
    if count is not None:
        raise BarchanError("--workers counts processes of this machine; a cluster has as many as it has")
    return dask_cluster(scheduler)


class MemberReporter:
    """Prints now and then how many members are at their end, and each failure at once."""

    def __init__(self, quiet: bool) -> None:
        """Nothing is done yet."""
        self.quiet, self.began, self.last, self.ran = quiet, time.monotonic(), 0.0, 0

    def __call__(self, ended: "Ended", count: int, total: int) -> None:
        """A member has ended."""
        from barchan.ensembles.reports import State

        if ended.state == State.FAILED:
            print_warning(f"member {ended.id} failed: {ended.message}")
        self.ran += ended.ran
        now = time.monotonic()
        if self.quiet or not self.ran or (now - self.last < LOG_EVERY and count < total):
            return
        self.last = now
        left = (now - self.began) / self.ran * (total - count)
        more = f", {left:.0f} s left" if count < total else f" after {now - self.began:.0f} s"
        console.print(f"{count} of {counted(total, 'run')}{more}")


def exit_code(outcome: "EnsembleOutcome", command: str, folder: Path) -> int:
    """The exit code of an ensemble, after its failures and the way to go on are printed."""
    for ended in outcome.failed:
        console.print(f"failed: {ended.id}: {ended.message}")
    if outcome.waiting:
        console.print(f"not at their end: {len(outcome.waiting)}; go on with: {command}")
    if outcome.failed:
        again = f"barchan sweep {shlex.quote(str(folder))} --only failed"
        console.print(f"failed: {len(outcome.failed)}; try again with: {again}")
        console.print(f"errors in full: {folder / 'errors'}")
        return FAILED
    return INTERRUPTED if outcome.waiting else 0
