"""Running a simulation into an archive, and going on with one."""

import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from barchan.archive.folder import CHECKPOINT, Archive, last_version, scenario_of
from barchan.archive.named_files import check_files
from barchan.archive.parent import Parent
from barchan.simulation import Simulation, StepPacer

CHUNK_SECONDS = 0.1
"""Seconds of work between two looks at the clock and at whether someone wants it to stop."""

CHECKPOINT_EVERY = 60.0
"""Seconds from one checkpoint to the next where frames are further apart."""


@dataclass(frozen=True)
class Outcome:
    """How a run ended."""

    path: Path
    simulation: Simulation
    reason: str
    interrupted: bool
    work_per_second: float
    """Units of work (polls, grain updates: ``Model.work_unit``) per second, without first steps (which may
    compile) and without saving."""

    def __repr__(self) -> str:
        rate = (
            f", {self.work_per_second:.3g} {self.simulation.model.work_unit}/s"
            if self.work_per_second
            else ""
        )
        return f"<Outcome in {self.path}: step {self.simulation.steps_done}, {self.reason}{rate}>"


Progress = Callable[[Simulation], None]


def run(
    simulation: Simulation,
    path: str | Path,
    *,
    overwrite: bool = False,
    progress: Progress | None = None,
    stop: Callable[[], bool] = lambda: False,
    parent: Parent | None = None,
) -> Outcome:
    """Run a simulation to its end into a new folder, which names its ``parent`` if it is a branch.

    ``progress`` is called about ten times a second; when ``stop`` says so the run is saved where it is and
    ends, to be resumed. Raises ArchiveError where the folder is not empty or cannot be written; what was
    saved stays good.
    """
    archive = Archive.create(Path(path), simulation, overwrite, parent)
    scenario = simulation.scenario
    archive.log("start", seed=scenario.seed, steps=scenario.run.steps, version=_version())
    return _drive(simulation, archive, progress, stop)


@dataclass(frozen=True)
class Reopened:
    """A run that was opened to go on with."""

    simulation: Simulation
    archive: Archive

    @property
    def remark(self) -> str:
        """What to know before going on: that another version of the program may give other bits."""
        return remark_on(last_version(self.archive.path))

    def go_on(self, *, progress: Progress | None = None, stop: Callable[[], bool] = lambda: False) -> Outcome:
        """Run to the end."""
        self.archive.log("resume", step=self.simulation.steps_done, version=_version())
        return _drive(self.simulation, self.archive, progress, stop)


def reopen(path: str | Path, steps: int | None = None) -> Reopened:
    """Open the run in a folder at its newest checkpoint, to go on to ``steps`` steps where stated.

    Raises ArchiveError where there is no run, or another process is writing it.
    """
    path = Path(path)
    scenario = scenario_of(path)
    check_files(path)
    archive = Archive(path)
    with archive.closed_on_failure():
        if (path / CHECKPOINT).is_file() and archive.frames is not None:
            simulation = Simulation.from_state(archive.last_state())
        else:
            simulation = Simulation(scenario)
            archive.start(simulation)
        total = scenario.run.steps if steps is None else steps
        if total != simulation.scenario.run.steps:
            simulation.extend(total)
            archive.write_scenario(simulation)
    return Reopened(simulation, archive)


def resume(
    path: str | Path,
    *,
    steps: int | None = None,
    progress: Progress | None = None,
    stop: Callable[[], bool] = lambda: False,
) -> Outcome:
    """Go on with the run in a folder from its newest checkpoint, with the same bits as if uninterrupted.

    ``steps`` is a new total of steps, to go beyond what the scenario asked for.
    """
    return reopen(path, steps).go_on(progress=progress, stop=stop)


def _drive(
    simulation: Simulation, archive: Archive, progress: Progress | None, stop: Callable[[], bool]
) -> Outcome:
    saved = time.monotonic()
    pacer = StepPacer(CHUNK_SECONDS)
    first, done, worked = True, 0, 0.0
    try:
        while True:
            if not simulation.framed and (simulation.done or simulation.next_frame == simulation.steps_done):
                archive.checkpoint(simulation)
                archive.save(simulation.frame())
                saved = time.monotonic()
            if simulation.done or stop():
                break
            before = time.monotonic()
            steps = min(pacer.steps, simulation.next_frame - simulation.steps_done)
            tally = simulation.advance(steps)
            now = time.monotonic()
            if not first:
                done += tally.polls
                worked += now - before
            first = False
            pacer.record(steps, now - before)
            if now - saved > CHECKPOINT_EVERY:
                archive.checkpoint(simulation)
                saved = now
            if progress is not None:
                progress(simulation)
        return _finish(simulation, archive, done / worked if worked else 0.0)
    finally:
        archive.close()


def remark_on(before: str) -> str:
    """What to know before going on with a run that this version of the program wrote last."""
    now = _version()
    return f"begun with Barchan {before}, now {now}: the bits may differ" if before not in ("", now) else ""


def _version() -> str:
    from barchan.version import __version__

    return __version__


def _finish(simulation: Simulation, archive: Archive, work_per_second: float) -> Outcome:
    interrupted = not simulation.done
    archive.checkpoint(simulation)
    reason = "interrupted" if interrupted else simulation.finished or "all steps done"
    archive.log("interrupted" if interrupted else "stop", step=simulation.steps_done, reason=reason)
    return Outcome(archive.path, simulation, reason, interrupted, work_per_second)
