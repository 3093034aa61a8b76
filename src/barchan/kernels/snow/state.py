"""Layers of snow and the rules of the snow kernel. Nothing here imports the compiler."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from barchan.kernels.slabs.state import SlabRules

DENSITY_BITS, EPOCH_BITS, QUANTA_BITS = 16, 24, 20
"""Bits of a packed layer, from the lowest: density in 1/64 kg/m³, epoch of deposition, number of quanta."""

DENSITY_UNIT = 64
"""Parts of a kg/m³ in which densities are counted."""

ONE_QUANTUM = 1 << (DENSITY_BITS + EPOCH_BITS)
"""A packed layer's quantum."""

KIND = ONE_QUANTUM - 1
"""Mask of what sets a layer apart: its epoch and its density."""

MOST_QUANTA = (1 << QUANTA_BITS) - 1
"""Quanta that a layer can count."""

OLDEST = 1 << 16
"""Ages (epochs) that are told apart; older snow counts as this old, less one."""

DENSITY_CLASSES = 64
"""Classes of 16 kg/m³ in the tables of a layer's state."""

AGE_CLASSES = 128
"""Classes of age: every age up to 16 epochs, then eight to a doubling."""


class Pack(NamedTuple):
    """The snow on all cells, flat, in the wind's frame; changed in place."""

    surface: NDArray[np.int32]
    """Height (µm) of the surface over the lowest ground, with room before it as for slabs."""
    quanta: NDArray[np.int32]
    """Quanta of snow on each cell."""
    top: NDArray[np.int64]
    """The packed uppermost layer of each cell; 0: bare."""
    buried: NDArray[np.int64]
    """Packed layers below it, cell by layer, the deepest first."""
    buried_count: NDArray[np.uint8]
    """Number of buried layers on each cell."""


class LayerTables(NamedTuple):
    """What a layer's density and age decide under the present weather.

    Arrays of the state's class, ``density class * AGE_CLASSES + age class``, but for the first two.
    """

    thickness: NDArray[np.int32]
    """Height of a quantum (µm) by density in whole kg/m³."""
    age_class: NDArray[np.uint8]
    """Class of each age (epochs) below ``OLDEST``."""
    threshold: NDArray[np.float32]
    """Threshold stress over the stress on the flat."""
    yields: NDArray[np.float32]
    """Chance to give a quantum for each unit by which the stress exceeds the threshold."""
    wears: NDArray[np.float32]
    """Chance to give a quantum by abrasion where the cell stands out by the height of the saltation layer."""
    bonded: NDArray[np.uint8]
    """Whether the snow counts as bonded."""
    face_limit: NDArray[np.int32]
    """Largest step (µm) to a lower face neighbour that stands."""


UPWIND = 4
"""Place of the cell upwind among a cell's neighbours, counted anticlockwise from the one downwind."""


class Giving(NamedTuple):
    """What decides whether a polled cell gives a quantum."""

    abrades: bool
    exposure_height: int
    """Height (µm) of the saltation layer: a cell that stands out by more is worn no faster."""
    corner: int
    """Place of the corner that an oblique wind comes from, counted as ``UPWIND``."""
    spread: float
    """Standard deviation of the threshold wind over the wind on the flat; 0: the threshold is sharp."""
    power: float
    """Power of the stress with which the wind grows."""
    oblique: int
    """Chance, in 2**-32, that grains come from that corner and not along the columns' axis."""


class Creep(NamedTuple):
    """Quanta that roll on after they have landed."""

    by_slope: bool
    """Whether quanta are pushed down in proportion to the slope, or roll by a chance that knows no slope."""
    chance: np.int64
    """Chance, in 2**-32, to roll once to the lowest face neighbour."""
    per_height: float
    """Mean number of pushes along an axis for each µm of the drop to its lower neighbour."""


class SnowRules(NamedTuple):
    """The rules of a snow model under one wind and weather; what it does without is None."""

    slabs: SlabRules
    """Lattice, hop, chances of deposition, shadow lines and neighbour orders."""
    tables: LayerTables
    giving: Giving | None
    """None: every cell that holds snow outside the shadow gives a quantum."""
    stress: NDArray[np.float32] | None
    """Shear stress on each cell over that on the flat; None: everywhere the same."""
    impact_threshold: float
    """Stress, over that on the flat, at which drift dies out over fresh drift."""
    creep: Creep | None
    epoch: int
    """The present epoch."""
    density: int
    """Density of what the wind lays down, in 1/``DENSITY_UNIT`` kg/m³."""
    gentlest: int
    """Step (µm) to a face neighbour at which any snow stands."""
    corner_factor: float
    """Limit to a corner neighbour over that to a face; 0: nothing slides to corners."""


def age_classes() -> NDArray[np.uint8]:
    """The class of each age (epochs) below ``OLDEST``: every age up to 16, then eight to a doubling."""
    ages = np.arange(OLDEST)
    octave = np.maximum(np.floor(np.log2(np.maximum(ages, 1))).astype(np.int64) - 3, 0)
    classes = np.where(ages < 16, ages, (octave << 3) + (ages >> octave))
    return classes.astype(np.uint8)


def pack_word(quanta: int, epoch: int, density: float) -> int:
    """A packed layer: its quanta, epoch and density (kg/m³)."""
    return (quanta << (DENSITY_BITS + EPOCH_BITS)) | (epoch << DENSITY_BITS) | round(density * DENSITY_UNIT)


def quanta_of(words: NDArray[np.int64]) -> NDArray[np.int64]:
    """Quanta of packed layers."""
    return words >> (DENSITY_BITS + EPOCH_BITS)


def epoch_of(words: NDArray[np.int64]) -> NDArray[np.int64]:
    """Epochs of packed layers."""
    return (words >> DENSITY_BITS) & ((1 << EPOCH_BITS) - 1)


def density_of(words: NDArray[np.int64]) -> NDArray[np.float64]:
    """Densities (kg/m³) of packed layers."""
    return (words & ((1 << DENSITY_BITS) - 1)) / DENSITY_UNIT
