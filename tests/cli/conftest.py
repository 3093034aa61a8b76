"""Calling the command line, in this process."""

import shutil
import sys
import warnings
from dataclasses import dataclass
from pathlib import Path

import pytest

from barchan.archive import run
from barchan.cli import main
from barchan.simulation import Simulation
from tests.tiny import tiny


@dataclass(frozen=True)
class Result:
    """What a command did."""

    code: int
    out: str
    err: str


@pytest.fixture
def barchan(monkeypatch, capsys):
    """Run a command as a user would; its exit code and what it printed."""

    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.delenv("FORCE_COLOR", raising=False)

    def call(*words: object) -> Result:
        capsys.readouterr()
        monkeypatch.setattr(sys, "argv", ["barchan", *map(str, words)])
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", message="Cyclopts application invoked without tokens")
            with pytest.raises(SystemExit) as ended:
                main()
        printed = capsys.readouterr()
        return Result(int(ended.value.code or 0), printed.out, printed.err)

    return call


@pytest.fixture
def here(monkeypatch, tmp_path) -> Path:
    """An empty folder, the one worked in, with the file of the tiny scenario in it."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "tiny.json").write_text(tiny().text(), "utf-8")
    return tmp_path


@pytest.fixture(scope="session")
def tiny_run(tmp_path_factory) -> Path:
    """The folder of a tiny run; not to be changed."""
    return run(Simulation(tiny()), tmp_path_factory.mktemp("tiny") / "tiny").path


@pytest.fixture
def finished(here, tiny_run) -> Path:
    """The folder of a tiny run of the test's own, in the folder worked in."""
    return shutil.copytree(tiny_run, here / "tiny")
