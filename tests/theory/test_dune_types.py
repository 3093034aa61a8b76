"""The rule of thumb for dune types."""

import pytest

from barchan.theory.dune_types import dune_type


@pytest.mark.parametrize(
    ("steadiness", "supply", "said"),
    [
        (0.95, 1.0, "barchans"),
        (0.95, 20.0, "transverse dunes"),
        (0.45, 1.0, "isolated linear dunes"),
        (0.19, 20.0, "star dunes and networks"),
        (0.19, 1.0, "isolated domes"),
        (0.95, None, "barchans where sand is scarce, transverse dunes where it is plentiful"),
        (float("nan"), 3.0, "none: nothing moves"),
    ],
)
def test_wind_and_supply_name_the_dunes(steadiness, supply, said):
    assert dune_type(steadiness, supply) == said
