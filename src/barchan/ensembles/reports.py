"""Reports of members: how each came to its end, in files beside the runs, from which all states follow."""

import hashlib
import json
import math
import os
import platform
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, field
from enum import StrEnum
from pathlib import Path
from typing import Any

from barchan.archive import open_run
from barchan.archive.folder import CHECKPOINT, SCENARIO, writer_of
from barchan.archive.reading import stopped
from barchan.fields import count_names
from barchan.replacing import replacing
from barchan.scenario import Scenario
from barchan.version import __version__

MEMBERS, REPORTS, ERRORS, STOP = "members", "reports", "errors", "stop"
"""Names in the folder of an ensemble: runs, reports of finished ones, errors, and the wish to stop."""


class State(StrEnum):
    """How far a member is."""

    WAITING = "waiting"
    RUNNING = "running"
    STOPPED = "stopped"
    FAILED = "failed"
    DONE = "done"


@dataclass(frozen=True)
class Report:
    """How a member came to its end, and its measures."""

    id: str
    reason: str
    steps: int
    seconds: float
    """Time that the last part of the run took, of whatever number of parts."""
    processor_seconds: float
    bed: str
    """SHA-256 of all layers of the last frame."""
    version: str = __version__
    host: str = field(default_factory=platform.node)
    processor: str = field(default_factory=lambda: platform.processor() or platform.machine())
    process: int = field(default_factory=os.getpid)
    units: Mapping[str, str] = field(default_factory=dict)
    titles: Mapping[str, str] = field(default_factory=dict)
    series: Mapping[str, list[float | None]] = field(default_factory=dict)
    """Values of ``step`` and of every measure at each frame; None where there is none."""
    doubtful: Mapping[str, list[int]] = field(default_factory=dict)
    """Steps at which a measure should not be quoted."""
    differs_from: str = ""
    """Digest of the bed that an earlier run of the same scenario had, where it was another."""

    def last(self, name: str) -> float:
        """The measure of the last frame; NaN where there is none."""
        values = self.series.get(name) or [None]
        return math.nan if values[-1] is None else float(values[-1])

    def is_doubtful(self, name: str) -> bool:
        """Whether the measure of the last frame should not be quoted."""
        return bool(self.series.get("step")) and self.series["step"][-1] in self.doubtful.get(name, [])


@dataclass(frozen=True)
class Failure:
    """Why a member failed."""

    id: str
    kind: str
    message: str
    host: str = field(default_factory=platform.node)
    attempts: int = 1


def member_folder(folder: Path, member: str) -> Path:
    """The folder of a member's run."""
    return folder / MEMBERS / member


def state_of(folder: Path, member: str) -> State:
    """How far a member is, by its files alone."""
    run = member_folder(folder, member)
    if (folder / REPORTS / f"{member}.json").is_file():
        return State.DONE
    if writer_of(run) is not None:
        return State.RUNNING
    if (folder / ERRORS / f"{member}.json").is_file():
        return State.FAILED
    return State.STOPPED if (run / SCENARIO).is_file() and (run / CHECKPOINT).is_file() else State.WAITING


def read_report(folder: Path, member: str) -> Report | None:
    """The report of a finished member; None where there is none that can be read."""
    data = _read(folder / REPORTS / f"{member}.json")
    return None if data is None else Report(**data)


def read_failure(folder: Path, member: str) -> Failure | None:
    """Why a member failed; None where it did not."""
    data = _read(folder / ERRORS / f"{member}.json")
    return None if data is None else Failure(**data)


def write_report(folder: Path, report: Report) -> None:
    """Write a report; the member's earlier failure is over. Raises OSError where it cannot be written."""
    _write(folder / REPORTS / f"{report.id}.json", asdict(report))
    (folder / ERRORS / f"{report.id}.json").unlink(missing_ok=True)


def write_failure(folder: Path, failure: Failure) -> None:
    """Write why a member failed; raises OSError where that cannot be written."""
    _write(folder / ERRORS / f"{failure.id}.json", asdict(failure))


def report_on(
    folder: Path,
    member: str,
    scenario: Scenario,
    seconds: float,
    processor_seconds: float,
    told: Callable[[], None] = lambda: None,
) -> Report:
    """The report on the run of a member; raises ArchiveError where it cannot be read.

    ``told`` is called after each frame that is measured; what it raises ends the work.
    """
    from barchan.analysis.time_series import measure_series

    path = member_folder(folder, member)
    with open_run(path) as run:
        measured = measure_series(run, scenario, told=told)
        last = run.isel(step=-1)
        digest = hashlib.sha256(
            b"".join(last[name].values.tobytes() for name in count_names(scenario.layers))
        )
        steps = [int(step) for step in run["step"].values]
    names = [str(name) for name in measured.data_vars]
    earlier = read_report(folder, member)
    other = earlier is not None and earlier.bed != digest.hexdigest()
    return Report(
        member,
        stopped(path) or "all steps done",
        steps[-1],
        seconds,
        processor_seconds,
        digest.hexdigest(),
        units={name: measured[name].attrs["unit"] for name in names},
        titles={name: measured[name].attrs["long_name"] for name in names},
        series={"step": [float(s) for s in steps], **{n: _finite(measured[n].values) for n in names}},
        doubtful={name: measured[name].attrs["doubtful"] for name in names},
        differs_from=earlier.bed if earlier is not None and other else "",
    )


def _finite(values: Any) -> list[float | None]:
    return [float(value) if math.isfinite(value) else None for value in values]


def _read(path: Path) -> dict[str, Any] | None:
    try:
        data = json.loads(path.read_text("utf-8"))
    except (OSError, ValueError):
        return None
    return data if isinstance(data, dict) else None


def _write(path: Path, data: Mapping[str, Any]) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    with replacing(path) as partial:
        partial.write_text(json.dumps(data, ensure_ascii=False) + "\n", "utf-8")
