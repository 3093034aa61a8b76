"""Fixtures of the tests of the simulation."""

from dataclasses import asdict

import numpy as np
import pytest

from barchan.simulation import Simulation


@pytest.fixture(scope="session")
def same():
    """Assert that two simulations are in the same state, bit for bit."""

    def compare(one: Simulation, other: Simulation) -> None:
        for name, array in one.bed.arrays.items():
            np.testing.assert_array_equal(array, other.bed.arrays[name])
        assert one.steps_done == other.steps_done
        assert asdict(one.tally) == asdict(other.tally)
        assert asdict(one.ledger) == asdict(other.ledger)
        assert one.finished == other.finished
        assert one.events == other.events

    return compare
