"""Ctrl-C breaks off any work within a second, and what is half done does not go on."""

import signal
import time
from contextlib import contextmanager

import numpy as np
import pytest

from barchan.errors import BarchanError
from barchan.kernels.core.progress import told_of_progress
from barchan.simulation import Simulation
from tests.tiny import tiny

ENDLESS = {"model__p_s": 0.0, "model__p_ns": 0.0, "model__max_hops": 10**9, "model__shadow_angle": 89.0}
"""A slab over flat sand with joined edges hops a thousand million times: some seconds for each poll."""

pytestmark = pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="no alarms on this system")


@contextmanager
def interrupted_after(seconds):
    """Raise KeyboardInterrupt in this thread after some seconds, as Ctrl-C would."""
    before = signal.signal(signal.SIGALRM, signal.default_int_handler)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)


def test_one_long_step_is_broken_off_and_leaves_the_bed_as_it_was():
    Simulation(tiny(sand={"kind": "flat", "mean": 3})).advance(1)  # compiled
    simulation = Simulation(tiny(sand={"kind": "flat", "mean": 3}, **ENDLESS))
    before = simulation.bed.sand.copy()
    began = time.monotonic()
    with interrupted_after(0.3), pytest.raises(KeyboardInterrupt):
        simulation.advance(1)
    assert time.monotonic() - began < 1.5
    np.testing.assert_array_equal(simulation.bed.sand, before)


def test_a_simulation_whose_step_was_broken_off_does_not_go_on_in_silence():
    simulation = Simulation(tiny(sand={"kind": "flat", "mean": 3}, **ENDLESS))
    with interrupted_after(0.3), pytest.raises(KeyboardInterrupt):
        simulation.advance(1)
    with pytest.raises(BarchanError, match="broken off"):
        simulation.advance(1)
    with pytest.raises(BarchanError, match="broken off"):
        simulation.state()


BLOCK = {"lattice__rows": 192, "lattice__columns": 192, "sand": {"kind": "block", "height": 4000.0}}


def test_slopes_that_relax_before_the_first_step_are_broken_off_too():
    Simulation(tiny())  # compiled
    began = time.monotonic()
    with interrupted_after(0.5), pytest.raises(KeyboardInterrupt):
        Simulation(tiny(**BLOCK))
    assert time.monotonic() - began < 2.0


def test_slopes_that_relax_tell_how_far_they_are():
    told = []
    with told_of_progress(told.append):
        Simulation(tiny(sand={"kind": "block", "height": 20.0}))
    assert "slabs have slid" in told[-1]
    assert "0 cells still to be checked" in told[-1]
