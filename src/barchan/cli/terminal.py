"""The output of commands, and the progress of long work."""

import re
import signal
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING, Self

from rich.console import Console
from rich.text import Text

from barchan.errors import BarchanError
from barchan.kernels.core.progress import told_of_progress
from barchan.simulation import Simulation

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from rich.progress import Progress, TaskID

console = Console(highlight=False, markup=False, soft_wrap=True)

_COUNT = re.compile(r"\d[\d,]*")
"""A count within a report of progress; the last one is that of the work left."""

_UNANNOUNCED = 2.0
"""Seconds of work that need no word."""

LOG_EVERY = 10.0
"""Seconds from one line to the next where the output is not a terminal."""


def print_note(text: str) -> None:
    """Something to know, that is no error."""
    console.print(Text.assemble(("note:", "yellow"), " ", text))


def print_warning(text: str) -> None:
    """Something that makes what follows doubtful."""
    console.print(Text.assemble(("warning:", "bold red"), " ", text))


def save_picture(figure: "Figure", path: Path, dpi: float | None = None, quiet: bool = False) -> None:
    """Write a picture, at the figure's dots per inch or ``dpi``, and print its name unless ``quiet``.

    Raises BarchanError where it cannot be written, and for a suffix that promises numbers instead.
    """
    from barchan.export.formats import DATA_SUFFIXES

    if path.suffix.lower() in DATA_SUFFIXES:
        raise BarchanError(
            f"{path}: a picture under the name of data would be taken for data; allowed: .png, .pdf, .svg; "
            f"numbers are written by: barchan export RUN {path.name}"
        )
    try:
        figure.savefig(path, dpi=figure.dpi if dpi is None else dpi)
    except (OSError, ValueError) as error:
        raise BarchanError(f"cannot write {path}: {error}") from None
    if not quiet:
        console.print(str(path))


PATIENCE = 0.7
"""Seconds from a wish to stop until work that does not notice it is broken off."""


class Interrupts:
    """Turns Ctrl-C and a polite kill into a wish to stop, so that a run can be saved first.

    Work that takes longer to notice, such as one long step, is broken off by a KeyboardInterrupt.
    """

    def __init__(self) -> None:
        """No wish yet."""
        self.wanted = False

    def __call__(self) -> bool:
        """Whether someone wants to stop; whoever asks has the time that it takes to save the run."""
        if self.wanted:
            _alarm(0.0)
        return self.wanted

    @contextmanager
    def watched(self) -> Iterator["Interrupts"]:
        """Listen for signals; a second one breaks the work off at once."""
        before = {s: signal.signal(s, self._note) for s in (signal.SIGINT, signal.SIGTERM)}
        if hasattr(signal, "SIGALRM"):
            before[signal.SIGALRM] = signal.signal(signal.SIGALRM, self._note)
        try:
            yield self
        finally:
            _alarm(0.0)
            for number, handler in before.items():
                signal.signal(number, handler)

    def _note(self, _number: int, _frame: FrameType | None) -> None:
        if self.wanted:
            raise KeyboardInterrupt
        self.wanted = True
        _alarm(PATIENCE)


def _alarm(seconds: float) -> None:
    """Let an alarm go off in some seconds, or none (0), where the system has alarms."""
    if hasattr(signal, "setitimer"):
        signal.setitimer(signal.ITIMER_REAL, seconds)


class Reporter:
    """Shows how a run goes: a bar in a terminal, plain lines elsewhere, nothing when quiet."""

    def __init__(self, simulation: Simulation, quiet: bool) -> None:
        """Report on a simulation from where it is now."""
        self.total = simulation.scenario.run.steps
        self.quiet = quiet
        self.began = 0.0
        self.last = time.monotonic()
        self.first = simulation.steps_done
        self.bar: Progress | None = None
        self.task: TaskID | None = None

    def __enter__(self) -> Self:
        """Begin to report."""
        if not self.quiet and console.is_terminal:
            from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

            self.bar = Progress(
                TextColumn("steps"),
                BarColumn(),
                MofNCompleteColumn(),
                TextColumn("{task.fields[speed]}"),
                TimeRemainingColumn(),
                TextColumn("left, {task.fields[highest]}"),
                console=console,
            )
            self.bar.start()
            self.task = self.bar.add_task("", total=self.total, completed=self.first, speed="", highest="")
        return self

    def __exit__(self, *_: object) -> None:
        """Leave the terminal as it was."""
        if self.bar is not None:
            self.bar.stop()

    def __call__(self, simulation: Simulation) -> None:
        """Report on where the simulation is."""
        now = time.monotonic()
        if not self.began:  # the first steps may have compiled kernels: the pace is counted from here
            self.began, self.first = now, simulation.steps_done
        speed = (simulation.steps_done - self.first) / max(now - self.began, 1e-9)
        if self.bar is not None and self.task is not None:
            self.bar.update(
                self.task,
                completed=simulation.steps_done,
                speed=f"{speed:.0f} steps/s",
                highest=f"highest stack {simulation.bed.stack.max()} {simulation.bed.layers[-1].unit}",
            )
        elif not self.quiet and now - self.last >= LOG_EVERY:
            self.last = now
            pace = ""
            if speed:
                left = (self.total - simulation.steps_done) / speed
                pace = f"{speed:.0f} steps/s, {left:.0f} s left, "
            console.print(
                f"step {simulation.steps_done} of {self.total}, {pace}"
                f"highest stack {simulation.bed.stack.max()} {simulation.bed.layers[-1].unit}"
            )


@contextmanager
def work_announced(quiet: bool) -> Iterator[None]:
    """Say when a kernel is compiled, and now and then how far long work is that is no step of a run."""
    last = time.monotonic() - LOG_EVERY + _UNANNOUNCED

    def tell(text: str) -> None:
        nonlocal last
        if not quiet and _work_left(text) and time.monotonic() - last >= LOG_EVERY:
            last = time.monotonic()
            console.print(text)

    with compilation_announced(quiet), told_of_progress(tell):
        yield


def _work_left(report: str) -> bool:
    """Whether any work is left by a report of progress, which counts it last; also where it counts none."""
    counts = _COUNT.findall(report)
    return not counts or int(counts[-1].replace(",", "")) > 0


@contextmanager
def compilation_announced(quiet: bool) -> Iterator[None]:
    """Say so when a kernel is compiled instead of loaded, once."""
    from barchan.kernels.core.compile_notice import told_of_compilation

    def tell(done: int) -> None:
        if not quiet and done == 0:
            console.print("compiling kernels (first run only) …")

    with told_of_compilation(tell):
        yield
