"""``barchan resume``: going on, after an interruption or beyond the end."""

import shlex
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from barchan.archive import Archive, open_run, resume, run, run_info
from barchan.archive.checkpoint import read_checkpoint
from barchan.archive.folder import CHECKPOINT, log_of
from barchan.entry import load
from barchan.simulation import Simulation
from tests.tiny import tiny

BARCHAN = [sys.executable, "-c", "from barchan.cli import main; main()"]

LONG = tiny(lattice__rows=96, lattice__columns=128, run__steps=3000, run__save_every=1500)


@pytest.fixture(scope="module")
def long_run(tmp_path_factory):
    """The folder of a run of a second or two that nothing interrupted."""
    return run(Simulation(LONG), tmp_path_factory.mktemp("long") / "run").path


def interrupt(number):
    """Begin the long run, send it a signal when it has saved something; what it did."""
    process = subprocess.Popen(
        [*BARCHAN, "run", "long.json", "--out", "my run"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    while not any(entry["event"] == "frame" for entry in log_of(Path("my run"))):
        assert process.poll() is None
        time.sleep(0.002)
    process.send_signal(number)
    out, err = process.communicate()
    return process.returncode, out, err


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_run_that_is_interrupted_is_saved_and_tells_how_to_go_on(here, long_run, number):
    (here / "long.json").write_text(LONG.text())
    code, out, err = interrupt(number)
    assert code == 130
    assert err == ""
    known = run_info("my run")
    assert known.checkpoint < 3000
    assert known.stopped is None
    assert f"interrupted at step {known.checkpoint}" in out
    assert out.splitlines()[-1].startswith("go on with: barchan resume ")
    resume("my run")
    with open_run("my run") as one, open_run(long_run) as other:
        assert one.identical(other)


def test_the_command_that_goes_on_can_be_pasted(here, barchan, monkeypatch):
    monkeypatch.setattr("barchan.cli.terminal.Interrupts.__call__", lambda _: True)
    out = barchan("run", "tiny.json", "--out", "my run", "--no-picture").out
    command = out.splitlines()[-1].removeprefix("go on with: ")
    assert shlex.split(command) == ["barchan", "resume", "my run"]


def test_an_interrupted_run_draws_no_picture(here, barchan, monkeypatch):
    monkeypatch.setattr("barchan.cli.terminal.Interrupts.__call__", lambda _: True)
    result = barchan("run", "tiny.json")
    assert result.code == 130
    assert "interrupted at step 0" in result.out
    assert result.out.endswith("go on with: barchan resume tiny\n")
    assert not (here / "tiny" / "last.png").exists()


def test_the_printed_command_finishes_the_run(here, barchan, monkeypatch):
    with monkeypatch.context() as patch:
        patch.setattr("barchan.cli.terminal.Interrupts.__call__", lambda _: True)
        barchan("run", "tiny.json")
    result = barchan("resume", "tiny")
    assert result.code == 0
    assert "all steps done at step 20" in result.out
    assert (here / "tiny" / "last.png").exists()
    run(Simulation(tiny()), here / "whole")
    with open_run("tiny") as one, open_run("whole") as other:
        assert one.identical(other)


def test_a_run_goes_on_beyond_its_end(finished, barchan):
    result = barchan("resume", finished, "--steps", 30, "--no-picture")
    assert result.code == 0
    assert "all steps done at step 30" in result.out
    assert load(finished).run.steps == 30
    assert run_info(finished).frames == 7


@pytest.mark.parametrize("steps", [-5, 7])
def test_a_run_cannot_be_made_shorter(finished, barchan, steps):
    result = barchan("resume", finished, f"--steps={steps}")
    assert result.code == 1
    assert "20 steps are done already" in result.err
    assert load(finished).run.steps == 20


def test_a_run_that_another_process_writes_is_refused(finished, barchan):
    archive = Archive(finished)
    result = barchan("resume", finished)
    archive.close()
    assert result.code == 1
    assert "is being written by process" in result.err


def test_a_quiet_resume_prints_nothing(finished, barchan):
    result = barchan("resume", finished, "--steps", 25, "--quiet")
    assert (result.code, result.out, result.err) == (0, "", "")


def test_going_on_with_another_version_is_remarked_on(finished, barchan, monkeypatch):
    monkeypatch.setattr("barchan.archive.running._version", lambda: "99.0")
    assert "now 99.0: the bits may differ" in barchan("resume", finished, "--steps", 25, "--no-picture").out


def test_a_branch_goes_on_elsewhere_with_another_wind_and_other_parameters(finished, barchan):
    result = barchan(
        *("resume", finished, "--at", 10, "--out", "branch", "--no-picture"),
        *("--model.hop-length", 2, "--wind.direction", 200, "--wind.speed=3"),
    )
    assert result.code == 0
    assert f"branch of {finished} from step 10 on" in result.out
    going = Simulation.from_state(read_checkpoint(Path("branch") / CHECKPOINT))
    assert going.steps_done == 20
    assert [record.step for record in going.events] == [10, 10]
    assert going.model.parameters.hop_length == 2.0
    assert (going.wind.direction, going.wind.speed) == (200.0, 3.0)
    (row,) = (line for line in barchan("info", "branch").out.splitlines() if line.startswith("branch of"))
    assert row.split(None, 2)[2] == "tiny, from step 10 on"
    assert run_info(finished).frames == 5


def test_whole_groups_of_wind_and_model_act_in_a_branch(finished, barchan):
    wind = '{"kind": "regimes", "regimes": [{"direction": 90, "steps": 5}, {"direction": 180, "steps": 5}]}'
    model = '{"name": "werner", "hop_length": 2, "static_repose_angle": null}'
    words = ("--at", 10, "--out", "branch", "--no-picture", "--wind", wind, "--model", model)
    assert barchan("resume", finished, *words).code == 0
    now = run_info("branch").now
    assert [regime.direction for regime in now.wind.regimes] == [90.0, 180.0]
    assert (now.model.hop_length, now.model.static_repose_angle) == (2.0, None)


def test_another_kind_of_wind_takes_nothing_of_the_old_one(finished, barchan):
    words = ("--wind.kind", "regimes", "--wind.regimes", '[{"direction": 90, "steps": 5}]')
    assert barchan("resume", finished, "--at", 10, "--out", "branch", "--no-picture", *words).code == 0
    assert run_info("branch").now.wind.kind == "regimes"


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--at", "10"], "say where to with --out"),
        (["--model.hop-length", "2"], "say where to with --out"),
        (["--out", "branch", "--run.seed", "2"], "run.seed: cannot change during a run"),
        (["--out", "branch", "--model.hop-lenth", "2"], "did you mean 'model.hop_length'?"),
        (["--out", "branch", "--wind.direction", "400"], "wind.direction: is 400"),
        (["--out", "branch", "--at", "30"], "has done 20 steps"),
        (["--at", "10", "--wind", '{"direction": 90}'], "say where to with --out"),
        (["--out", "branch", "--wind", "3"], "wind: is 3; allowed: a group"),
        (["--out", "branch", "--model", "momiji"], "model.name: cannot change during a run"),
        (["--out", "branch", "--model", '{"name": "momiji"}'], "model.name: cannot change during a run"),
        (["--out", "branch", "--model", '{"band_rows": 5}'], "model.band_rows: cannot change during a run"),
        (["--out", "branch", "--wind", '{"kind": "regimes"}'], "regimes: is missing"),
        (["--out", "branch", "--lattice", '{"rows": 5}'], "lattice: cannot change during a run"),
        (["--out", "branch", "--step", "30"], "did you mean '--steps'?"),
        (["--out", "tiny"], "is not empty"),
    ],
)
def test_what_is_wrong_with_a_branch_is_told_before_anything_is_written(finished, barchan, words, said):
    result = barchan("resume", finished, *words)
    assert result.code == 1
    assert said in result.err
    assert not Path("branch").exists()
