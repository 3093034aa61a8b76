"""The flux over a bed that the rules of slab transport lead one to expect, cell by cell."""

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Bed
from barchan.directions import downwind
from barchan.lattice import HEX_ROWS, Lattice
from barchan.wind.segment import Segment

if TYPE_CHECKING:
    from barchan.slabs.model import SlabModel

Field = NDArray[np.float64]

LEAST = 1e-4
"""Share of a poll below which slabs that still fly are left out."""

MOST_HOPS = 1000
"""Hops after which slabs that still fly are left out."""


def expected_flux(model: "SlabModel", bed: Bed, wind: Segment) -> Field:
    """Volume (with pores) that leaves each cell on the wind times its hop, per area and step: m² per step.

    The mean over a field is the net flux that a step over this bed is expected to have. Slabs that the wind
    takes up on a cell and those that hop on from it count alike; each starts at the cell's centre. Polls are
    those of the wind in a whole step, shadows and heights those of the bed as it is. Walls in the way of a
    slab (``path_test``) are not looked at.
    """
    lattice = bed.lattice
    rules = model.rules()
    hops = model.hops(bed, model.hop_length(wind)).ravel()
    if rules.hop is not None and rules.hop.whole:
        hops = np.floor(hops + 0.5)
    sheltered = model.shadow_zone(bed, wind.direction)
    given = np.where(hops == 0.0, 0.0, _given(model, bed, wind, sheltered).ravel())
    settles = _settles(model, bed, wind, sheltered).ravel()
    if rules.hop is not None and rules.hop.every_hop:
        settles = np.where(hops == 0.0, 1.0, settles)
    carried = np.zeros(lattice.cells)
    flying = _Flying.of(lattice, given, hops)
    least, number = LEAST * float(given.max(initial=0.0)), 0
    while flying.cell.size and number < min(model.parameters.max_hops, MOST_HOPS):
        np.add.at(carried, flying.cell, flying.slabs * flying.hop)
        flying = flying.after_hop(lattice, wind.direction)
        flying = replace(flying, slabs=flying.slabs * (1.0 - settles[flying.cell]))
        if rules.hop is not None and rules.hop.every_hop:
            flying = replace(flying, hop=hops[flying.cell])
        flying = flying.where(flying.slabs > least)
        number += 1
    return (carried * lattice.thickness * lattice.cell_size).reshape(lattice.shape)


def _given(model: "SlabModel", bed: Bed, wind: Segment, sheltered: NDArray[np.bool_]) -> Field:
    """Slabs that each cell is expected to give in a whole step of this wind."""
    chance = np.where(bed.sand > 0, 1.0, 0.0)
    mobility = model.mobility(bed, wind.direction)
    if mobility is not None:
        erosion = model.rules().erosion
        chance *= np.clip(mobility * erosion.factor + erosion.offset, 0.0, 1.0)
    if not model.parameters.lee_erosion:
        chance[sheltered] = 0.0
    polls = wind.polls / wind.share / bed.lattice.cells
    if model.parameters.forced_erosion and chance.any():
        polls /= chance.mean()
    return chance * polls


def _settles(model: "SlabModel", bed: Bed, wind: Segment, sheltered: NDArray[np.bool_]) -> Field:
    """The chance that a slab stays on each cell where it lands."""
    hops_on = 1.0 - np.where(bed.sand > 0, model.parameters.p_s, model.parameters.p_ns)
    mobility = model.mobility(bed, wind.direction)
    if mobility is not None:
        hops_on = np.clip(hops_on * mobility, 0.0, 1.0)
    return np.where(sheltered, 1.0, 1.0 - hops_on)


@dataclass(frozen=True)
class _Flying:
    """Slabs about to leave cells: their numbers, their hops and where they are (cells)."""

    cell: NDArray[np.int64]
    slabs: Field
    hop: Field
    x: Field
    y: Field

    @classmethod
    def of(cls, lattice: Lattice, given: Field, hops: Field) -> "_Flying":
        """What cells give, from their centres."""
        cell = np.flatnonzero(given)
        x, y = (part.ravel()[cell] / lattice.cell_size for part in lattice.centres)
        return cls(cell, given[cell], hops[cell], x, y)

    def where(self, chosen: NDArray[np.bool_]) -> "_Flying":
        """Those chosen."""
        return _Flying(
            self.cell[chosen], self.slabs[chosen], self.hop[chosen], self.x[chosen], self.y[chosen]
        )

    def after_hop(self, lattice: Lattice, direction: float) -> "_Flying":
        """All a hop further, without those that left the field."""
        east, north = downwind(direction)
        moved = replace(self, x=self.x + self.hop * east, y=self.y + self.hop * north)
        row, column = _cell_at(lattice, moved.x, moved.y)
        inside = np.ones(row.shape, np.bool_)
        for index, size, joined in (
            (row, lattice.rows, lattice.periodic[0]),
            (column, lattice.columns, lattice.periodic[1]),
        ):
            if not joined:
                inside &= (index >= 0) & (index < size)
        cell = (row % lattice.rows) * lattice.columns + column % lattice.columns
        return replace(moved, cell=cell).where(inside)


def _cell_at(lattice: Lattice, x: Field, y: Field) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Row and column, perhaps beyond the field, of the cell around each point (cells)."""
    if not lattice.hexagonal:
        return np.floor(y).astype(np.int64), np.floor(x).astype(np.int64)
    first = lattice.y[0] / lattice.cell_size
    lower = np.floor((y - first) / HEX_ROWS).astype(np.int64)
    found = []
    for row in (lower, lower + 1):
        column = np.floor(x - 0.5 * (row % 2)).astype(np.int64)
        away = np.hypot(x - 0.5 * (row % 2) - column - 0.5, y - first - row * HEX_ROWS)
        found.append((row, column, away))
    below, above = found
    nearer = below[2] <= above[2]
    return np.where(nearer, below[0], above[0]), np.where(nearer, below[1], above[1])
