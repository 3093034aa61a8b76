"""Layers of a cell: a quantum taken from the top, a quantum laid on it, and layers that merge.

Masses are whole numbers of quanta throughout, so nothing is lost. A layer is one number (see ``state``).
"""

import numpy as np
from numba import njit

from barchan.kernels.core.borrow import borrowed
from barchan.kernels.core.internal import internal
from barchan.kernels.core.random import derive, high
from barchan.kernels.snow.state import (
    AGE_CLASSES,
    DENSITY_BITS,
    DENSITY_UNIT,
    EPOCH_BITS,
    KIND,
    MOST_QUANTA,
    OLDEST,
    ONE_QUANTUM,
)

_QUANTA_SHIFT = np.int64(DENSITY_BITS + EPOCH_BITS)
_EPOCH_SHIFT = np.int64(DENSITY_BITS)
_EPOCHS = np.int64((1 << EPOCH_BITS) - 1)
_DENSITIES = np.int64((1 << DENSITY_BITS) - 1)
_WHOLE_DENSITY = np.int64(6)
_DENSITY_CLASS = np.int64(10)
_GRAVITY = 9.81


@internal(forceinline=True)
def thickness_of(thickness, density):
    """Height (µm) of a quantum of a density (1/64 kg/m³)."""
    return thickness[np.uint64(density >> _WHOLE_DENSITY)]


@internal(forceinline=True)
def state_class(word, epoch, age_class):
    """Class of a packed layer's density and age at an epoch."""
    age = min(max(epoch - ((word >> _EPOCH_SHIFT) & _EPOCHS), 0), OLDEST - 1)
    density = (word & _DENSITIES) >> _DENSITY_CLASS
    return np.uint64(density * AGE_CLASSES + np.int64(age_class[np.uint64(age)]))


@internal(forceinline=True)
def pop(pack, thickness, cell):
    """Take a quantum from the top of a cell that holds snow; returns its density (1/64 kg/m³)."""
    word = pack.top[cell]
    density = word & _DENSITIES
    pack.surface[cell] -= thickness_of(thickness, density)
    pack.quanta[cell] -= 1
    word -= ONE_QUANTUM
    if word < ONE_QUANTUM:
        word = np.int64(0)
        buried = np.int64(pack.buried_count[cell])
        if buried > 0:
            word = pack.buried[cell, buried - 1]
            pack.buried_count[cell] = buried - 1
    pack.top[cell] = word
    return density


@internal()
def _height(pack, thickness, cell):
    """Height (µm) of a cell's buried layers."""
    total = np.int64(0)
    for k in range(np.int64(pack.buried_count[cell])):
        word = pack.buried[cell, k]
        total += (word >> _QUANTA_SHIFT) * thickness_of(thickness, word & _DENSITIES)
    return total


@internal()
def _merged(lower, upper):
    """Two packed layers as one: masses add up, the epoch is the mean of the masses', the volume is kept."""
    mass, more = lower >> _QUANTA_SHIFT, upper >> _QUANTA_SHIFT
    total = mass + more
    epochs = mass * ((lower >> _EPOCH_SHIFT) & _EPOCHS) + more * ((upper >> _EPOCH_SHIFT) & _EPOCHS)
    volume = mass / np.float64(lower & _DENSITIES) + more / np.float64(upper & _DENSITIES)
    density = np.int64(np.rint(total / volume))
    return (total << _QUANTA_SHIFT) | ((epochs // total) << _EPOCH_SHIFT) | density


@internal()
def _merge_two(pack, thickness, cell):
    """Merge the two neighbouring buried layers of a cell that differ least: mass times epochs apart."""
    pack, thickness = borrowed((pack, thickness))
    before = _height(pack, thickness, cell)
    count = np.int64(pack.buried_count[cell])
    best, least = np.int64(0), np.int64(-1)
    for k in range(count - 1):
        lower, upper = pack.buried[cell, k], pack.buried[cell, k + 1]
        mass = min(lower >> _QUANTA_SHIFT, upper >> _QUANTA_SHIFT)
        apart = abs(((lower >> _EPOCH_SHIFT) & _EPOCHS) - ((upper >> _EPOCH_SHIFT) & _EPOCHS))
        fits = (lower >> _QUANTA_SHIFT) + (upper >> _QUANTA_SHIFT) <= MOST_QUANTA
        if fits and (least < 0 or mass * apart < least):
            best, least = k, mass * apart
    pack.buried[cell, best] = _merged(pack.buried[cell, best], pack.buried[cell, best + 1])
    for k in range(best + 1, count - 1):
        pack.buried[cell, k] = pack.buried[cell, k + 1]
    pack.buried_count[cell] = count - 1
    pack.surface[cell] += np.int32(_height(pack, thickness, cell) - before)


@internal(forceinline=True)
def push(pack, thickness, cell, epoch, density):
    """Lay a quantum of a density (1/64 kg/m³) on a cell at an epoch."""
    word = pack.top[cell]
    kind = (epoch << _EPOCH_SHIFT) | density
    if word >= ONE_QUANTUM and ((word & KIND) != kind or word >> _QUANTA_SHIFT == MOST_QUANTA):
        if np.int64(pack.buried_count[cell]) == pack.buried.shape[1]:
            _merge_two(pack, thickness, cell)
        buried = np.int64(pack.buried_count[cell])
        pack.buried[cell, buried] = word
        pack.buried_count[cell] = buried + 1
        word = np.int64(0)
    pack.top[cell] = (word + ONE_QUANTUM) if word >= ONE_QUANTUM else ONE_QUANTUM | kind
    pack.surface[cell] += thickness_of(thickness, density)
    pack.quanta[cell] += 1


@njit(cache=True)
def lay_quanta(pack, thickness, counts, epoch, density):
    """Lay ``counts`` quanta of a density on each cell; where negative, take as many from the top."""
    for cell in range(counts.size):
        at = np.uint64(cell)
        for _ in range(counts[cell]):
            push(pack, thickness, at, epoch, density)
        for _ in range(-counts[cell]):
            pop(pack, thickness, at)


@njit(cache=True)
def measure_surface(pack, thickness, ground):
    """Compute the surface of every cell (µm) from its layers over the ``ground`` (µm)."""
    for cell in range(pack.top.size):
        word = pack.top[cell]
        top = (word >> _QUANTA_SHIFT) * thickness_of(thickness, word & _DENSITIES)
        pack.surface[cell] = np.int32(ground[cell] + top + _height(pack, thickness, cell))


@internal()
def _denser(word, above, quantum, viscosity, settling, seconds, draw):
    """A packed layer after some time under the mass ``above`` it and half its own (kg/m²).

    Densities are counted in 64ths, which an hour rarely fills: a ``draw`` of 32 bits rounds them, so that the
    mean is exact.
    """
    density = (word & _DENSITIES) / DENSITY_UNIT
    mass = (word >> _QUANTA_SHIFT) * quantum
    at = min(np.int64(density), viscosity.size - 1)
    rate = (above + 0.5 * mass) * _GRAVITY / viscosity[at] + settling[at]
    grown = density * np.exp(rate * seconds) * DENSITY_UNIT + np.float64(draw) * 2.0**-32
    density = np.int64(min(np.floor(grown), 917.0 * DENSITY_UNIT))
    return (word & ~_DENSITIES) | max(density, word & _DENSITIES)


@njit(cache=True)
def densify(pack, quantum, viscosity, settling, seconds, key):
    """Let all layers pack for some seconds under the snow that lies on them; masses do not change.

    ``viscosity`` (Pa s) and ``settling`` (1/s) are tables by density in whole kg/m³, ``quantum`` is in kg/m².
    """
    for cell in range(pack.top.size):
        start = derive(key, cell)
        word = pack.top[cell]
        if word < ONE_QUANTUM:
            continue
        pack.top[cell] = _denser(word, 0.0, quantum, viscosity, settling, seconds, high(derive(start, 0)))
        above = (word >> _QUANTA_SHIFT) * quantum
        for k in range(np.int64(pack.buried_count[cell]) - 1, -1, -1):
            word = pack.buried[cell, k]
            draw = high(derive(start, k + 1))
            pack.buried[cell, k] = _denser(word, above, quantum, viscosity, settling, seconds, draw)
            above += (word >> _QUANTA_SHIFT) * quantum
