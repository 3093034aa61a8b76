"""Layers of a cell beside a list of layers in plain Python."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numba import njit

from barchan.kernels.snow import layers
from barchan.kernels.snow.state import MOST_QUANTA, density_of, epoch_of, pack_word, quanta_of
from barchan.snow.conditions import quantum_heights
from tests.kernels.snow.plain import PlainLayers, bare, stack

HEIGHTS = quantum_heights(1.0)


@njit
def take(pack, thickness, cell):
    return layers.pop(pack, thickness, cell)


@njit
def lay(pack, thickness, cell, epoch, density):
    layers.push(pack, thickness, cell, epoch, density)


@settings(max_examples=60, deadline=None)
@given(
    moves=st.lists(st.tuples(st.booleans(), st.integers(0, 3), st.integers(60, 64)), max_size=60),
    kept=st.integers(2, 5),
)
def test_layers_are_those_of_a_plain_list(moves, kept):
    pack, reference = bare(kept), PlainLayers(kept)
    epoch = 1000
    for lays, later, hundreds in moves:
        epoch += later
        if lays or not reference.layers:
            density = hundreds * 6400 // 64
            lay(pack, HEIGHTS, np.uint64(0), epoch, density)
            reference.lay(epoch, density)
        else:
            assert take(pack, HEIGHTS, np.uint64(0)) == reference.take()
        assert stack(pack) == reference.layers
        assert pack.quanta[0] == sum(layer[0] for layer in reference.layers)
        assert pack.surface[0] == sum(q * HEIGHTS[d >> 6] for q, _, d in reference.layers)


def test_a_word_gives_back_what_was_packed():
    word = np.array([pack_word(12345, 1 << 22, 350.25)])
    assert (quanta_of(word)[0], epoch_of(word)[0], density_of(word)[0]) == (12345, 1 << 22, 350.25)


def test_one_layer_packs_as_the_differential_equation_says():
    """d(ln rho)/dt = m g / (2 eta(rho)), by steps of a second in plain Python."""
    viscosity = 1e8 * np.exp(0.01 * np.maximum(np.arange(1024.0), 1.0))
    pack = bare(2)
    pack.top[0] = pack_word(100, 1000, 100.0)
    hours = 48
    for hour in range(hours):
        layers.densify(pack, 1.0, viscosity, np.zeros(1024), 3600.0, np.uint64(hour))
    density = 100.0
    for _ in range(hours * 60):
        density *= np.exp(0.5 * 100.0 * 9.81 / (1e8 * np.exp(0.01 * density)) * 60.0)
    assert density > 103.0
    assert float(density_of(pack.top)[0]) == pytest.approx(density, rel=5e-3)
    assert int(quanta_of(pack.top)[0]) == 100


def test_layers_are_merged_only_where_their_quanta_can_be_counted():
    """The two lowest are of one age, but together one quantum too many: the next pair is merged instead."""
    pack = bare(3)
    pack.buried[0] = [pack_word(MOST_QUANTA - 1, 5, 400.0), pack_word(2, 5, 400.0), pack_word(3, 9, 400.0)]
    pack.buried_count[0] = 3
    pack.top[0] = pack_word(1, 20, 400.0)
    lay(pack, HEIGHTS, np.uint64(0), 30, 400 * 64)
    assert [layer[:2] for layer in stack(pack)] == [(MOST_QUANTA - 1, 5), (5, 7), (1, 20), (1, 30)]
