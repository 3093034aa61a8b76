"""Random scenarios over the whole schema run without a crash, close the ledger and do not depend on cuts.

They run in a process of their own, so that memory that is written beside an array is a failed test and not
the end of all of them. ``BARCHAN_RANDOM_RUNS`` sets their number; ``python -m tests.random_runs`` runs more.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

NUMBER = int(os.environ.get("BARCHAN_RANDOM_RUNS", "6"))

ROOT = Path(__file__).parents[2]


def run_apart(*words):
    """Run random scenarios in another process; how many did what."""
    command = [sys.executable, "-m", "tests.random_runs", *map(str, words)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{done.stdout[-3000:]}\n{done.stderr[-3000:]}"
    return json.loads(done.stdout.splitlines()[-1])


@pytest.mark.parametrize("width", ["narrow", "any"])
def test_random_scenarios_run_as_they_should_whatever_they_are(width):
    """``narrow`` fields have one to three rows, where grains pass over more than one field in a time step."""
    outcomes = run_apart(0, NUMBER, width)
    assert outcomes.get("failed", 0) == 0
    assert outcomes["ran"] > NUMBER / 3
