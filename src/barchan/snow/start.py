"""The layers of snow that lie on the ground at the start."""

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.snow.density import LEAST_DENSITY
from barchan.bed import Bed
from barchan.errors import Problem, ScenarioError
from barchan.fields import HEIGHT_UNIT
from barchan.kernels.snow.state import MOST_QUANTA, pack_word, quanta_of
from barchan.snow.clock import FIRST_EPOCH
from barchan.snow.conditions import EPOCH_SECONDS, Conditions, quantum_heights, thickness_of
from barchan.snow.pack import EPOCH, HEIGHT, SNOW, STRESS, TOP, buried_name, fields_of
from barchan.snow.parameters import OldLayer, SnowParameters
from barchan.streams import Stream

HIGHEST = 1 << 30
"""Height (µm) that the kernel's surface can reach with room for what a run adds."""


def lay_first_snow(bed: Bed, parameters: SnowParameters, seed: int) -> None:
    """Add the fields of snow to a bed: its quanta as one layer over the older layers of the parameters."""
    shape = bed.lattice.shape
    for field in fields_of(parameters):
        bed.add(field, np.zeros(shape))
    bed.arrays[STRESS][...] = 1.0
    bed.arrays[EPOCH][...] = FIRST_EPOCH
    layers = []
    for number, old in enumerate(parameters.beneath):
        word = pack_word(quanta_in(old, parameters), _epoch(old.age), old.density)
        weak = pack_word(quanta_in(old, parameters), _epoch(old.weak_age), old.density)
        draws = Stream(seed, "weak snow").draws(number * bed.lattice.cells, bed.lattice.cells)
        chosen = (draws >> np.uint64(32)) < np.uint64(round(old.weak_share * 2**32))
        layers.append(np.where(chosen.reshape(shape), weak, word).astype(np.int64))
    kind = pack_word(0, _epoch(parameters.start_age), start_density(parameters))
    own = bed.arrays[SNOW].astype(np.int64)
    layers.append(np.where(own > 0, (own << 40) | kind, 0))
    _stack(bed, layers)
    bed.arrays[SNOW][...] = sum(quanta_of(layer) for layer in layers)
    bed.arrays[HEIGHT][...] = sum(thickness_of(layer, parameters.quantum) for layer in layers)


def start_density(parameters: SnowParameters) -> float:
    """Density (kg/m³) of the snow of the start."""
    if parameters.start_density is not None:
        return parameters.start_density
    return Conditions(parameters, parameters.reference_wind, parameters.temperature).drift_density


def start_problems(parameters: SnowParameters) -> list[tuple[str, str]]:
    """Keys of older layers that cannot be laid, and why."""
    found = []
    if len(parameters.beneath) > parameters.layers:
        text = f"has {len(parameters.beneath)} layers; allowed: up to {parameters.layers}, as layers says"
        found.append(("beneath", text))
    for number, old in enumerate(parameters.beneath):
        if quanta_in(old, parameters) > MOST_QUANTA:
            text = (
                f"is {old.mass:g} kg/m²; allowed: up to {MOST_QUANTA} quanta of {parameters.quantum:g} kg/m²"
            )
            found.append((f"beneath[{number}].mass", text))
    return found


def check_counts(bed: Bed, parameters: SnowParameters) -> None:
    """Raise ScenarioError for more quanta on a cell than a layer can count, or a surface too high for it."""
    quanta = int(bed.arrays[SNOW].max())
    if quanta > MOST_QUANTA:
        text = f"has stacks of up to {quanta} quanta; allowed: up to {MOST_QUANTA}"
        raise ScenarioError([Problem("sand", text)])
    total = quanta + sum(quanta_in(old, parameters) for old in parameters.beneath)
    if total > MOST_QUANTA:
        text = f"has stacks of up to {total} quanta with older layers; allowed: up to {MOST_QUANTA}"
        raise ScenarioError([Problem("model.beneath", text)])
    thickest = int(quantum_heights(parameters.quantum)[int(LEAST_DENSITY)])
    relief = float(np.ptp(bed.ground)) / HEIGHT_UNIT + total * thickest
    if relief > HIGHEST:
        height, highest = relief * HEIGHT_UNIT, HIGHEST * HEIGHT_UNIT
        text = f"and the snow on it come to {height:.1f} m; allowed: {highest:.1f} m"
        raise ScenarioError([Problem("ground", text)])


def quanta_in(old: OldLayer, parameters: SnowParameters) -> int:
    """Quanta of an older layer, at least one."""
    return max(round(old.mass / parameters.quantum), 1)


def _epoch(hours: float) -> int:
    """The epoch of snow that is so many hours (at -10 °C) old at the start."""
    return max(FIRST_EPOCH - round(hours * 3600.0 / EPOCH_SECONDS), 0)


def _stack(bed: Bed, layers: list[NDArray[np.int64]]) -> None:
    """Write layers to the bed's fields: on each cell the uppermost on top, those beneath it buried."""
    *older, own = layers
    for number, layer in enumerate(older, start=1):
        bed.arrays[buried_name(number)][...] = layer
    bed.arrays[TOP][...] = own
    if older:
        bare = own == 0
        bed.arrays[TOP][bare] = older[-1][bare]
        bed.arrays[buried_name(len(older))][bare] = 0
