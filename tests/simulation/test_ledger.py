"""The ledger closes exactly, or there is an error."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from barchan.errors import ConservationError
from barchan.simulation import Ledger

counts = st.integers(0, 10**15)


@given(counts, counts, counts, counts)
def test_what_is_there_is_what_was_and_came_and_did_not_go(initial, entered, left, airborne):
    Ledger(initial, entered, left, airborne).close(initial + entered - left - airborne)


@given(counts, counts, counts, counts, st.integers(-5, 5).filter(bool))
def test_a_single_slab_too_many_or_too_few_is_found(initial, entered, left, airborne, wrong):
    ledger = Ledger(initial, entered, left, airborne)
    with pytest.raises(ConservationError, match="the ledger does not close"):
        ledger.close(initial + entered - left - airborne + wrong)
