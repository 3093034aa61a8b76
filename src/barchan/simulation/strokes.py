"""What strokes of a brush do to a bed: sand, ground and plants painted, then slopes brought to rest."""

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Bed
from barchan.errors import BarchanError, Problem, ScenarioError
from barchan.fields import GROUND
from barchan.ground.brush import brush, brushed, grown, raised
from barchan.lattice import Lattice
from barchan.models import Model
from barchan.scenario import nearest
from barchan.simulation.events import PlantStroke, RockStroke, Stroke
from barchan.simulation.ledger import Ledger

AnyStroke = Stroke | RockStroke | PlantStroke


def change_by(stroke: AnyStroke, bed: Bed, model: Model) -> NDArray:
    """What a stroke would change on each cell: slabs, metres of ground, or a field's own unit.

    Raises ScenarioError for a field that the model does not let paint.
    """
    strength = brush(bed.lattice, stroke.x, stroke.y, stroke.radius, stroke.falloff)
    if isinstance(stroke, Stroke):
        return brushed(bed, strength, stroke.amount)
    if isinstance(stroke, RockStroke):
        return raised(bed, strength, stroke.amount)
    bounds = _bounds(stroke, model)
    return grown(bed.arrays[stroke.field], strength, stroke.amount, bounds)


def asked_by(stroke: AnyStroke, lattice: Lattice) -> NDArray[np.float64]:
    """What a stroke would change on each cell if nothing held it back, in the unit of ``change_by``."""
    strength = brush(lattice, stroke.x, stroke.y, stroke.radius, stroke.falloff)
    if isinstance(stroke, PlantStroke):
        return stroke.amount * strength
    unit = lattice.thickness if isinstance(stroke, RockStroke) else 1.0
    return np.rint(stroke.amount * strength) * unit


def paint(stroke: AnyStroke, bed: Bed, model: Model, ledger: Ledger) -> None:
    """Paint, in place; the bed stays as it was where that is refused.

    Raises BarchanError, or ScenarioError where the model cannot work on what would come of it.
    """
    change = change_by(stroke, bed, model)
    if isinstance(stroke, Stroke):
        _lay(change, stroke, bed, ledger)
    elif isinstance(stroke, RockStroke):
        _raise(change, bed, model)
    else:
        bed.arrays[stroke.field][...] += change
    model.settle(bed, change != 0)
    ledger.check(bed)


def _lay(change: NDArray, stroke: Stroke, bed: Bed, ledger: Ledger) -> None:
    try:
        bed.lay(change)
    except OverflowError:
        message = (
            f"a stroke of {stroke.amount} {bed.layers[-1].unit} is more than a cell can hold on what it has"
        )
        raise BarchanError(message) from None
    ledger.entered += int(change[change > 0].sum())
    ledger.left -= int(change[change < 0].sum())


def _raise(change: NDArray, bed: Bed, model: Model) -> None:
    before = bed.ground
    bed.add(GROUND, before + change)
    try:
        model.check_bed(bed)
    except ScenarioError:
        bed.add(GROUND, before)
        raise


def _bounds(stroke: PlantStroke, model: Model) -> tuple[float, float]:
    known = model.paintable()
    if stroke.field not in known:
        names = ", ".join(known) or "none of this model"
        message = f"'{stroke.field}' cannot be painted{nearest(stroke.field, known)}; allowed: {names}"
        raise ScenarioError([Problem("field", message)], "event")
    return known[stroke.field]
