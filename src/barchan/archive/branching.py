"""Branches: a run taken up at one of its steps, to go another way into a folder of its own."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from barchan.archive.checkpoint import read_checkpoint
from barchan.archive.folder import CHECKPOINT, events_of, last_version, scenario_of
from barchan.archive.named_files import check_files
from barchan.archive.parent import Parent
from barchan.archive.reading import open_run, run_info
from barchan.archive.running import Outcome, Progress, remark_on, run
from barchan.errors import ArchiveError
from barchan.simulation import Record, Simulation, State
from barchan.words import counted


@dataclass(frozen=True)
class Branch:
    """A run as it was at a step, to be changed and to go on elsewhere."""

    simulation: Simulation
    parent: Parent

    @property
    def remark(self) -> str:
        """What to know before going on: that another version of the program may give other bits."""
        return remark_on(last_version(self.parent.run))

    def run(
        self,
        path: str | Path,
        *,
        overwrite: bool = False,
        progress: Progress | None = None,
        stop: Callable[[], bool] = lambda: False,
    ) -> Outcome:
        """Run to the end into a new folder, which names the run and the step that it came from."""
        return run(
            self.simulation, path, overwrite=overwrite, progress=progress, stop=stop, parent=self.parent
        )


def branch(path: str | Path, at: int | None = None, *, stop: Callable[[], bool] = lambda: False) -> Branch:
    """Take up the run in a folder as it was after ``at`` steps; without it at its newest checkpoint.

    An earlier step is reached by doing the run again, events included, with the same bits. Raises
    ArchiveError where there is no run, it has not come so far, or the way there does not give its frames.
    """
    path = Path(path)
    known = run_info(path)
    check_files(path)
    done = known.last_step if known.checkpoint is None else known.checkpoint
    at = done if at is None else at
    if not 0 <= at <= done:
        raise ArchiveError(f"{path} has done {counted(done, 'step')}; a branch cannot begin at step {at}")
    if known.checkpoint == at:
        state = read_checkpoint(path / CHECKPOINT)
        simulation = Simulation.from_state(State({**state.data, "framed": -1}, state.arrays))
    else:
        simulation = _done_again(path, at, stop)
    return Branch(simulation, Parent(path.resolve(), at))


def _done_again(path: Path, at: int, stop: Callable[[], bool]) -> Simulation:
    """The run done again up to a step."""
    simulation = Simulation(scenario_of(path))
    happened = [record for record in map(Record.from_data, events_of(path)) if record.step <= at]
    for step in sorted({*(record.step for record in happened), *range(0, at, _stride(simulation)), at}):
        simulation.advance(step - simulation.steps_done)
        for record in happened:
            if record.step == step:
                simulation.apply(record.event)
        if stop() and step < at:
            raise ArchiveError(f"interrupted at step {step} on the way to step {at}; nothing was written")
    _check(path, simulation)
    return simulation


def _stride(simulation: Simulation) -> int:
    """Steps from one look at whether to stop to the next."""
    return min(simulation.scenario.run.save_every, 1 + 10_000_000 // simulation.lattice.cells)


def _check(path: Path, simulation: Simulation) -> None:
    """The bed must be that of the run's frame, where there is one."""
    with open_run(path) as dataset:
        known = dataset["step"].values == simulation.steps_done
        at = known.argmax()
        bed = simulation.bed
        same = not known.any() or all(
            np.array_equal(dataset[layer.name][at].values, bed.arrays[layer.name]) for layer in bed.layers
        )
    if not same:
        raise ArchiveError(
            f"{path}: done again, step {simulation.steps_done} is not that of its frame; it was made by "
            f"another version of the program ({last_version(path)}) or begun from a state of its own"
        )
