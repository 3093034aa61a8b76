"""Reading runs, also while they are being written."""

import json
import sys
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from barchan.archive.coordinates import GRID_MAPPING
from barchan.archive.dataset import ELEVATION, with_time
from barchan.archive.folder import CHECKPOINT, FRAMES, SCENARIO, events_of, log_of, scenario_of, writer_of
from barchan.archive.frames import published
from barchan.archive.parent import Parent, parent_of
from barchan.errors import ArchiveError
from barchan.scenario import Scenario, preset_names
from barchan.scenario.migrations import current_field
from barchan.simulation import Record, in_force

if TYPE_CHECKING:
    import xarray as xr


def open_run(path: str | Path) -> "xr.Dataset":
    """The frames of a run: ``sand``, ``ground`` and ``elevation`` over (step, y, x), read when used.

    Where steps have a duration the coordinate ``time`` (s) holds the frames' times.

    Raises ArchiveError where there is no run or it has no frames yet.
    """
    import xarray as xr
    from xarray.core.indexing import LazilyIndexedArray

    from barchan.archive.elevation import LazyElevation

    path = Path(path)
    scenario = scenario_of(path)
    if not published(path / FRAMES):
        raise ArchiveError(f"{path}: no frames were saved")
    stored = xr.open_zarr(path / FRAMES, chunks=None)
    dataset = stored.rename({name: current_field(str(name)) for name in stored.data_vars})
    if dataset.sizes["step"] == 0:
        raise ArchiveError(f"{path}: no frames were saved")
    lazy = LazyElevation(dataset, scenario.layers, scenario.lattice.thickness)
    dataset.attrs["events"] = json.dumps(events_of(path))
    dataset.attrs["stopped"] = stopped(path) or "not finished"
    located = {"grid_mapping": GRID_MAPPING} if GRID_MAPPING in dataset.variables else {}
    attributes = {**ELEVATION, **located}
    dataset["elevation"] = (("step", "y", "x"), LazilyIndexedArray(lazy), attributes)
    return with_time(dataset, scenario)


def stopped(path: Path) -> str | None:
    """Why a run ended; None while it can go on."""
    ends = [entry for entry in log_of(path) if entry["event"] in ("stop", "resume", "interrupted")]
    return ends[-1].get("reason") if ends and ends[-1]["event"] == "stop" else None


@dataclass(frozen=True)
class RunInfo:
    """What there is to know about a run without reading its frames."""

    path: Path
    scenario: Scenario
    frames: int
    last_step: int
    checkpoint: int | None
    """Step of the newest checkpoint; None where there is none or it is damaged."""
    stopped: str | None
    """Why the run ended; None while it can go on."""
    bytes: int
    parent: Parent | None
    """Where it branched off, if it is a branch."""
    events: tuple[Record, ...]
    """What was changed during the run, in order."""
    writer: str | None
    """The process that is writing it now, by its number."""

    @property
    def now(self) -> Scenario:
        """The scenario with the parameters and the wind that blow after the last event."""
        return in_force(self.scenario, self.events, sys.maxsize)


def run_info(path: str | Path) -> RunInfo:
    """What there is to know about the run in a folder."""
    from barchan.archive.checkpoint import read_checkpoint

    path = Path(path)
    scenario = scenario_of(path)
    try:
        dataset = open_run(path)
        steps = dataset["step"].values
    except ArchiveError:
        steps = np.zeros(0, np.int64)
    checkpoint = None
    with suppress(ArchiveError):
        checkpoint = read_checkpoint(path / CHECKPOINT).step
    size = sum(f.stat().st_size for f in path.rglob("*") if f.is_file())
    last = int(steps[-1]) if len(steps) else 0
    return RunInfo(
        path,
        scenario,
        len(steps),
        last,
        checkpoint,
        stopped(path),
        size,
        parent_of(path),
        tuple(map(Record.from_data, events_of(path))),
        writer_of(path),
    )


def source_at(name: str | Path) -> str | Path:
    """Where the scenario of that name stands: in a run's folder, or where the name itself points.

    A folder that bears a preset's name does not hide the preset, unless it is given as a path.
    """
    run = Path(name) / SCENARIO
    return run if name not in preset_names() and run.is_file() else name
