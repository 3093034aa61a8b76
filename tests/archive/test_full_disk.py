"""A disk that fills up: a clear error, and what was saved stays good."""

import resource
import sys
from contextlib import contextmanager

import pytest

from barchan.archive import Archive, open_run, resume, run
from barchan.archive.checkpoint import read_checkpoint
from barchan.errors import ArchiveError
from barchan.simulation import Simulation
from tests.tiny import tiny

FILE_SIZES = [0, 300, 3_000, 10_000]
"""Bytes that a file may still take: less than a log line, a chunk, a checkpoint, the frames' metadata."""


@contextmanager
def files_no_larger_than(size):
    """Let the system refuse to write beyond a size, as a full disk would; no bytecode is cut off."""
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    written, sys.dont_write_bytecode = sys.dont_write_bytecode, True
    try:
        yield lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, hard))
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
        sys.dont_write_bytecode = written


def fill_up_after(folder, step, size):
    """Run until the disk is full, from a step on; the error."""
    with files_no_larger_than(size) as full:

        def progress(simulation):
            if simulation.steps_done >= step:
                full()

        with pytest.raises(ArchiveError) as caught:
            run(Simulation(tiny()), folder, progress=progress)
    return str(caught.value)


@pytest.mark.parametrize("size", FILE_SIZES)
@pytest.mark.parametrize("step", [5, 10, 20])
def test_a_full_disk_is_an_error_that_names_the_folder_and_says_what_is_safe(tmp_path, size, step):
    message = fill_up_after(tmp_path / "run", step, size)
    assert message.startswith(f"cannot write to {tmp_path / 'run'}: ")
    assert message.endswith(f"; what was saved in {tmp_path / 'run'} stays good")


@pytest.mark.parametrize("size", FILE_SIZES)
@pytest.mark.parametrize("step", [5, 10, 20])
def test_what_was_saved_before_the_disk_was_full_stays_good(
    tmp_path, whole, begins_like, same_frames, size, step
):
    fill_up_after(tmp_path / "run", step, size)
    assert read_checkpoint(tmp_path / "run" / "checkpoint.npz").step <= step + 5
    begins_like(tmp_path / "run", whole)
    resume(tmp_path / "run")
    same_frames(whole, tmp_path / "run")


@pytest.mark.parametrize("size", FILE_SIZES)
def test_a_disk_that_is_full_from_the_start_is_a_clear_error(tmp_path, size):
    with files_no_larger_than(size) as full:
        full()
        with pytest.raises(ArchiveError, match=f"cannot write to {tmp_path / 'run'}: "):
            run(Simulation(tiny()), tmp_path / "run")


def test_the_systems_words_are_passed_on(monkeypatch, tmp_path):
    def fail(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("barchan.archive.folder.write_checkpoint", fail)
    with pytest.raises(ArchiveError, match="No space left on device"):
        run(Simulation(tiny()), tmp_path / "run")


def test_resuming_on_a_full_disk_is_a_clear_error(fresh):
    with files_no_larger_than(0) as full:
        full()
        with pytest.raises(ArchiveError, match=f"cannot write to {fresh}: "):
            resume(fresh)


def test_a_run_that_could_not_begin_lets_go_of_its_folder(monkeypatch, tmp_path):
    def fail(*_):
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr("barchan.archive.folder.write_checkpoint", fail)
        with pytest.raises(ArchiveError, match="No space left"):
            run(Simulation(tiny()), tmp_path / "run")
    Archive(tmp_path / "run").close()


def test_the_folder_is_let_go_of_when_the_disk_is_full(tmp_path):
    fill_up_after(tmp_path / "run", 10, 0)
    Archive(tmp_path / "run").close()
    with open_run(tmp_path / "run") as dataset:
        assert dataset.sizes["step"] >= 2
