"""The folder of a run, and who may write to it."""

import json
import shutil
from collections.abc import Iterator
from contextlib import closing, contextmanager, suppress
from datetime import UTC, datetime
from io import FileIO
from pathlib import Path
from typing import Any

from barchan.archive.checkpoint import read_checkpoint, write_checkpoint
from barchan.archive.frames import Frames, published
from barchan.archive.named_files import FILES, INDEX, NamedFiles
from barchan.archive.parent import PARENT, Parent
from barchan.errors import ArchiveError
from barchan.holding import HeldError, hold, holder_of
from barchan.scenario import Scenario
from barchan.scenario.definition import text_of
from barchan.scenario.paths import anchored
from barchan.simulation import Frame, Simulation, State

SCENARIO, FRAMES, CHECKPOINT = "scenario.json", "frames.zarr", "checkpoint.npz"
EVENTS, LOG, LOCK, BOOKMARKS = "events.jsonl", "log.jsonl", "writer.lock", "bookmarks.json"
OWN = (BOOKMARKS, SCENARIO, FRAMES, CHECKPOINT, "checkpoint.partial", EVENTS, LOG, LOCK, PARENT, FILES, INDEX)
"""All that an archive writes into its folder."""
FIRST = {LOCK, f"{SCENARIO}.partial"}
"""What a run that was killed before it had a scenario may leave."""


@contextmanager
def writing(path: Path) -> Iterator[None]:
    """Turn what the system says while writing into one clear error."""
    try:
        yield
    except OSError as error:
        safe = f"; what was saved in {path} stays good" if (path / CHECKPOINT).exists() else ""
        raise ArchiveError(f"cannot write to {path}: {error.strerror or error}{safe}") from error


class Archive:
    """A run's folder, open for writing by this process alone."""

    def __init__(self, path: Path) -> None:
        """Open the folder of an existing run for writing."""
        self.path = path
        self._lock = _lock(path / LOCK)
        self._events = 0
        self._files = NamedFiles(path)
        self.frames: Frames | None = None
        with self.closed_on_failure(), writing(path):
            _end_last_line(path / LOG)
            if published(path / FRAMES):
                self.frames = Frames(path / FRAMES)

    @classmethod
    def create(
        cls, path: Path, simulation: Simulation, overwrite: bool = False, parent: Parent | None = None
    ) -> "Archive":
        """Make the folder of a new run; one that is not empty is refused unless asked.

        A branch names its ``parent``, by its way from the folder.
        """
        with writing(path):
            check_room(path, overwrite)
            if path.is_dir() and any(path.iterdir()):
                _remove_run(path)
            path.mkdir(parents=True, exist_ok=True)
            archive = cls(path)
            with archive.closed_on_failure():
                archive.write_scenario(simulation)
                if parent is not None:
                    _write(path / PARENT, parent.text(path))
                (path / EVENTS).touch()
                archive.start(simulation)
        return archive

    def write_scenario(self, simulation: Simulation) -> None:
        """Write the scenario as it is now."""
        with writing(self.path):
            text = self._text(simulation)
            _write(self.path / SCENARIO, text)
            if self.frames is not None:
                self.frames.describe(simulation.scenario, text)

    def _text(self, simulation: Simulation) -> str:
        """The scenario's text, in which files are named by their places in the folder."""
        return text_of(self._files.kept(simulation.scenario.data()))

    def start(self, simulation: Simulation) -> None:
        """Make an empty store of frames and the first checkpoint."""
        with writing(self.path):
            text, declared = self._text(simulation), simulation.bed.declared
            self.frames = Frames.create(self.path / FRAMES, simulation.scenario, text, declared)
            self.checkpoint(simulation)

    def save(self, frame: Frame) -> None:
        """Add a frame."""
        assert self.frames is not None
        with writing(self.path):
            self.frames.append(frame)
        self.log("frame", step=frame.step)

    def checkpoint(self, simulation: Simulation) -> None:
        """Replace the checkpoint by the simulation's state, and write new events."""
        with writing(self.path):
            state = simulation.state()
            state = State(self._files.kept(state.data), state.arrays)
            write_checkpoint(self.path / CHECKPOINT, state)
            self._write_events(state)

    def _write_events(self, state: State) -> None:
        events = state.data["events"]
        if len(events) != self._events or not events:
            _write(self.path / EVENTS, "".join(json.dumps(event) + "\n" for event in events))
            self._events = len(events)

    def log(self, event: str, **details: Any) -> None:
        """Add a line to the log."""
        entry = {"time": datetime.now(UTC).isoformat(timespec="seconds"), "event": event, **details}
        with writing(self.path), (self.path / LOG).open("a", encoding="utf-8") as file:
            file.write(json.dumps(entry) + "\n")

    def last_state(self) -> State:
        """The newest complete checkpoint, with the frames newer than it dropped."""
        state = read_checkpoint(self.path / CHECKPOINT)
        if self.frames is None:
            raise ArchiveError(f"{self.path}: no frames; run the scenario again")
        with writing(self.path):
            steps = self.frames.steps
            kept = int((steps <= state.step).sum())
            if kept < len(steps):
                self.frames.keep(kept)
        framed = int(steps[kept - 1]) if kept else -1
        return State({**state.data, "framed": framed}, state.arrays)

    def close(self) -> None:
        """Let others write."""
        with closing(self._lock), suppress(OSError):
            (self.path / LOCK).unlink()

    @contextmanager
    def closed_on_failure(self) -> Iterator[None]:
        """Let others write if what is tried here fails."""
        try:
            yield
        except BaseException:
            self.close()
            raise


def scenario_of(path: Path) -> Scenario:
    """The scenario of the run in a folder."""
    from barchan.scenario import load_scenario

    if not (path / SCENARIO).is_file():
        raise ArchiveError(f"{path}: not a run (it has no {SCENARIO})")
    return load_scenario(path / SCENARIO)


def last_version(path: Path) -> str:
    """The version of the program that wrote last to the run in a folder."""
    return str(next((e["version"] for e in reversed(log_of(path)) if "version" in e), ""))


def log_of(path: Path) -> list[dict[str, Any]]:
    """The log's entries; a line that was cut short is passed over."""
    return _entries(path / LOG)


def events_of(path: Path) -> list[dict[str, Any]]:
    """What was changed during the run in a folder, as plain data."""
    entries: list[dict[str, Any]] = anchored(_entries(path / EVENTS), path.absolute())
    return entries


def _entries(path: Path) -> list[dict[str, Any]]:
    entries = []
    if path.is_file():
        for line in path.read_text("utf-8").splitlines():
            with suppress(json.JSONDecodeError):
                entries.append(json.loads(line))
    return entries


def check_room(path: Path, overwrite: bool, how: str = "overwrite=True") -> None:
    """Raise ArchiveError unless a new run may be written to ``path``; ``how`` is how one asks for it."""
    with writing(path):
        if path.exists() and not path.is_dir():
            raise ArchiveError(f"{path} is a file, not a folder")
        names = {entry.name for entry in path.iterdir()} if path.is_dir() else set()
    if not names:
        return
    if not overwrite:
        raise ArchiveError(f"{path} is not empty; choose another folder, or add {how} to replace it")
    if SCENARIO not in names and not names <= FIRST:
        raise ArchiveError(f"{path} is not empty and holds no run; it is not overwritten")


def _remove_run(path: Path) -> None:
    """Delete what a run wrote, and nothing else."""
    with closing(_lock(path / LOCK)):
        for name in OWN:
            if (path / name).is_dir():
                shutil.rmtree(path / name)
            else:
                (path / name).unlink(missing_ok=True)


def _write(path: Path, text: str) -> None:
    partial = path.with_name(path.name + ".partial")
    partial.write_text(text, "utf-8")
    partial.replace(path)


def _end_last_line(path: Path) -> None:
    """A log that a kill cut short in mid-line goes on in a new one."""
    if path.is_file() and path.stat().st_size and not path.read_bytes().endswith(b"\n"):
        with path.open("ab") as file:
            file.write(b"\n")


def _lock(path: Path) -> FileIO:
    """Hold the folder for this process; raises ArchiveError where another one does."""
    with writing(path.parent):
        try:
            return hold(path)
        except HeldError as error:
            raise ArchiveError(f"{path.parent} is being written by process {error.owner}") from None


def writer_of(path: Path) -> str | None:
    """The process that is writing the run in a folder, by its number; None where none does."""
    return holder_of(path / LOCK)
