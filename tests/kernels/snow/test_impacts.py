"""Impacts that break the bonds of loose snow, beside layers as lists in plain Python."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from barchan.kernels.snow.impacts import break_bonds
from barchan.kernels.snow.state import Pack, pack_word
from barchan.snow.conditions import Conditions, layer_tables, quantum_heights
from barchan.snow.parameters import SnowParameters
from tests.kernels.snow.plain import PlainLayers, bare, stack

pytestmark = pytest.mark.extended

NOW = 1000
LOOSE = 18
"""Epochs of 600 s in the three hours for which snow is loose."""

TABLES = layer_tables(Conditions(SnowParameters(), 10.0, -10.0), True, 0.5, 0.1)

LAYER = st.tuples(st.integers(1, 4), st.integers(0, 2 * LOOSE), st.sampled_from([100, 340, 400]))


def laid(layers, kept):
    """A cell with layers of (quanta, age, density in kg/m³), the oldest first; the same as a plain list."""
    pack, plain = bare(kept), PlainLayers(kept)
    plain.layers = [(quanta, NOW - age, 64 * density) for quanta, age, density in layers]
    words = [pack_word(quanta, epoch, density / 64) for quanta, epoch, density in plain.layers]
    pack.buried[0, : len(words) - 1] = words[:-1]
    pack.buried_count[0] = len(words) - 1
    pack.top[0] = words[-1]
    pack.quanta[0] = sum(quanta for quanta, _, _ in layers)
    pack.surface[0] = height(plain)
    return pack, plain


def height(plain):
    heights = quantum_heights(1.0)
    return sum(quanta * heights[density >> 6] for quanta, _, density in plain.layers)


def strike_plain(plain, most):
    """Quantum by quantum: take what is loose, then lay it down again with the epoch of now."""
    taken = []
    while plain.layers and len(taken) < most and NOW - plain.layers[-1][1] < LOOSE:
        taken.append(plain.take())
    for density in reversed(taken):
        plain.lay(NOW, density)


def strike(pack, mean, struck=(True,), key=7):
    break_bonds(pack, TABLES, np.array(struck), float(mean), NOW, np.uint64(key))


@settings(max_examples=150, deadline=None)
@given(layers=st.lists(LAYER, min_size=1, max_size=5), spare=st.integers(0, 2), most=st.integers(1, 12))
def test_struck_layers_are_those_of_a_plain_list(layers, spare, most):
    layers = sorted(layers, key=lambda layer: -layer[1])
    pack, plain = laid(layers, max(len(layers) - 1 + spare, 2))
    strike(pack, most)
    strike_plain(plain, most)
    assert stack(pack) == plain.layers
    assert pack.surface[0] == height(plain)
    assert pack.quanta[0] == sum(quanta for quanta, _, _ in layers)


def test_a_layer_is_parted_where_impacts_do_not_reach():
    pack, _ = laid([(5, 30, 400), (6, 4, 340)], 4)
    strike(pack, 2)
    assert stack(pack) == [(5, NOW - 30, 25600), (4, NOW - 4, 21760), (2, NOW, 21760)]


def test_bonded_snow_keeps_its_bonds_and_all_that_lies_beneath_it():
    pack, _ = laid([(3, 2, 340), (1, 18, 340), (1, 17, 340)], 4)
    strike(pack, 9)
    assert stack(pack) == [(3, NOW - 2, 21760), (1, NOW - 18, 21760), (1, NOW, 21760)]


def test_cells_that_are_not_struck_age():
    pack, _ = laid([(6, 4, 340)], 2)
    strike(pack, 2, struck=(False,))
    assert stack(pack) == [(6, NOW - 4, 21760)]


def test_part_of_a_quantum_is_a_chance():
    """Of 4000 cells with three quanta a mean of 1.25 takes one or two, 0.25 more than one: error 0.007."""
    cells = 4000
    word = pack_word(3, NOW - 1, 340.0)
    pack = Pack(
        np.zeros(cells, np.int32),
        np.full(cells, 3, np.int32),
        np.full(cells, word),
        np.zeros((cells, 2), np.int64),
        np.zeros(cells, np.uint8),
    )
    strike(pack, 1.25, struck=np.ones(cells, np.bool_))
    renewed = pack.top >> 40
    assert set(renewed) == {1, 2}
    assert renewed.mean() == pytest.approx(1.25, abs=0.03)
