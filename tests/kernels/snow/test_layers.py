"""Layers of a cell beside a list of layers in plain Python."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numba import njit

from barchan.kernels.snow import layers
from barchan.kernels.snow.state import (
    MOST_QUANTA,
    ONE_QUANTUM,
    Pack,
    density_of,
    epoch_of,
    pack_word,
    quanta_of,
)
from barchan.snow.conditions import quantum_heights

HEIGHTS = quantum_heights(1.0)


@njit
def take(pack, thickness, cell):
    return layers.pop(pack, thickness, cell)


@njit
def lay(pack, thickness, cell, epoch, density):
    layers.push(pack, thickness, cell, epoch, density)


def bare(kept):
    one = np.zeros(1, np.int32)
    return Pack(
        one.copy(), one.copy(), np.zeros(1, np.int64), np.zeros((1, kept), np.int64), np.zeros(1, np.uint8)
    )


def stack(pack):
    """(quanta, epoch, density) of the cell's layers, the deepest first."""
    words = [*pack.buried[0, : pack.buried_count[0]], pack.top[0]]
    return [
        (int(quanta_of(w)), int(epoch_of(w)), round(float(density_of(w)) * 64))
        for w in words
        if w >= ONE_QUANTUM
    ]


def merged(lower, upper):
    (m, e, d), (n, f, g) = lower, upper
    return m + n, (m * e + n * f) // (m + n), round((m + n) / (m / d + n / g))


class Reference:
    """A list of layers; when one too many is buried, the two neighbours that differ least become one."""

    def __init__(self, kept):
        self.layers, self.kept = [], kept

    def lay(self, epoch, density):
        if self.layers and self.layers[-1][1:] == (epoch, density):
            quanta, *kind = self.layers.pop()
            self.layers.append((quanta + 1, *kind))
            return
        if len(self.layers) == self.kept + 1:
            buried = self.layers[:-1]
            costs = [min(a[0], b[0]) * abs(a[1] - b[1]) for a, b in pairwise(buried)]
            at = costs.index(min(costs))
            self.layers[at : at + 2] = [merged(self.layers[at], self.layers[at + 1])]
        self.layers.append((1, epoch, density))

    def take(self):
        quanta, epoch, density = self.layers.pop()
        if quanta > 1:
            self.layers.append((quanta - 1, epoch, density))
        return density


@settings(max_examples=60, deadline=None)
@given(
    moves=st.lists(st.tuples(st.booleans(), st.integers(0, 3), st.integers(60, 64)), max_size=60),
    kept=st.integers(2, 5),
)
def test_layers_are_those_of_a_plain_list(moves, kept):
    pack, reference = bare(kept), Reference(kept)
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
