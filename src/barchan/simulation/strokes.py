"""Strokes of a brush on a bed: sand, ground and plants painted, then slopes brought to rest."""

from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.snow.density import GREATEST_DENSITY, LEAST_DENSITY
from barchan.bed import Bed
from barchan.errors import BarchanError, Problem, ScenarioError
from barchan.fields import GROUND, HEIGHT_UNIT
from barchan.ground.brush import Falloff, brush, brushed, grown, raised, whole
from barchan.ground.sand import MOST_SLABS
from barchan.lattice import Lattice
from barchan.models import Model
from barchan.parameters import Parameters, parameter
from barchan.scenario import nearest
from barchan.simulation.change import Change
from barchan.words import counted

if TYPE_CHECKING:
    from barchan.simulation.core import Simulation

MOST_PLANTS = 100.0
"""Largest change of plants by one stroke, in the unit of the field."""


MOST_ICE = 100.0
"""Largest rise of the ground by one stroke of ice (m)."""


MOST_TRAIL = 16
"""Stamps that a stamp is added up with, at most."""


class Stamp(Parameters):
    """Where a brush is set down."""

    x: float = parameter(unit="m", meaning="Centre, from the west edge.")
    y: float = parameter(unit="m", meaning="Centre, from the south edge.")


class BrushStroke(Change, Stamp):
    """A stroke on a round patch; the kind of stroke decides which field of the bed it changes."""

    radius: float = parameter(unit="m", gt=0, meaning="Radius of the patch.")
    falloff: Falloff = parameter("smooth", unit="-", meaning="How the amount falls towards the rim.")
    trail: list[Stamp] = parameter(
        [],
        unit="-",
        max_length=MOST_TRAIL,
        meaning="Where stamps before it of the same stroke are, alike in all else: whole units count "
        "for their sum, so that a stroke drawn stamp by stamp is as even as its sum.",
    )

    def painted(self) -> str:
        """What is painted, and how much of it."""
        raise NotImplementedError

    def summary(self) -> str:
        """What is painted, how much, and where."""
        return f"{self.painted()} within {self.radius:g} m of x {self.x:g} m, y {self.y:g} m"

    def strength(self, lattice: Lattice) -> NDArray[np.float64]:
        """Strength of the brush on each cell, from 0 to 1 at the centre."""
        return brush(lattice, self.x, self.y, self.radius, self.falloff)

    def units(self, lattice: Lattice, amount: float) -> NDArray[np.float64]:
        """Whole units added to each cell beside those of the stamps before it, ``amount`` at the centre."""
        stamps = (brush(lattice, stamp.x, stamp.y, self.radius, self.falloff) for stamp in self.trail)
        before = sum(stamps, np.zeros(lattice.shape)) if self.trail else None
        return whole(self.strength(lattice), before, amount)

    def change(self, bed: Bed, model: Model) -> NDArray:
        """The change that the bed allows on each cell: slabs, metres of ground, or a field's own unit.

        Raises ScenarioError for a field that the model does not let paint.
        """
        raise NotImplementedError

    def requested(self, lattice: Lattice) -> NDArray[np.float64]:
        """The change on each cell if the bed allowed all of it, in the unit of ``change``."""
        raise NotImplementedError

    def apply(self, simulation: "Simulation") -> None:
        """Paint, then let slopes that the change upsets come to rest."""
        bed = simulation.bed
        change = self.change(bed, simulation.model)
        self._lay(change, simulation)
        simulation.model.relax(bed, change != 0)
        simulation.ledger.check(bed)

    def _lay(self, change: NDArray, simulation: "Simulation") -> None:
        """Write the change into the bed."""
        raise NotImplementedError


class UnitStroke(BrushStroke):
    """Whole units added to the uppermost layer, or taken from the layers, on a round patch."""

    amount: int = parameter(
        unit="slabs",
        ge=-MOST_SLABS,
        le=MOST_SLABS,
        meaning="Slabs at the centre; negative to take away.",
    )

    def change(self, bed: Bed, model: Model) -> NDArray:  # noqa: ARG002
        """Units added to each cell; no more are taken than lie there."""
        return brushed(bed, self.requested(bed.lattice))

    def requested(self, lattice: Lattice) -> NDArray[np.float64]:
        """Slabs on each cell, whole ones."""
        return self.units(lattice, self.amount)

    def _lay(self, change: NDArray, simulation: "Simulation") -> None:
        bed, ledger = simulation.bed, simulation.ledger
        try:
            self._add(change, simulation)
        except OverflowError:
            unit = bed.layers[-1].unit
            message = f"a stroke of {self.amount} {unit} is more than a cell can hold on what it has"
            raise BarchanError(message) from None
        ledger.entered += int(change[change > 0].sum())
        ledger.left -= int(change[change < 0].sum())

    def _add(self, change: NDArray, simulation: "Simulation") -> None:
        """Add the units; raises OverflowError where a cell cannot count as many."""
        simulation.bed.lay(change)


class Stroke(UnitStroke):
    """Units added to the uppermost layer, or taken from the layers, on a round patch."""

    kind: Literal["stroke"] = parameter("stroke", unit="-", meaning="Sand (or snow) added or taken away.")

    def painted(self) -> str:
        """What is painted, and how much of it."""
        return f"sand {counted(self.amount, 'slab', form='+d')}"


class SnowfallStroke(UnitStroke):
    """Fresh snow of a stated density laid on a round patch, in whole quanta."""

    kind: Literal["snowfall"] = parameter("snowfall", unit="-", meaning="Fresh snow laid, or taken away.")
    density: float = parameter(
        100.0,
        unit="kg/m³",
        ge=LEAST_DENSITY,
        le=GREATEST_DENSITY,
        meaning="Density of the fresh snow; of no account where snow is taken away.",
    )

    def painted(self) -> str:
        """What is painted, and how much of it."""
        return f"fresh snow {counted(self.amount, 'quantum', 'quanta', '+d')} of {self.density:g} kg/m³"

    def change(self, bed: Bed, model: Model) -> NDArray:
        """Quanta added to each cell; raises ScenarioError for a model that keeps no densities of snow."""
        if model.fresh_densities is None:
            text = f"is snowfall; allowed with {model.name}: stroke, for it keeps no densities of snow"
            raise ScenarioError([Problem("kind", text)], "event")
        return super().change(bed, model)

    def _add(self, change: NDArray, simulation: "Simulation") -> None:
        simulation.model.lay_fresh(simulation.bed, change, self.density)


class GroundStroke(BrushStroke):
    """Ground raised or lowered on a round patch, under what lies there, never below the lowest ground."""

    def _lay(self, change: NDArray, simulation: "Simulation") -> None:
        bed = simulation.bed
        before = bed.ground
        bed.add(GROUND, before + change)
        try:
            simulation.model.check_bed(bed)
        except ScenarioError:
            bed.add(GROUND, before)
            raise


class RockStroke(GroundStroke):
    """Ground raised or lowered by whole slabs on a round patch, under the sand that lies there."""

    kind: Literal["rock"] = parameter("rock", unit="-", meaning="Ground raised or lowered.")
    amount: int = parameter(
        unit="slabs",
        ge=-MOST_SLABS,
        le=MOST_SLABS,
        meaning="Height at the centre; negative to lower, to the lowest ground at most.",
    )

    def painted(self) -> str:
        """What is painted, and how much of it."""
        return f"ground {counted(self.amount, 'slab', form='+d')}"

    def change(self, bed: Bed, model: Model) -> NDArray:  # noqa: ARG002
        """Rise of the ground on each cell (m), in whole slabs, never below the lowest ground."""
        return raised(bed, self.units(bed.lattice, self.amount))

    def requested(self, lattice: Lattice) -> NDArray[np.float64]:
        """Rise of the ground on each cell (m), in whole slabs."""
        return self.units(lattice, self.amount) * lattice.thickness


class IceStroke(GroundStroke):
    """A lump of ice: ground raised or lowered by a height on a round patch, under what lies there."""

    kind: Literal["ice"] = parameter("ice", unit="-", meaning="Ground raised or lowered by a height.")
    amount: float = parameter(
        unit="m",
        ge=-MOST_ICE,
        le=MOST_ICE,
        meaning="Height at the centre; negative to lower, to the lowest ground at most.",
    )

    def painted(self) -> str:
        """What is painted, and how much of it."""
        return f"ice {self.amount:+g} m"

    def change(self, bed: Bed, model: Model) -> NDArray:  # noqa: ARG002
        """Rise of the ground on each cell (m), never below the lowest ground."""
        return np.maximum(self.requested(bed.lattice), bed.ground.min() - bed.ground)

    def requested(self, lattice: Lattice) -> NDArray[np.float64]:
        """Rise of the ground on each cell (m), in whole units of snow's heights."""
        return np.asarray(self.units(lattice, self.amount / HEIGHT_UNIT) * HEIGHT_UNIT)


class PlantStroke(BrushStroke):
    """Plants of one species, or another field that a model lets paint, set or thinned on a round patch."""

    kind: Literal["plants"] = parameter("plants", unit="-", meaning="Plants set or thinned.")
    field: str = parameter(unit="-", meaning="The model's field that is painted, for instance grass.")
    amount: float = parameter(
        unit="-",
        ge=-MOST_PLANTS,
        le=MOST_PLANTS,
        meaning="Change at the centre; negative to thin, to none at most.",
    )

    def painted(self) -> str:
        """What is painted, and how much of it."""
        return f"{self.field} {self.amount:+g}"

    def change(self, bed: Bed, model: Model) -> NDArray:
        """Change of the field on each cell, within its bounds."""
        bounds = self._bounds(model)
        return grown(bed.arrays[self.field], self.strength(bed.lattice), self.amount, bounds)

    def requested(self, lattice: Lattice) -> NDArray[np.float64]:
        """Change of the field on each cell."""
        return self.amount * self.strength(lattice)

    def _lay(self, change: NDArray, simulation: "Simulation") -> None:
        simulation.bed.arrays[self.field][...] += change

    def _bounds(self, model: Model) -> tuple[float, float]:
        known = model.paintable()
        if self.field not in known:
            names = ", ".join(known) or "none of this model"
            message = f"'{self.field}' cannot be painted{nearest(self.field, known)}; allowed: {names}"
            raise ScenarioError([Problem("field", message)], "event")
        return known[self.field]


AnyStroke = Stroke | SnowfallStroke | RockStroke | IceStroke | PlantStroke
