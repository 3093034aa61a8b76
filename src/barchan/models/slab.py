"""What all slab models share: one transport kernel, told by data."""

from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Bed
from barchan.models.base import Model, Tally
from barchan.models.slab_parameters import SlabTransport
from barchan.models.slab_tables import FRACTION_BITS, SlabTables, build
from barchan.models.wind_frame import WindFrame
from barchan.streams import Stream
from barchan.wind.segment import Segment


class SlabModel(Model):
    """A model that moves slabs of sand one at a time (Werner 1995 and its descendants)."""

    Parameters = SlabTransport
    parameters: SlabTransport

    def advance(self, bed: Bed, segment: Segment, stream: Stream, still: int, limit: int) -> Tally:
        """Poll the cells and let the wind carry what they give."""
        from barchan.kernels import transport as kernel
        from barchan.kernels.polling import Schedule, work_space

        frame = WindFrame.of(segment.direction)
        tables, surface, sand = self._enter(bed, frame, self.hop_length(segment))
        schedule = Schedule(
            self.parameters.polling == "non_repeated",
            self.parameters.forced_erosion,
            self.parameters.band_rows,
            limit,
        )
        counts = np.zeros(kernel.TALLY_SIZE, np.int64)
        counts[kernel.STILL] = still
        kernel.transport(
            *(surface, sand, tables.turns.copy(), tables.grid, tables.wind, tables.repose),
            *(tables.axis, tables.ray),
            *(work_space(tables.grid.rows, tables.grid.cols, schedule), schedule),
            *(np.uint64(stream.key), segment.step, segment.steps, segment.first, segment.polls, counts),
        )
        self._leave(bed, frame, surface if sand is None else sand)
        unit = kernel.TRAVEL_UNIT
        travel = counts[kernel.TRAVEL_ALONG] / unit, counts[kernel.TRAVEL_ACROSS] / unit
        travel_x, travel_y = frame.to_map(*travel)
        steps = int(counts[kernel.SLICES])
        return Tally(
            steps=steps,
            polls=steps * segment.polls,
            moved=int(counts[kernel.MOVED]),
            left=int(counts[kernel.LEFT]),
            capped=int(counts[kernel.CAPPED]),
            travel_x=float(travel_x),
            travel_y=float(travel_y),
            exhausted=int(counts[kernel.EXHAUSTED]),
            still=int(counts[kernel.STILL]),
        )

    def hop_length(self, segment: Segment) -> float:
        """Hop length (cells) under this wind."""
        if segment.hop_length is not None:
            return segment.hop_length
        return self.parameters.hop_length

    def slope_limits(self) -> tuple[int, ...]:
        """The repose limits (slabs) towards faces and corners."""
        face = self.parameters.face_limit(self.lattice)
        if self.parameters.neighbourhood == "von_neumann":
            return (face,)
        return face, self.parameters.corner_step_limit(self.lattice)

    def settle(self, bed: Bed, where: NDArray[np.bool_] | None = None) -> int:
        """Relax slopes to the repose limits."""
        from barchan.kernels.settle import settle_field, settling_turns

        frame = WindFrame(0, 0.0)
        tables, surface, sand = self._enter(bed, frame, self.parameters.hop_length)
        turns = settling_turns(self.parameters.neighbourhood == "moore")
        upset = np.ones(bed.sand.size, np.bool_) if where is None else where.ravel().copy()
        moved = int(settle_field(surface, sand, upset, turns, tables.grid, tables.repose))
        self._leave(bed, frame, surface if sand is None else sand)
        return moved

    def shadow_zone(self, bed: Bed, direction: float) -> NDArray[np.bool_]:
        """Which cells lie in shadow of a wind from ``direction`` (degrees)."""
        from barchan.kernels.shadow import shadow_zone

        frame = WindFrame.of(direction)
        tables, surface, _ = self._enter(bed, frame, self.parameters.hop_length)
        zone = np.zeros(self.lattice.cells, np.bool_)
        shadow_zone(surface, tables.grid, tables.axis, tables.ray, zone)
        return frame.leave(zone.reshape(tables.grid.rows, tables.grid.cols)).copy()

    def facts(self) -> dict[str, str]:
        """The angles of repose that whole slabs really hold."""
        face, corner = self.parameters.effective_angles(self.lattice)
        steps = f"{self.parameters.face_limit(self.lattice)} slabs"
        facts = {"effective repose angle": f"{face:.1f}° towards faces ({steps})"}
        if corner is not None:
            steps = f"{self.parameters.corner_step_limit(self.lattice)} slabs"
            facts["effective repose angle"] += f", {corner:.1f}° towards corners ({steps})"
        return facts

    def remarks(self, hop_length: float | None, direction: float) -> list[str]:
        """Warn of hops that the field's edges dominate."""
        hop = self.parameters.hop_length if hop_length is None else hop_length
        frame = WindFrame.of(direction)
        along = self.lattice.rows if frame.crossed else self.lattice.columns
        if hop > along / 2:
            text = f"hop length {hop:g} cells is longer than half the field along the wind ({along} cells)"
            return [f"{text}: the field's edges will dominate"]
        return []

    def _enter(
        self, bed: Bed, frame: WindFrame, hop: float
    ) -> tuple[SlabTables, NDArray, NDArray[np.int32] | None]:
        """Tables, surface and sand (None over flat ground) in the wind's frame, flat, with room before."""
        flat = bool((bed.ground == bed.ground.flat[0]).all())
        tables = _tables(self.parameters, self.lattice, frame, hop, flat)
        sand = frame.enter(bed.sand)
        if flat:
            return tables, _with_room(sand, np.int32), None
        units = np.rint(frame.enter(bed.ground) / self.lattice.thickness * 2.0**FRACTION_BITS)
        surface = units.astype(np.int64) + (sand.astype(np.int64) << FRACTION_BITS)
        return tables, _with_room(surface, np.int64), np.ascontiguousarray(sand).ravel().copy()

    def _leave(self, bed: Bed, frame: WindFrame, sand: NDArray) -> None:
        rows, cols = frame.enter(bed.sand).shape
        bed.sand[...] = frame.leave(sand.reshape(rows, cols))


def _with_room(field: NDArray, dtype: Any) -> NDArray:
    """A flat copy of a field with as much memory before it as one vector read may touch."""
    from barchan.kernels.lanes import LANES

    buffer = np.zeros(LANES + field.size, dtype)
    buffer[LANES:] = field.ravel()
    return buffer[LANES:]


@lru_cache(maxsize=64)
def _tables(parameters: SlabTransport, lattice: Any, frame: WindFrame, hop: float, flat: bool) -> SlabTables:
    return build(parameters, lattice, frame, hop, flat)
