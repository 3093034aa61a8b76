"""A process killed at any moment leaves a run that can be read and resumed."""

import random
import signal
import subprocess
import sys
import time
from contextlib import closing, suppress
from pathlib import Path

import pytest

from barchan.archive import frames, open_run, reopen, resume, run, run_info
from barchan.archive.folder import log_of
from barchan.errors import ArchiveError
from barchan.simulation import Simulation
from tests.archive import killer
from tests.tiny import tiny

ROOT = Path(__file__).parents[2]

BARCHAN = [sys.executable, "-c", "from barchan.cli import main; main()"]

EARLY = ["1", "2", "3", "4", "5", "6"]
"""Moments before there is a store of frames."""

MAKING = [f"{0.05 + 0.5 * (n + random.Random(n).random()) / 4:.4f}" for n in range(4)]
"""Shares of a run, at random, in the time that making the store takes."""

LATER = [f"{0.6 + 0.4 * (n + random.Random(n).random()) / 8:.4f}" for n in range(8)]
"""Shares of a run, at random, in the time after that."""


@pytest.fixture(scope="session")
def killed(tmp_path_factory):
    """The folder of runs that were killed, each named after its moment."""
    root = tmp_path_factory.mktemp("killed")
    command = [sys.executable, "-m", "tests.archive.killer", str(root), *EARLY, *MAKING, *LATER]
    subprocess.run(command, check=True, cwd=ROOT)
    return root


@pytest.mark.parametrize("moment", EARLY + LATER)
def test_a_run_killed_at_any_moment_can_be_read_or_says_that_it_has_no_frames(killed, begins_like, moment):
    said = None
    try:
        begins_like(killed / moment, killed / "whole")
    except ArchiveError as error:
        said = str(error).removeprefix(f"{killed / moment}: ")
    assert said in (None, "not a run (it has no scenario.json)", "no frames were saved")
    if said is None:
        assert run_info(killed / moment).stopped in (None, "all steps done")


@pytest.mark.parametrize("moment", ["5", "6", *MAKING, *LATER])
def test_a_run_killed_at_any_moment_is_resumed_to_the_same_bits(killed, same_frames, moment):
    outcome = resume(killed / moment)
    assert outcome.simulation.steps_done == killer.STEPS
    same_frames(killed / "whole", killed / moment)


@pytest.mark.extended
def test_a_command_killed_again_and_again_comes_to_the_same_bits(tmp_path, same_frames):
    scenario = tiny(run__steps=60, run__save_every=2)
    (tmp_path / "tiny.json").write_text(scenario.text())
    folder = tmp_path / "killed"
    command = ["run", str(tmp_path / "tiny.json"), "--out", str(folder), "--quiet", "--no-picture"]
    chance = random.Random(4)
    for more in (3, 6, 4):
        wanted = len(frames_in_log(folder)) + more
        process = subprocess.Popen([*BARCHAN, *command])
        while len(frames_in_log(folder)) < wanted:
            assert process.poll() is None
            time.sleep(0.001)
        time.sleep(0.03 * chance.random())
        process.send_signal(signal.SIGKILL)
        assert process.wait() == -signal.SIGKILL
        open_run(folder).close()
        command = ["resume", str(folder), "--quiet", "--no-picture"]
    resume(folder)
    run(Simulation(scenario), tmp_path / "whole")
    same_frames(tmp_path / "whole", folder)


def frames_in_log(folder):
    """The steps of all frames that a log mentions."""
    return [entry["step"] for entry in log_of(folder) if entry["event"] == "frame"]


def made_as_far_as(monkeypatch, folder, arrays):
    """Leave a run that was killed while its store of frames was made, after a number of arrays."""
    made = iter(range(arrays))
    make = frames._make

    def kill(*given):
        if next(made, None) is None:
            raise KeyboardInterrupt
        return make(*given)

    with monkeypatch.context() as patch:
        patch.setattr(frames, "_make", kill)
        with suppress(KeyboardInterrupt):
            run(Simulation(tiny()), folder)


@pytest.mark.parametrize("arrays", [0, 2, 3, 9])
def test_a_run_killed_while_its_store_was_made_says_that_it_has_no_frames(monkeypatch, tmp_path, arrays):
    made_as_far_as(monkeypatch, tmp_path / "run", arrays)
    with pytest.raises(ArchiveError, match="no frames were saved"):
        open_run(tmp_path / "run")


@pytest.mark.parametrize("arrays", [0, 2, 3, 9])
def test_a_run_killed_while_its_store_was_made_is_resumed(monkeypatch, tmp_path, whole, same_frames, arrays):
    made_as_far_as(monkeypatch, tmp_path / "run", arrays)
    resume(tmp_path / "run")
    same_frames(whole, tmp_path / "run")


def test_what_a_killed_writer_left_unfinished_gives_no_warning(fresh):
    (fresh / "frames.zarr" / "zarr.0123456789abcdef.partial").write_text("{")
    with closing(reopen(fresh).archive) as archive:
        archive.frames.commit()
