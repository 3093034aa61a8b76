"""What a model of snow does in a segment: it ages, lets snow fall and pack, and lets the wind drift it."""

import math
from collections.abc import Callable, Hashable
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.snow.density import GREATEST_DENSITY, LEAST_DENSITY
from barchan.bed import Bed
from barchan.kernels.slabs.state import ENTERED, TALLY_SIZE
from barchan.kernels.snow.state import DENSITY_UNIT, MOST_QUANTA, SnowRules
from barchan.lattice import Lattice
from barchan.model import Model, Tally
from barchan.slabs.tally import tally_of
from barchan.snow.clock import BondClock
from barchan.snow.conditions import Conditions, RelativeFlux, quantum_heights, step_seconds
from barchan.snow.drift_meter import DRIFTING, DriftMeter
from barchan.snow.impacts import IMPACTS, strike
from barchan.snow.pack import SNOW, STRESS, Field, field_of, fields_of, layer_of, leave
from barchan.snow.packing import INTERVAL, let_pack
from barchan.snow.parameters import SnowParameters
from barchan.snow.relief_stress import ReliefStress, stress_on
from barchan.snow.remarks import remarks_on
from barchan.snow.rules import rules_under
from barchan.snow.snowfall import Fallen
from barchan.snow.start import check_counts, lay_first_snow, quanta_in, start_density, start_problems
from barchan.snow.transport import Transport
from barchan.streams import Stream, derive
from barchan.wind.frame import WindFrame
from barchan.wind.segment import Segment


class SnowModel(Model):
    """A model that moves quanta of snow one at a time and keeps them in layers."""

    takes_influx = True
    takes_hops = False
    temperature_range = (-90.0, 5.0)
    material = "snow"
    fresh_densities = (LEAST_DENSITY, GREATEST_DENSITY)
    work_per_second = 1e7
    Parameters = SnowParameters
    parameters: SnowParameters

    def __init__(self, parameters: Any, lattice: Lattice) -> None:
        """Set the model up for a lattice."""
        super().__init__(parameters, lattice)
        self.layers = (layer_of(parameters),)
        self.fields = fields_of(parameters)
        self.clock = BondClock()
        self.fallen = Fallen()
        self.drift = DriftMeter()
        self._packed = 0
        self._stock = -1
        self._stress = ReliefStress()

    @property
    def unit_height(self) -> float:
        """Height (m) of a quantum of the snow of the start."""
        return self.parameters.quantum / start_density(self.parameters)

    @property
    def beneath(self) -> float:
        """Thickness (m) of the older layers."""
        old = self.parameters.beneath
        return sum(quanta_in(one, self.parameters) * self.parameters.quantum / one.density for one in old)

    def initialise(self, bed: Bed, seed: int) -> None:
        """Turn the quanta of the start into layers; raises ScenarioError where they cannot be counted."""
        check_counts(bed, self.parameters)
        lay_first_snow(bed, self.parameters, seed)

    def problems(self, _step_seconds: float | None) -> list[tuple[str, str]]:
        """Older layers that cannot be laid, and a reference wind that gives steps no duration."""
        found = start_problems(self.parameters)
        if self.step_seconds is None:
            wind = self.parameters.reference_wind
            text = f"is {wind:g} m/s, which moves no fresh drift; allowed: stronger winds"
            found.append(("reference_wind", text))
        return found

    def remarks(self, _hop_length: float | None, _direction: float) -> list[str]:
        """Wide cells, and bonds that grow within a step."""
        return remarks_on(self.parameters, self.lattice)

    def slope_rules(self) -> Hashable:
        """All that decides which slopes stand."""
        return self.parameters.repose, self.parameters.neighbourhood, self.parameters.bonding

    @property
    def step_seconds(self) -> float | None:
        """Duration of a step (s)."""
        seconds = step_seconds(self.parameters)
        return seconds if math.isfinite(seconds) else None

    @property
    def strength(self) -> Callable[[NDArray[np.float64]], NDArray[np.float64]]:
        """From winds (m/s at 10 m) to polls over those of a step: in proportion to saturated fluxes."""
        return RelativeFlux(self.parameters)

    def step_volume(self) -> float:
        """Volume (m² per step) of drift that goes through a line across the reference wind on the flat."""
        density = Conditions(
            self.parameters, self.parameters.reference_wind, self.parameters.temperature
        ).drift_density
        hops = self.parameters.hop / self.parameters.p_s
        return self.parameters.erosion_chance * hops * self.parameters.quantum / density

    def friction_velocity(self, wind: Segment) -> float:
        """Friction velocity (m/s) over flat snow, of the wind that ``conditions`` gives."""
        return self.parameters.drift.friction_velocity(self.conditions(wind).wind)

    def conditions(self, segment: Segment) -> Conditions:
        """Wind and temperature of a segment: of gusts the mean wind, weighted by what each moves."""
        wind = segment.speed if segment.driving_speed is None else segment.driving_speed
        if wind is None:
            wind = self.parameters.reference_wind if segment.polls else 0.0
        temperature = segment.weather.temperature
        if temperature is None:
            temperature = self.parameters.temperature
        return Conditions(self.parameters, wind, self.held_temperature(temperature))

    def advance(self, bed: Bed, segment: Segment, stream: Stream) -> Tally:
        """Let snow age, fall and pack, and the wind drift it, step by step."""
        now = self.conditions(segment)
        seconds = (segment.step_seconds or 0.0) * segment.share
        time, bonding = round(seconds * 1e6), round(seconds * 1e6 * now.rate)
        field = self._enter(bed, WindFrame.of(segment.direction))
        counts = np.zeros(TALLY_SIZE, np.int64)
        done = fallen = 0
        while done < segment.steps:
            rest = segment.part(done, segment.steps - done)
            steps = min(rest.steps, self._until_due(rest), self.clock.steps_to_next_epoch(bonding))
            part = rest.part(0, steps)
            if part.step % self.parameters.relief.every == 0 and part.step != self._stock:
                self._take_stock(field, now, stream)
                self._stock = part.step
            fallen += self._snow(field, part, now, seconds, counts)
            self._drift(bed, field, part, now, stream, counts)
            epoch = self.clock.epoch
            self.clock.pass_time(bonding, time, steps)
            if self.clock.epoch > epoch:
                self._strike(bed, field, part, now, stream)
            done += steps
        leave(bed, field.pack, field.ground, field.frame, self.clock.epoch)
        return replace(tally_of(counts, segment, field.frame), fallen=fallen)

    def _until_due(self, segment: Segment) -> int:
        """Steps until the stress is due, one by one where snow falls: work does not depend on cuts."""
        if segment.weather.snowfall:
            return 1
        every = self.parameters.relief.every
        return every - segment.step % every

    def _take_stock(self, field: Field, now: Conditions, stream: Stream) -> None:
        """Find the drift in the air over the last steps, ask for a new stress, and let the snow pack."""
        self.drift.take_stock()
        self._stress.expire()
        waited = self.clock.time - self._packed
        if self.parameters.packing.law != "none" and waited >= INTERVAL:
            let_pack(field.pack, field.ground, now, waited, derive(stream.key, -1 - self.clock.time))
            self._packed = self.clock.time
            cells = field.pack.quanta.size
            self._relax(field, self._rules(field, now), np.ones(cells, np.bool_))

    def stress(self, height: NDArray[np.float64], direction: float) -> NDArray[np.float64]:
        """Shear stress on a surface (m) over that on flat snow, for a wind from ``direction`` (degrees)."""
        return stress_on(height, self.lattice, direction, self.parameters)

    def _snow(
        self, field: Field, segment: Segment, now: Conditions, seconds: float, counts: NDArray[np.int64]
    ) -> int:
        """Let the snow of a step fall; returns how many quanta."""
        rate = segment.weather.snowfall
        if not rate:
            return 0
        from barchan.kernels.snow.layers import lay_quanta

        quanta = self.fallen.quanta(rate * seconds / self.parameters.quantum, self.lattice)
        density = self.parameters.snowfall.fresh_density(now.temperature, now.wind)
        if now.flux > 0.0 and self.drift.share > DRIFTING:
            density = now.drift_density
        rules = self._rules(field, now)
        fallen = int(quanta.sum())
        counts[ENTERED] += fallen
        laid = np.ascontiguousarray(field.frame.enter(quanta)).ravel()
        lay_quanta(field.pack, rules.tables.thickness, laid, rules.epoch, round(density * DENSITY_UNIT))
        self._relax(field, rules, laid > 0)
        return fallen

    def _drift(
        self, bed: Bed, field: Field, segment: Segment, now: Conditions, stream: Stream, counts: NDArray
    ) -> None:
        """Let the wind take, carry and lay down snow."""
        if segment.polls == 0 or now.flux == 0.0:
            return
        if self.parameters.relief.acts:
            self._stress.renew(bed, field, segment.direction, self.parameters)
        rules = self._rules(field, now, self._stress_on(bed, field))
        Transport(field, rules, now, self.lattice).run(segment, stream, counts, self.drift)

    def _strike(self, bed: Bed, field: Field, segment: Segment, now: Conditions, stream: Stream) -> None:
        """Let drift that is in the air break the bonds that grew in the epoch that has just ended."""
        bonding = self.parameters.bonding
        drifts = segment.polls > 0 and now.flux > 0.0 and self.drift.share > DRIFTING
        if not (drifts and bonding.grows and bonding.impact_mass > 0.0):
            return
        key = derive(derive(stream.key, -1 - self.clock.time), IMPACTS)
        rules = self._rules(field, now, self._stress_on(bed, field))
        strike(field.pack, rules, bonding.impact_mass / self.parameters.quantum, key)

    def _stress_on(self, bed: Bed, field: Field) -> NDArray[np.float32] | None:
        """Stress in the wind's frame, over that on flat snow, as it was last computed; None: uniform."""
        if not self.parameters.relief.acts:
            return None
        return np.ascontiguousarray(field.frame.enter(bed.arrays[STRESS])).ravel()

    def _rules(self, field: Field, now: Conditions, stress: NDArray[np.float32] | None = None) -> SnowRules:
        return rules_under(
            now, self.drift.share, self.lattice.cell_size, field.arguments.rules, self.clock.epoch, stress
        )

    def _enter(self, bed: Bed, frame: WindFrame) -> Field:
        return field_of(bed, self.parameters, self.lattice, frame)

    def _relax(self, field: Field, rules: SnowRules, where: NDArray[np.bool_]) -> int:
        from barchan.kernels.snow.slopes import relax_pack

        return relax_pack(field.pack, where, rules)

    def relax(self, bed: Bed, where: NDArray[np.bool_] | None = None) -> int:
        """Let slopes slide until all stand, once snow that was added or taken is part of the layers."""
        from barchan.kernels.snow.layers import lay_quanta

        now = Conditions(self.parameters, self.parameters.reference_wind, self.parameters.temperature)
        field = self._enter(bed, WindFrame(0, 0.0))
        rules = self._rules(field, now)
        painted = bed.arrays[SNOW].ravel() - field.pack.quanta
        if painted.any():
            lay_quanta(field.pack, rules.tables.thickness, painted, rules.epoch, rules.density)
        changed = np.ones(painted.size, np.bool_) if where is None else where.ravel().copy()
        moved = self._relax(field, rules, changed)
        leave(bed, field.pack, field.ground, field.frame, self.clock.epoch)
        return moved

    def lay_fresh(self, bed: Bed, quanta: NDArray[np.int64], density: float) -> None:
        """Lay quanta of fresh snow of a density (kg/m³) on each cell; where negative, take as many away."""
        from barchan.kernels.snow.layers import lay_quanta

        if (bed.arrays[SNOW] + quanta).max() > MOST_QUANTA:
            raise OverflowError("more quanta than a cell can count")
        field = self._enter(bed, WindFrame(0, 0.0))
        thickness = quantum_heights(self.parameters.quantum)
        counts = np.ascontiguousarray(quanta).ravel()
        lay_quanta(field.pack, thickness, counts, self.clock.epoch, round(density * DENSITY_UNIT))
        leave(bed, field.pack, field.ground, field.frame, self.clock.epoch)

    def state(self) -> dict[str, Any]:
        """The bond clock, snow short of a quantum, drift in the air, and when snow packed last."""
        own = {"packed": self._packed, "stock": self._stock}
        parts = (self.clock, self.fallen, self.drift, self._stress)
        return {key: value for part in parts for key, value in part.state().items()} | own

    def restore(self, state: dict[str, Any]) -> None:
        """Take up a remembered state."""
        for part in (self.clock, self.fallen, self.drift, self._stress):
            part.restore(state)
        self._packed, self._stock = int(state["packed"]), int(state["stock"])
