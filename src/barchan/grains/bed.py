"""The bed as grains meet it, for the time of one call: its arrays, counts, shelter and slopes."""

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.flow_over_relief import ReliefWind
from barchan.bed import Bed
from barchan.grains.canopy import PlantRoughness
from barchan.grains.collapse import filter_of, slopes_of
from barchan.grains.parameters import GrainFlight
from barchan.grains.pool import work_space
from barchan.grains.shelter import Shelter
from barchan.grains.sized_sand import reseed
from barchan.heights import FRACTION_BITS
from barchan.kernels.bed.state import ActiveLayer, Grid, Stacks
from barchan.kernels.core.state import TRAVEL_UNIT
from barchan.kernels.grains.air_state import BedStress, Feedback, Flow, Speedup
from barchan.kernels.grains.state import (
    CAPPED,
    COUNTS,
    FLOWN,
    LEFT,
    LOSS,
    LOSS_UNIT,
    MOVED,
    TRAVEL_X,
    TRAVEL_Y,
    Bonds,
    Ejecta,
    Ground,
    Landings,
    Scale,
)
from barchan.model import Tally
from barchan.streams import derive
from barchan.wind.frame import WindFrame

PARCEL = 1 << FRACTION_BITS
"""Parts of a parcel in a level."""


class GrainGround:
    """A bed with the arrays that the kernels need beside it. Changes the bed's sand in place."""

    def __init__(
        self,
        rules: GrainFlight,
        bed: Bed,
        direction: float = 270.0,
        work: tuple[Landings, Ejecta] | None = None,
        layer: ActiveLayer | None = None,
        plants: PlantRoughness | None = None,
        bonds: Bonds | None = None,
    ) -> None:
        """Take a bed under a wind from ``direction`` (degrees), with ``work`` space for a pool of grains.

        Sand of several sizes comes with its active ``layer``, a field with ``plants`` with their roughness,
        snow that bonds with its ``bonds``.
        """
        from barchan.kernels.grains.surface import renew_mesh

        self.rules, self.lattice, self.plants = rules, bed.lattice, plants
        self.direction, self.frame = direction, WindFrame.of(direction)
        self.slopes = slopes_of(rules, bed.lattice, PARCEL)
        self.filter = filter_of(rules, bed.lattice, PARCEL)
        self.arrays = _ground_of(rules, bed, layer)._replace(bonds=bonds)
        self.roughen(0.0)
        renew_mesh(self.arrays)
        self.counts = np.zeros(COUNTS + (1 if layer is None else len(layer.surface)), np.int64)
        self.landings, self.ejecta = work or work_space(0)

    def momentum_loss(self) -> NDArray[np.float64]:
        """Speed (m/s) along the wind that impacts took since the last call: by cell, or a cell's mean."""
        if self.arrays.feedback is None:
            loss = np.asarray(self.counts[LOSS] / self.lattice.cells)
        else:
            by_cell = self.arrays.feedback.momentum_loss
            loss = by_cell.reshape(self.lattice.shape).astype(np.float64)
            by_cell[:] = 0
        self.counts[LOSS] = 0
        return loss / LOSS_UNIT

    def slow(self, ustar: NDArray[np.float64]) -> None:
        """Set the near-bed friction velocity (m/s) of each cell."""
        before = self.arrays.feedback
        loss = np.zeros(ustar.size, np.int64) if before is None else before.momentum_loss
        feedback = Feedback(ustar.reshape(-1).astype(np.float32), loss)
        self.arrays = self.arrays._replace(feedback=feedback)

    def bend_wind(self, wind: ReliefWind) -> None:
        """Let the wind follow the bed."""
        if wind.streamline_slope is None:
            return
        speedup = None
        if wind.speedup is not None and wind.crosswind_ratio is not None:
            speedup = Speedup(_flat(wind.speedup), _flat(wind.crosswind_ratio))
        self.arrays = self.arrays._replace(flow=Flow(_flat(wind.streamline_slope), speedup))

    def drag(self, near_bed: NDArray[np.float64], wind: ReliefWind) -> None:
        """Set the stress on the bed of a wind with a near-bed friction velocity (m/s), by cell or for all.

        Plants keep the wind off the bed.
        """
        whole = np.broadcast_to(near_bed, self.lattice.shape).reshape(-1)
        ustar = whole.astype(np.float32).astype(np.float64)
        deflection = np.zeros(ustar.size)
        if wind.stress is not None:
            stress = _flat(wind.stress).astype(np.float64)
            ustar *= np.sqrt(stress)
            if wind.crosswind_stress is not None:
                deflection = _flat(wind.crosswind_stress).astype(np.float64) / stress
        if self.plants is not None:
            ustar[self.plants.displacement_height > 0.0] = 0.0
        self.arrays = self.arrays._replace(bed_stress=BedStress(ustar, deflection))

    def roughen(self, ustar: float) -> None:
        """Set the drag of plants on a wind of a friction velocity (m/s)."""
        if self.plants is not None:
            self.arrays = self.arrays._replace(canopy=self.plants.drag(ustar))

    def loosen(self, yields: bool) -> None:
        """Set whether the wind is strong enough to lift bonded snow."""
        if self.arrays.bonds is not None:
            self.arrays = self.arrays._replace(bonds=self.arrays.bonds._replace(yields=yields))

    def reseed(self, key: int) -> None:
        """Restart the random sequence of sizes under a key."""
        if self.arrays.active_layer is not None:
            reseed(self.arrays.active_layer, key)

    @property
    def left_by_size(self) -> NDArray[np.int64]:
        """Parcels of each size class that left the field in this step."""
        return self.counts[COUNTS:] * self.rules.carried

    def raise_shelter(self) -> None:
        """Recompute the sheltered air."""
        from barchan.kernels.grains.surface import renew_mesh

        shelter = self.rules.part(Shelter)
        if shelter is not None and shelter.angle is not None:
            shelter.raise_over(self.arrays, self.lattice, self.frame)
            renew_mesh(self.arrays)

    def relax(self, key: int) -> None:
        """Relax slopes that are too steep."""
        from barchan.kernels.grains.collapse import settle_steep
        from barchan.kernels.grains.filter import smooth_slopes

        self.reseed(derive(key, 0))
        if self.rules.collapse == "filter":
            unstable = self.slopes.unstable
            smooth_slopes(self.arrays, self.filter, unstable.queue, unstable.waiting)
        else:
            settle_steep(self.arrays, self.slopes, np.uint64(key))

    def relax_where(self, where: NDArray[np.bool_]) -> int:
        """Relax slopes about some cells until all hold; returns the number of parcels that slid."""
        from barchan.kernels.bed.loose import join, part_loose
        from barchan.kernels.bed.relax import relax_field

        ground, slopes, changed = self.arrays, self.slopes, where.copy()
        loose = None if ground.bonds is None else ground.bonds.loose
        free = part_loose(loose, ground.sand)
        stacks = Stacks(ground.level, free, loose=loose)
        slid = relax_field(stacks, changed, slopes.orders, ground.grid, slopes.repose, ground.active_layer)
        join(loose, free, ground.sand)
        return int(slid)

    def tally(self, airborne: int) -> Tally:
        """The tally of a step, with a number of parcels in the air at its end."""
        counts, carried = self.counts, self.rules.carried
        return Tally(
            steps=1,
            polls=int(counts[FLOWN]),
            moved=int(counts[MOVED]) * carried,
            left=int(counts[LEFT]) * carried,
            airborne=airborne,
            capped=int(counts[CAPPED]) * carried,
            travel_x=int(counts[TRAVEL_X]) * carried / TRAVEL_UNIT,
            travel_y=int(counts[TRAVEL_Y]) * carried / TRAVEL_UNIT,
        )


def _flat(part: NDArray[np.float64]) -> NDArray[np.float32]:
    return part.reshape(-1).astype(np.float32)


def _ground_of(rules: GrainFlight, bed: Bed, layer: ActiveLayer | None) -> Ground:
    """A bed as kernels take it; the mesh is to be computed."""
    lattice = bed.lattice
    periodic_y, periodic_x = lattice.periodic
    scale = Scale(PARCEL, lattice.thickness / PARCEL, lattice.cell_size, rules.carried)
    over_lowest = (bed.ground - bed.ground.min()) / lattice.thickness * PARCEL
    level = (np.rint(over_lowest).astype(np.int64) + bed.sand.astype(np.int64) * PARCEL).reshape(-1)
    height = (level * scale.part).astype(np.float32)
    shelter = rules.part(Shelter)
    calm = shelter is not None and shelter.angle is not None
    top, base = np.zeros((2, lattice.cells), np.float32)
    return Ground(
        sand=bed.sand.reshape(-1),
        level=level,
        height=height,
        shelter_surface=height.copy() if calm else height,
        top=top,
        base=base,
        stale=np.zeros(lattice.shape[0], np.uint8),
        grid=Grid(*lattice.shape, periodic_x, periodic_y),
        scale=scale,
        active_layer=layer,
    )
