"""The bed as grains meet it, for the time of one call: its arrays, counts, shelter and slopes."""

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.flow_over_relief import WindOverWaves
from barchan.aeolian.flux import KARMAN
from barchan.bed import Bed, Lattice
from barchan.grains.canopy import Hold
from barchan.grains.parameters import GrainFlight
from barchan.grains.sizes import shuffle_anew
from barchan.heights import FRACTION_BITS
from barchan.kernels.bed.state import Grid, Stacks, relaxation_orders, repose_rule
from barchan.kernels.core.state import TRAVEL_UNIT
from barchan.kernels.grains.state import (
    CAPPED,
    COUNTS,
    FLOWN,
    LEFT,
    LOST,
    LOST_UNIT,
    MOVED,
    TRAVEL_X,
    TRAVEL_Y,
    Ejecta,
    Events,
    Filter,
    Ground,
    Scale,
    Scene,
)
from barchan.model import Tally
from barchan.streams import derive
from barchan.wind.frame import WindFrame


def repose_limits(angle: float, lattice: Lattice) -> tuple[int, int]:
    """Largest steps (parcels) that stand towards faces and corners; at least one."""
    slope = math.tan(math.radians(angle)) / lattice.aspect
    return max(1, math.floor(slope + 1e-9)), max(1, math.floor(math.sqrt(2.0) * slope + 1e-9))


class GrainGround:
    """A bed with what the kernels need beside it. Changes the bed's sand in place."""

    def __init__(
        self,
        rules: GrainFlight,
        bed: Bed,
        direction: float = 270.0,
        room: Any = None,
        mixture: Any = None,
        plants: Hold | None = None,
    ) -> None:
        """Take a bed under a wind from ``direction`` (degrees), with room for grains (``room_for``).

        Sand of several sizes comes with its ``mixture``, a field with ``plants`` with their hold on the wind.
        """
        from barchan.kernels.grains.surface import renew_mesh

        lattice = bed.lattice
        periodic_y, periodic_x = lattice.periodic
        self.rules, self.lattice, self.plants = rules, lattice, plants
        self.direction, self.frame = direction, WindFrame.of(direction)
        self.grid = Grid(*lattice.shape, periodic_x, periodic_y)
        one = 1 << FRACTION_BITS
        self.scale = Scale(one, lattice.thickness / one, lattice.cell_size, rules.carried)
        self.repose = repose_rule(one, repose_limits(rules.repose_angle, lattice))
        self.filter = _filter(rules, lattice, one)
        self.sequences = relaxation_orders(True)
        level = _levels(bed, one)
        height = (level * self.scale.part).astype(np.float32)
        lid = height if rules.shelter_angle is None else height.copy()
        top, base = np.zeros((2, lattice.cells), np.float32)
        stale = np.zeros(lattice.shape[0], np.uint8)
        self.arrays = Ground(bed.sand.reshape(-1), level, height, lid, top, base, stale, mixture)
        if plants is not None:
            self.arrays = self.arrays._replace(lift=plants.lift, taken=np.zeros_like(plants.lift))
        renew_mesh(self.arrays, self.grid)
        self.queue = np.zeros(lattice.cells, np.int64)
        self.waiting = np.zeros(lattice.cells, np.uint8)
        sizes = 1 if mixture is None else len(mixture.layer)
        self.counts = np.zeros(COUNTS + sizes, np.int64)
        self.events, self.ejecta = room or room_for(0)

    def lost_speed(self) -> NDArray[np.float64]:
        """Speed (m/s) along the wind that impacts took since last asked: by cell, or a cell's mean."""
        if self.arrays.lost is None:
            lost = np.asarray(self.counts[LOST] / self.lattice.cells)
        else:
            lost = self.arrays.lost.reshape(self.lattice.shape).astype(np.float64)
            self.arrays.lost[:] = 0
        self.counts[LOST] = 0
        return lost / LOST_UNIT

    def slow(self, friction: NDArray[np.float64]) -> None:
        """Let the wind near the bed have a friction velocity (m/s) for each cell."""
        near = friction.reshape(-1).astype(np.float32)
        lost = np.zeros(near.size, np.int64) if self.arrays.lost is None else self.arrays.lost
        self.arrays = self.arrays._replace(near=near, lost=lost)

    def bend_wind(self, wind: WindOverWaves) -> None:
        """Let the wind follow the bed."""
        self.arrays = self.arrays._replace(
            rise=_flat(wind.rise), gain=_flat(wind.gain), aside=_flat(wind.aside)
        )

    def drag(self, near: NDArray[np.float64], wind: WindOverWaves) -> None:
        """Let the wind drag at the bed, with a friction velocity (m/s) ``near`` it, by cell or for all.

        It has no hold on the bed among plants.
        """
        cells, stress, aside = self.arrays.level.size, _flat(wind.stress), _flat(wind.side_stress)
        found = np.broadcast_to(near, self.lattice.shape).reshape(-1).astype(np.float32).astype(np.float64)
        if stress is not None:
            found *= np.sqrt(stress.astype(np.float64))
        if self.plants is not None:
            found[self.plants.lift > 0.0] = 0.0
        turn = np.zeros(cells) if stress is None or aside is None else aside.astype(np.float64) / stress
        self.arrays = self.arrays._replace(bed_wind=found, bed_turn=turn)

    def roughen(self, friction: float) -> None:
        """Let plants take their part from a wind of that friction velocity (m/s)."""
        if self.plants is not None:
            taken = friction / KARMAN * self.plants.logarithm
            self.arrays = self.arrays._replace(taken=taken.astype(np.float32))

    def scene(self, grains: Any, air: Any, rules: tuple[Any, Any], splash: Any) -> Any:
        """All that takes part in an iteration, as the kernels take it."""
        about = grains, air, self.grid, self.arrays, self.scale, rules, splash
        return Scene(*about, self.events, self.ejecta, self.counts)

    def shuffle_anew(self, key: int) -> None:
        """Start the draws of sizes anew under a key."""
        if self.arrays.mixture is not None:
            shuffle_anew(self.arrays.mixture, key)

    @property
    def left_by_size(self) -> NDArray[np.int64]:
        """Parcels of each size that left the field in this step."""
        return self.counts[COUNTS:] * self.rules.carried

    def spread_lid(self) -> None:
        """Find the sheltered air anew."""
        if self.rules.shelter_angle is None:
            return
        from barchan.kernels.grains.shelter import spread_lid
        from barchan.kernels.grains.surface import renew_mesh

        frame, shape = self.frame, self.lattice.shape
        lid = np.array(frame.enter(self.arrays.height.reshape(shape)).T, order="C")
        across, along = self.lattice.periodic
        if frame.crossed:
            across, along = along, across
        offset = -math.tan(frame.angle)
        row_step = math.floor(offset + 1e-9)
        fall = math.tan(math.radians(self.rules.shelter_angle)) * self.lattice.cell_size
        spread_lid(
            *(fall / math.cos(frame.angle), row_step, max(offset - row_step, 0.0), along, across, lid),
        )
        self.arrays.lid.reshape(shape)[...] = frame.leave(lid.T)
        renew_mesh(self.arrays, self.grid)

    def settle(self, key: int) -> None:
        """Relax slopes that are too steep."""
        self.shuffle_anew(derive(key, 0))
        from barchan.kernels.grains.exchange import settle_steep
        from barchan.kernels.grains.filter import smooth_slopes

        if self.rules.collapse == "filter":
            smooth_slopes(self.arrays, self.scale, self.grid, self.filter, self.queue, self.waiting)
            return
        settle_steep(
            *(self.arrays, self.scale, self.sequences, np.uint64(key), self.grid, self.repose),
            *(self.queue, self.waiting),
        )

    def settle_where(self, where: NDArray[np.bool_]) -> int:
        """Relax slopes about some cells until all hold; returns how many parcels slid."""
        from barchan.kernels.bed.relax import relax_field

        arrays = self.arrays
        stacks = Stacks(arrays.level, arrays.sand)
        orders, changed = self.sequences, where.copy()
        return int(relax_field(stacks, changed, orders, self.grid, self.repose, arrays.mixture))

    def tally(self, airborne: int) -> Tally:
        """What happened in a step, with so many parcels in the air at its end."""
        counts, carried = self.counts, self.rules.carried
        moved = int(counts[MOVED]) * carried
        return Tally(
            steps=1,
            polls=int(counts[FLOWN]),
            moved=moved,
            left=int(counts[LEFT]) * carried,
            airborne=airborne,
            capped=int(counts[CAPPED]) * carried,
            travel_x=int(counts[TRAVEL_X]) * carried / TRAVEL_UNIT,
            travel_y=int(counts[TRAVEL_Y]) * carried / TRAVEL_UNIT,
        )


def room_for(slots: int, sorted_by_size: bool = False) -> Any:
    """Room for the events and the ejecta of an iteration, for grains in some slots."""
    near, slot, rest, source, way_x, way_y = np.zeros((6, slots), np.int64)
    x, y = np.zeros((2, slots), np.float32)
    impact, u, v = np.zeros((3, slots))
    lost = np.zeros(slots, np.int64)
    kind = np.zeros(slots, np.int32) if sorted_by_size else None
    capped, start = np.zeros(slots, np.uint8), np.zeros(slots, np.uint64)
    events = Events(near, slot, rest, source, way_x, way_y, capped, impact, x, y, u, v, lost, start, kind)
    return events, Ejecta(*np.zeros((5, slots), np.int64), *np.zeros((3, slots)))


def _flat(part: NDArray[np.float64] | None) -> NDArray[np.float32] | None:
    return None if part is None else part.reshape(-1).astype(np.float32)


def _levels(bed: Bed, one: int) -> NDArray[np.int64]:
    """Elevation of the surface over the lowest ground, in parts of a parcel."""
    ground = (bed.ground - bed.ground.min()) / bed.lattice.thickness * one
    return (np.rint(ground).astype(np.int64) + bed.sand.astype(np.int64) * one).reshape(-1)


def _filter(rules: GrainFlight, lattice: Lattice, one: int) -> Any:

    least = math.tan(math.radians(rules.repose_angle)) / rules.filter_scale / lattice.aspect
    return Filter(rules.filter_gain, least * one)
