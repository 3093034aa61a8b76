"""The fields of a simulation as frames carry them to the browser."""

from collections.abc import Iterator
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.analysis.fields import PLAIN, centre_of
from barchan.fields import GROUND
from barchan.models import Derived
from barchan.simulation import Simulation
from barchan.squares import Squares
from barchan.studio.protocol import EncodedField

STEPS_OF_CHANGE = 50
"""Steps over which erosion and deposition are shown, at least."""

CHANGE = "change"

_LARGEST = np.iinfo(np.uint16).max


@dataclass(frozen=True)
class AvailableField:
    """A field that the browser may ask for, without its values."""

    name: str
    unit: str
    meaning: str
    centre: float | None
    """The value about which its colours are symmetric, where there is one."""
    choice: bool = False
    """Whether its values are yes or no."""
    of_layers: bool = False
    """Whether it has no value on bare ground."""


_CHANGE = AvailableField(
    CHANGE, "m", f"erosion and deposition over the last {STEPS_OF_CHANGE} steps or more", 0.0
)


def fields_of(simulation: Simulation) -> list[dict[str, Any]]:
    """All fields that ``encoded_field`` can make, beside those that the browser derives from the surface."""
    return [asdict(field) for field in (_CHANGE, *_kept(simulation), *_derived(simulation))]


def exported_fields(simulation: Simulation) -> list[dict[str, str]]:
    """Name and meaning of all fields that files for other programs may hold."""
    layers = [(layer.name, layer.meaning) for layer in simulation.bed.layers]
    kept = [(field.name, field.meaning) for field in (*_kept(simulation), *_derived(simulation))]
    plain = [(field.name, field.meaning) for field in PLAIN]
    surface = [("elevation", "elevation of the surface"), (GROUND.name, GROUND.meaning)]
    names = dict(reversed([*surface, *plain, *layers, *kept]))
    return [{"name": name, "meaning": meaning} for name, meaning in reversed(names.items())]


def _kept(simulation: Simulation) -> Iterator[AvailableField]:
    hidden = {GROUND.name, *(layer.name for layer in simulation.bed.layers)}
    for field in simulation.bed.declared.values():
        if field.in_frames and not field.coded and field.name not in hidden:
            yield AvailableField(field.name, field.unit, field.meaning, field.centre)


def _derived(simulation: Simulation) -> Iterator[AvailableField]:
    model, wind = simulation.model, simulation.last_segment
    for derived in model.derived:
        choice = derived.compute(model, simulation.bed, wind).dtype == np.bool_
        centre = centre_of(model, derived, wind)
        yield AvailableField(derived.name, derived.unit, derived.meaning, centre, choice, derived.of_layers)


def surface_fields(simulation: Simulation, with_ground: bool) -> Iterator[EncodedField]:
    """The depth of all layers (m, or whole units of one height); before it, where wanted, the ground (m).

    The browser draws squares: fields of hexagons are brought onto them.
    """
    bed, squares = simulation.bed, Squares(simulation.lattice)
    if with_ground:
        yield EncodedField("ground", squares.between(bed.ground).astype(np.float32))
    if squares.true.hexagonal or any(layer.mass is not None for layer in bed.layers):
        yield EncodedField("depth", squares.between(bed.depth).astype(np.float32))
    else:
        units = bed.stack.astype(_type_up_to(bed.stack.max()))
        yield EncodedField("depth", units, simulation.lattice.thickness)


def _type_up_to(largest: int) -> type[np.number]:
    """The smallest type of the protocol that holds whole numbers from 0 up."""
    return next(kind for kind in (np.uint8, np.uint16, np.int32) if largest <= np.iinfo(kind).max)


def encoded_field(
    simulation: Simulation, name: str, earlier: NDArray[np.float64] | None
) -> EncodedField | None:
    """A field by its name, in 16 bits a cell or fewer; None where the model has no such field.

    ``earlier`` is the elevation (m) from which erosion and deposition are counted.
    """
    values = _values(simulation, name, earlier)
    return None if values is None else encoded(simulation, name, values)


def encoded(simulation: Simulation, name: str, values: NDArray) -> EncodedField:
    """Values on the lattice of a simulation as a field of a frame, in 16 bits a cell or fewer."""
    values = Squares(simulation.lattice).between(values)
    if values.dtype == np.bool_:
        return EncodedField(name, values.astype(np.uint8))
    low, high = float(values.min()), float(values.max())
    scale = (high - low) / _LARGEST or 1.0
    return EncodedField(name, np.rint((values - low) / scale).astype(np.uint16), scale, low)


def _values(simulation: Simulation, name: str, earlier: NDArray[np.float64] | None) -> NDArray | None:
    if name == CHANGE:
        now = simulation.elevation
        return now - (now if earlier is None else earlier)
    for derived in (*simulation.model.derived, *PLAIN):
        if derived.name == name:
            return _derive(simulation, derived)
    return simulation.bed.arrays.get(name)


def _derive(simulation: Simulation, derived: Derived) -> NDArray:
    return np.asarray(derived.compute(simulation.model, simulation.bed, simulation.last_segment))
