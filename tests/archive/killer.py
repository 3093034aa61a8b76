"""Runs the tiny scenario in processes that kill themselves at chosen moments.

A moment is the n-th time that a process opens a file of the run for writing, renames or removes one, or
makes or removes a folder. Called with a folder and moments, each a number or a share of all moments (with
a point in it); leaves a run killed at each of them in the subfolder named after it.
"""

import os
import signal
import sys
from pathlib import Path

import barchan.archive
from barchan.simulation import Simulation
from tests.tiny import tiny

CHANGES = {"os.rename", "os.remove", "os.mkdir", "os.rmdir"}
STEPS = 12


class Killer:
    """Counts what is done to the files of a folder, and ends the process at a moment."""

    def __init__(self, folder: Path, moment: int) -> None:
        self.folder = os.fspath(folder)
        self.moment = moment
        self.count = 0

    def __call__(self, event: str, args: tuple) -> None:
        opened = event == "open" and args[2] & (os.O_WRONLY | os.O_RDWR)
        if not opened and event not in CHANGES:
            return
        if isinstance(args[0], str | os.PathLike) and os.fspath(args[0]).startswith(self.folder):
            self.count += 1
            if self.count == self.moment:
                os.kill(os.getpid(), signal.SIGKILL)


def run_and_die(folder: Path, moment: int) -> None:
    """Run in a process that dies at a moment."""
    child = os.fork()
    if child == 0:
        sys.addaudithook(Killer(folder, moment))
        barchan.archive.run(Simulation(tiny(run__steps=STEPS)), folder)
        os._exit(0)
    os.waitpid(child, 0)


def moments_of_a_whole_run(folder: Path) -> int:
    """How many moments a run has that is not killed."""
    reader, writer = os.pipe()
    if os.fork() == 0:
        killer = Killer(folder, 0)
        sys.addaudithook(killer)
        barchan.archive.run(Simulation(tiny(run__steps=STEPS)), folder)
        os.write(writer, str(killer.count).encode())
        os._exit(0)
    os.close(writer)
    os.wait()
    return int(os.read(reader, 100))


if __name__ == "__main__":
    root = Path(sys.argv[1])
    Simulation(tiny()).advance(1)
    total = moments_of_a_whole_run(root / "whole")
    for name in sys.argv[2:]:
        run_and_die(root / name, int(float(name) * total) if "." in name else int(name))
