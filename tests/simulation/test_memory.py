"""Memory is estimated before it is taken, and more than is free is refused with the numbers."""

import subprocess
import sys

import pytest

from barchan.errors import ScenarioError
from barchan.simulation import Simulation
from barchan.simulation.memory import in_words, memory_needed
from tests.tiny import tiny

HUGE = {"lattice__rows": 65536, "lattice__columns": 65536}

MEASURE = """
import sys, tracemalloc, barchan
from barchan.simulation.memory import memory_needed
name, size = sys.argv[1], int(sys.argv[2])
def made(n):
    bump = {"kind": "bump", "height": 3.0, "radius": 8.0}
    return barchan.load({"barchan": 5, "lattice": {"rows": n, "columns": n}, "model": {"name": name},
                         "ground": bump, "run": {"steps": 1, "seed": 1}})
barchan.Simulation(made(16)).advance(1)  # compiled
scenario = made(size)
tracemalloc.start()
simulation = barchan.Simulation(scenario)
simulation.advance(1)
kept = simulation.state(), simulation.frame(), simulation.elevation
print(memory_needed(scenario) / tracemalloc.get_traced_memory()[1])
"""


OTHERS = [pytest.param(name, marks=pytest.mark.extended) for name in ("pelletier", "nield_baas", "wang_hu")]


@pytest.mark.parametrize("name", ["werner", *OTHERS])
def test_the_estimate_is_about_the_memory_that_a_run_takes(name):
    """The right value is what Python's own count of allocated memory, ``tracemalloc``, says at its peak."""
    done = subprocess.run(
        [sys.executable, "-c", MEASURE, name, "256"], capture_output=True, text=True, check=True
    )
    assert 0.8 < float(done.stdout) < 2.5


def test_the_estimate_grows_with_the_cells():
    """Four times the cells take four times the memory, whatever the model."""
    small, large = (memory_needed(tiny(lattice__rows=n, lattice__columns=n)) for n in (256, 512))
    assert large == pytest.approx(4 * small, rel=1e-3)


def test_a_field_that_does_not_fit_is_refused_before_anything_is_made(monkeypatch):
    monkeypatch.setattr("barchan.simulation.memory.memory_free", lambda: 8 * 10**9)
    with pytest.raises(ScenarioError) as error:
        Simulation(tiny(**HUGE))
    text = str(error.value)
    assert "lattice: has 65,536 × 65,536 cells" in text
    assert "8 GB are free" in text
    assert f"needs about {in_words(memory_needed(tiny(**HUGE)))}" in text


def test_sizes_are_told_in_units_that_suit_them():
    assert [in_words(n) for n in (10, 2_500, 3.2e6, 1.5e9, 4e12)] == [
        "1 kB",
        "2.5 kB",
        "3.2 MB",
        "1.5 GB",
        "4 TB",
    ]
