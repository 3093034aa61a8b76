"""The base class of slab models: one transport kernel, configured by data."""

from collections.abc import Hashable
from functools import partial
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Bed
from barchan.checked import checked, finite
from barchan.directions import downwind
from barchan.heights import check_heights
from barchan.kernels.bed.state import Stacks, relaxation_orders
from barchan.kernels.core.interruption import interruptible, new_interruption
from barchan.kernels.slabs.state import EdgeInflux, Schedule
from barchan.lattice import HEX_ROWS, Lattice
from barchan.model import Derived, Model, Tally
from barchan.slabs.arguments import SlabArguments, build, levels_over
from barchan.slabs.expected_flux import expected_flux
from barchan.slabs.influx import INFLUX, edge_influx, slabs_in
from barchan.slabs.obstacles import ClearDistances
from barchan.slabs.parameters import ActingRules, ShadowRule, SlabParameters
from barchan.slabs.rules import Rules
from barchan.slabs.stacks import is_flat, stacks_of, write_back
from barchan.slabs.tally import tally_of
from barchan.slabs.transport import Transport
from barchan.streams import Stream, derive
from barchan.wind.frame import WindFrame
from barchan.wind.segment import Segment
from barchan.words import counted

SHORT = 500_000
"""Hops that take so short that no signal need interrupt them: some tens of milliseconds."""

_CELL_BYTES = 24
"""Memory (bytes) that transport takes for each cell at most, over ground that is not flat."""


class SlabModel(Model):
    """A model that moves slabs of sand one at a time (Werner 1995 and its descendants)."""

    lattices: ClassVar[tuple[str, ...]] = ("square", "hex")
    takes_influx = True
    Parameters = SlabParameters
    parameters: SlabParameters
    derived: tuple[Derived, ...] = (
        Derived(
            "shadow",
            "1",
            "in shadow of the wind",
            lambda model, bed, wind: model.shadow_zone(bed, wind.direction),
        ),
        Derived(
            "flux",
            "m²/step",
            "expected flux of slabs from each cell",
            expected_flux,
            along_wind=True,
            least=0.0,
        ),
    )

    def __init__(self, parameters: Any, lattice: Lattice) -> None:
        """Set the model up for a lattice."""
        super().__init__(parameters, lattice)
        self._clear_distances = ClearDistances()

    def initialise(self, bed: Bed, seed: int) -> None:
        """Refuse a bed whose heights cannot be counted; raises ScenarioError."""
        self.check_bed(bed)

    def check_bed(self, bed: Bed) -> None:
        """Refuse a bed whose heights cannot be counted; raises ScenarioError."""
        check_heights(bed, self.rules().hop is not None)

    def rules(self) -> Rules:
        """The rules that the model adds to slab transport."""
        return Rules()

    def mobility(self, bed: Bed, direction: float) -> NDArray[np.float64] | None:
        """How freely the wind works on each cell: 1 unhindered, 0 not at all; None: 1 everywhere.

        The chance to give a slab is in proportion to it, and so is the chance to hop on after a landing.
        """
        return None

    def steps_until_update(self, segment: Segment) -> int:
        """How many steps the model may run before it looks at the bed again."""
        return segment.steps

    def after_steps(self, bed: Bed, segment: Segment) -> None:
        """Do what is due after some steps were run."""

    def finished(self, bed: Bed) -> str | None:
        """Why nothing more can happen on the bed, where the model knows that."""
        return None

    def advance(self, bed: Bed, segment: Segment, stream: Stream) -> Tally:
        """Poll the cells and let the wind carry what they give."""
        total = Tally()
        while total.steps < segment.steps and total.finished is None:
            rest = segment.part(total.steps, segment.steps - total.steps)
            part = rest.part(0, min(self.steps_until_update(rest), rest.steps))
            total.add(self._transport(bed, part, stream))
            self.after_steps(bed, part)
            total.finished = self.finished(bed)
        return total

    def _transport(self, bed: Bed, segment: Segment, stream: Stream) -> Tally:
        if segment.polls == 0:
            return Tally(steps=segment.steps)
        from barchan.kernels.core.threads import thread_count
        from barchan.kernels.slabs.influx import let_enter

        frame = self._frame(segment.direction)
        mobility = self.mobility(bed, segment.direction)
        hop = finite(self.hop_length(segment), f"hop length of {self.title}")
        arguments, stacks = self._enter(bed, frame, hop, mobility)
        rules = arguments.rules
        if rules.speedup:
            stacks = stacks._replace(levels=levels_over(flat=stacks.sand is None))
        obstacles = self._clear_distances.obstacles(bed.ground, rules, frame, stacks)
        interruption = new_interruption()
        rules = rules._replace(obstacles=obstacles, orders=rules.orders.copy(), interruption=interruption)
        schedule = Schedule(
            self.parameters.polling == "non_repeated",
            self.parameters.forced_erosion,
            self.parameters.band_rows,
        )
        threads = thread_count()
        transport = Transport(stacks=stacks, rules=rules, schedule=schedule, key=stream.key)
        influx = self._influx(segment, frame)

        def run() -> None:
            if influx is None:
                transport.run(segment, threads)
                return
            for step in range(segment.steps):
                part = segment.part(step, 1)
                key = np.uint64(derive(derive(derive(stream.key, part.step), INFLUX), part.first))
                let_enter(stacks, rules, transport.work(), influx, key, transport.counts)
                transport.run(part, threads)

        if self._hops_of(segment.steps * (segment.polls + slabs_in(influx))) > SHORT:
            interruptible(run, interruption)
        else:
            run()
        write_back(bed, frame, stacks)
        return tally_of(transport.counts, segment, frame, 1.0 / HEX_ROWS if self.lattice.hexagonal else 1.0)

    def _influx(self, segment: Segment, frame: WindFrame) -> EdgeInflux | None:
        return edge_influx(segment, partial(self.saturated_influx, segment), self.lattice, frame)

    def _hops_of(self, slabs: float) -> float:
        """How many hops so many slabs may take: a measure of how long that takes."""
        settles = min(self.parameters.p_s, self.parameters.p_ns)
        hops = self.parameters.max_hops if settles == 0.0 else 1.0 / settles
        return slabs * min(hops, self.parameters.max_hops)

    def expected_work(self, segment: Segment) -> float:
        """Its polls, and a poll for each slab that comes in across open edges."""
        influx = self._influx(segment, self._frame(segment.direction))
        return segment.steps * (segment.polls + slabs_in(influx))

    def hop_length(self, segment: Segment) -> float:
        """Hop length (cells) under this wind."""
        if segment.hop_length is not None:
            return segment.hop_length
        return self.parameters.hop_length

    def hops(self, bed: Bed, hop_length: float) -> NDArray[np.float64]:
        """Hop length (cells) from each cell, before it is rounded; negative: against the wind."""
        return np.full(self.lattice.shape, hop_length)

    def work_bytes(self) -> int:
        """Surface, sand, mobility, avalanches and distances to walls, some of them twice while they turn."""
        return _CELL_BYTES * self.lattice.cells

    def step_volume(self) -> float:
        """Volume (m² per step) that goes through a line across the wind on a flat bed of sand."""
        return self._carried(self.parameters.hop_length) * self.lattice.cell_size * self.lattice.thickness

    def saturated_influx(self, segment: Segment) -> float:
        """Slabs that cross a cell's width square to the wind in a step, on a flat bed of sand."""
        rows = self.lattice.cell_size / self.lattice.row_spacing
        return self._carried(self.hop_length(segment)) * segment.polls / self.lattice.cells * rows

    def _carried(self, hop_length: float) -> float:
        """Distance (cells) that a poll carries a slab on a flat bed of sand, on the average.

        Each poll finds sand and gives it with the chance of erosion; a slab hops 1 / ``p_s`` times on the
        average, fewer where ``max_hops`` ends that. Raises ValueError where that is no number.
        """
        erosion = self.rules().erosion
        given = min(max(erosion.factor + erosion.offset, 0.0), 1.0)
        if self.parameters.p_s == 0.0 or given == 0.0:
            reason = "p_s 0 keeps every slab in the air" if given else "no cell gives sand"
            raise ValueError(f"is given, but {reason}: a step of no known volume has no duration")
        ended = 1.0 - (1.0 - self.parameters.p_s) ** self.parameters.max_hops
        return given * hop_length * ended / self.parameters.p_s

    def slope_limits(self) -> dict[str, tuple[int, ...]]:
        """The repose limits (slabs) towards faces and corners, of bare cells and of stabilised ones."""
        angles = {"bare": self.parameters.static_repose_angle, "stabilised": self.rules().stabilised_angle}
        kinds = 2 if self.parameters.neighbourhood == "moore" and not self.lattice.hexagonal else 1
        return {
            cells: self.parameters.limits(self.lattice, angle)[:kinds]
            for cells, angle in angles.items()
            if cells == "bare" or angle is not None
        }

    def slope_rules(self) -> Hashable:
        """The limits, and the mobility up to which a cell is stabilised."""
        return tuple(self.slope_limits().items()), self.rules().stabilised_mobility

    def relax(self, bed: Bed, where: NDArray[np.bool_] | None = None) -> int:
        """Relax slopes to the repose limits."""
        from barchan.kernels.bed.relax import relax_field

        frame = WindFrame(0, 0.0)
        mobility = None if self.rules().stabilised_angle is None else self.mobility(bed, 270.0)
        arguments, stacks = self._enter(bed, frame, self.parameters.hop_length, mobility)
        rules = arguments.rules
        orders = relaxation_orders(self.parameters.neighbourhood == "moore", self.lattice.hexagonal)
        # the first ground is the same whatever the wind, and which neighbours it lets come first
        repose = rules.repose._replace(downslope=False)
        changed = np.ones(bed.sand.size, np.bool_) if where is None else where.ravel().copy()
        moved = relax_field(stacks, changed, orders, rules.grid, repose, None)
        write_back(bed, frame, stacks)
        return moved

    def shadow_zone(self, bed: Bed, direction: float) -> NDArray[np.bool_]:
        """Which cells lie in shadow of a wind from ``direction`` (degrees)."""
        from barchan.kernels.slabs.shadow import shadow_zone

        frame = self._frame(direction)
        arguments, stacks = self._enter(bed, frame, self.parameters.hop_length, None)
        rules = arguments.rules
        zone = np.zeros(self.lattice.cells, np.bool_)
        shadow_zone(stacks.surface, rules.grid, rules.axis, rules.ray, rules.box, zone)
        return frame.leave(zone.reshape(rules.grid.rows, rules.grid.cols)).copy()

    @property
    def acting(self) -> ActingRules:
        """The rules that act under the winds that blow now."""
        return self.parameters.acting(self.winds_off_axes)

    @property
    def shadow_rule(self) -> ShadowRule:
        """Where shadow lines start under the winds that blow now."""
        return self.acting.shadow

    def unsheltered(self, field: NDArray[np.float64], bed: Bed, direction: float) -> NDArray[np.float64]:
        """A field of the wind, 0 on cells that give nothing because they lie in shadow."""
        if self.parameters.lee_erosion:
            return field
        return np.where(self.shadow_zone(bed, direction), 0.0, field)

    def facts(self) -> dict[str, str]:
        """The shadow rule that acts, and the angles of repose that whole slabs really hold."""
        named = {
            "effective repose angle": self.parameters.repose_angle,
            "effective static repose angle": self.parameters.static_repose_angle,
            "effective repose angle of stabilised cells": self.rules().stabilised_angle,
        }
        angles = {name: self._angles(angle) for name, angle in named.items() if angle is not None}
        acting, order = self.acting
        shadow: str = acting
        if acting == "place" and self.parameters.stack_tops == "sloping":
            shadow = "place, over sloping tops"
        return {
            "shadow from": self._chosen(self.parameters.shadow_from, shadow),
            "neighbour order": self._chosen(self.parameters.neighbour_order, order),
            **angles,
        }

    def _chosen(self, stated: str, acting: str) -> str:
        """A rule that acts, with the reason where ``auto`` has chosen it."""
        if stated != "auto":
            return acting
        winds = "a wind blows off the lattice's axes" if self.winds_off_axes else "all winds blow along axes"
        return f"{acting} (auto: {winds})"

    def _angles(self, angle: float) -> str:
        face, corner = self.parameters.effective_angles(self.lattice, angle)
        face_limit, corner_limit = self.parameters.limits(self.lattice, angle)
        faces = "all six neighbours" if self.lattice.hexagonal else "faces"
        text = f"{face:.1f}° towards {faces} ({counted(face_limit, 'slab')})"
        corners = counted(corner_limit, "slab")
        return text if corner is None else f"{text}, {corner:.1f}° towards corners ({corners})"

    def remarks(self, hop_length: float | None, direction: float) -> list[str]:
        """Warn of hops that the field's edges dominate."""
        hop = self.parameters.hop_length if hop_length is None else hop_length
        x, y = downwind(direction)
        size = self.lattice.width if abs(x) >= abs(y) else self.lattice.height
        along = size / self.lattice.cell_size
        if hop > along / 2:
            text = (
                f"hop length {hop:g} cells is longer than half the field along the wind ({along:.4g} cells)"
            )
            return [f"{text}: the field's edges will dominate"]
        return []

    def wind_remarks(self) -> list[str]:
        """Warn of winds under which the lattice steers crests, where a rule avoids that."""
        if not self.winds_off_axes or self.shadow_rule == "place":
            return []
        text = f"with shadow_from {self.shadow_rule} the lattice turns crests under winds off its axes"
        most = 24 if self.lattice.hexagonal else 40
        return [f"{text}, in some models by up to {most}°; model.shadow_from place avoids it"]

    def _frame(self, direction: float) -> WindFrame:
        return WindFrame.of(direction, self.lattice.hexagonal)

    def _enter(
        self, bed: Bed, frame: WindFrame, hop: float, mobility: NDArray[np.float64] | None
    ) -> tuple[SlabArguments, Stacks]:
        """Arguments and stacks in the wind's frame."""
        if mobility is not None:
            mobility = checked(mobility, self.lattice.shape, np.float64, f"mobility of {self.title}")
        flat = is_flat(bed.ground)
        arguments = build(self.parameters, self.rules(), self.lattice, frame, hop, flat, self.acting)
        return arguments, stacks_of(bed, frame, mobility)
