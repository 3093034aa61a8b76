"""What all models of grains in flight share: the grains in the air, their iterations, the bed they meet."""

from abc import abstractmethod
from collections.abc import Hashable
from functools import cached_property, partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.wall import unstable_wind
from barchan.bed import Bed
from barchan.directions import downwind
from barchan.errors import ScenarioError
from barchan.grains import checks as grain_checks
from barchan.grains.air import HEIGHTS, SQUARED_SPEEDS, table
from barchan.grains.bed import GrainGround, repose_limits, room_for
from barchan.grains.canopy import PAINTED, PLANT_HEIGHT, PLANT_SHARE, PLANTS, hold, planted
from barchan.grains.iterations import shared_scene, spells
from barchan.grains.parameters import GrainFlight
from barchan.grains.pool import close_gaps, free_slots, grains_in
from barchan.grains.sizes import SortedSand
from barchan.kernels.grains.state import Air
from barchan.lattice import Lattice
from barchan.model import Model, Tally
from barchan.streams import Stream, derive
from barchan.wind.segment import Segment

_ANY = 270.0
"""A wind direction where none matters."""

_CALM = 1e-9
"""Components of the wind's direction below this are zero: their squares would be too small to be fast."""


class GrainModel(Model):
    """A model that follows grains through the air, each standing for the parcel that it takes along."""

    counts = "grain updates"
    Parameters = GrainFlight
    parameters: GrainFlight

    def __init__(self, parameters: Any, lattice: Lattice) -> None:
        """Set the model up with no grain in the air."""
        super().__init__(parameters, lattice)
        self.slots = max(1, round(parameters.load * lattice.cells))
        self.sizes = self.sorted_sand()
        if self.sizes is not None:
            self.fields = (*self.fields, *self.sizes.layer, *self.sizes.below)
        if parameters.plants:
            self.fields = (*self.fields, PLANT_HEIGHT)
            self.derived = (*self.derived, PLANT_SHARE)
            self.overlays = (*self.overlays, PLANTS)
        self.iteration = 0
        self.slots_in_use = self.slots

    @cached_property
    def _flight(self) -> tuple[NDArray[np.float32], NDArray[np.int32]]:
        """Motion and marks, made when they are needed: a scenario may be looked at that no memory holds."""
        return free_slots(self.slots)

    @property
    def motion(self) -> NDArray[np.float32]:
        """Where the grain in each slot is, and how fast."""
        return self._flight[0]

    @property
    def marks(self) -> NDArray[np.int32]:
        """What each slot holds."""
        return self._flight[1]

    @cached_property
    def kinds(self) -> NDArray[np.int32] | None:
        """The size of the grain in each slot, where there are several."""
        return None if self.sizes is None else np.zeros(self.slots, np.int32)

    def prepare(self, bed: Bed, seed: int) -> None:
        """Look whether grains can fly here; raises ScenarioError with everything that keeps them from it."""
        found = grain_checks.problems(self.parameters, bed, self.fastest())
        if found:
            raise ScenarioError(found)
        if self.sizes is not None:
            self.sizes.lay(bed, seed)
        if self.parameters.plants:
            bed.add(PLANT_HEIGHT, planted(self.parameters.plants, self.lattice))

    def paintable(self) -> dict[str, tuple[float, float]]:
        """The height of plants, where the scenario has any."""
        tallest = [stand.height for stand in self.parameters.plants]
        return {PLANT_HEIGHT.name: (0.0, max(PAINTED, *tallest))} if tallest else {}

    def sorted_sand(self) -> SortedSand | None:
        """Sand of several sizes; None: it is all alike."""
        return None

    def fastest(self) -> float:
        """The greatest upward speed (m/s) at which the wind itself lifts grains."""
        return 2.0 * self.parameters.friction_velocity(self.parameters.wind_speed)

    @property
    def step_seconds(self) -> float | None:
        """Duration of a step (s), where iterations are the clock."""
        return self.parameters.step_seconds

    def facts(self) -> dict[str, str]:
        """What a parcel is, how the wind compares with the threshold, how grains fall, how long a step is."""
        return grain_checks.facts(self.parameters, self.lattice)

    def remarks(self, hop_length: float | None, direction: float) -> list[str]:
        """A wind that moves nothing; parcels unlike those of the sources."""
        return grain_checks.remarks(self.parameters, self.lattice)

    def state(self) -> dict[str, NDArray | float | int | str]:
        """The grains in the air and how many iterations are done."""
        by_size: dict[str, NDArray] = {}
        if self.sizes is not None and self.kinds is not None:
            by_size = {"kinds": self.kinds, "left_by_size": self.sizes.left}
        return {"motion": self.motion, "marks": self.marks, "iteration": self.iteration, **by_size}

    def restore(self, state: dict[str, Any]) -> None:
        """Take up grains in the air."""
        self.motion[...] = state["motion"]
        self.marks[...] = state["marks"]
        self.iteration = int(state["iteration"])
        self.slots_in_use = self.slots
        if self.sizes is not None and self.kinds is not None:
            self.kinds[...] = state["kinds"]
            self.sizes.left[...] = state["left_by_size"]

    @property
    def airborne(self) -> int:
        """Parcels in the air."""
        return self.flying * self.parameters.carried

    @property
    def flying(self) -> int:
        """Simulated grains in the air."""
        return int(np.count_nonzero(self.marks[0, : self.slots_in_use]))

    @abstractmethod
    def bounce(self) -> Any:
        """How grains bounce."""

    @abstractmethod
    def lift_off(self, wind: Segment, chance: float = 1.0) -> Any:
        """How free slots lift parcels, each with a ``chance`` in an iteration."""

    @property
    def wind_every(self) -> int:
        """Iterations after which the wind is found anew, within a step; here it blows as it is."""
        return self.parameters.iterations_per_step

    def feel(self, ground: GrainGround, seconds: float) -> None:
        """Take note of the speed that impacts took from grains in some seconds."""

    def blow(self, ground: GrainGround, wind: Segment) -> Any:
        """What the air does to grains over the ground as it is now."""
        ground.roughen(self.parameters.friction_velocity(self.speed(wind)))
        return self.air(wind)

    @property
    def spare_slots(self) -> int:
        """Free slots to keep in flight for grains that start within a step; all where not given."""
        return self.slots

    def _choose_slots(self) -> None:
        """Leave free slots but the spare ones out of flight; grains move up where too many lie between."""
        used, spare = self.slots_in_use, self.spare_slots
        if spare >= self.slots:
            self.slots_in_use = self.slots
            return
        kinds = () if self.kinds is None else (self.kinds,)
        last = close_gaps((*self.motion, *self.marks, *kinds), self.marks[0, :used] != 0, spare)
        self.slots_in_use = min(last + spare, self.slots)

    def splash(self, wind: Segment) -> Any:
        """What impacts throw out; None: nothing, grains bounce."""
        return None

    def advance(self, bed: Bed, segment: Segment, stream: Stream) -> Tally:
        """Let the grains in the air fly, land and be replaced."""
        total = Tally(airborne=self.airborne)
        ground = self.ground_of(bed, segment.direction, self._room)
        grains = self.grains()
        for _ in range(segment.steps):
            ground.counts[:] = 0
            self._step(segment, stream, grains, ground)
            total.add(ground.tally(self.airborne))
            if self.sizes is not None:
                self.sizes.left += ground.left_by_size
        self._store(bed, ground)
        return total

    @cached_property
    def _room(self) -> Any:
        """Room for what becomes of grains in an iteration, made once: new memory is slow at first."""
        return room_for(self.slots, self.sizes is not None)

    def ground_of(self, bed: Bed, direction: float, room: Any = None) -> GrainGround:
        """A bed under a wind from ``direction`` (degrees), with room for what becomes of grains."""
        mixture = None if self.sizes is None else self.sizes.mixture(bed)
        rules = self.parameters
        plants = hold(rules, bed.arrays[PLANT_HEIGHT.name], self.lattice) if rules.plants else None
        return GrainGround(rules, bed, direction, room, mixture, plants)

    def _store(self, bed: Bed, ground: GrainGround) -> None:
        if self.sizes is not None:
            self.sizes.store(bed, ground.arrays.mixture)

    def _step(self, wind: Segment, stream: Stream, grains: Any, ground: GrainGround) -> None:
        rules = self.parameters
        if rules.clock == "step":
            ground.spread_lid()
            self._follow(derive(stream.key, self.iteration), grains, self.blow(ground, wind), ground, wind)
            self.iteration += 1
            return
        iterations = round(wind.share * rules.iterations_per_step)
        for first in range(0, iterations, self.wind_every):
            air = self.blow(ground, wind)
            self._choose_slots()
            count = min(self.wind_every, iterations - first)
            self._fly(first, count, stream, ground.scene(grains, air, *self._rules(wind)), ground)
            self.feel(ground, count * rules.time_step)
        ground.settle(derive(stream.key, self.iteration))

    def _fly(self, first: int, count: int, stream: Stream, scene: Any, ground: GrainGround) -> None:
        """Let grains fly for iterations of a step, in a wind that blows as it is."""
        rules = self.parameters
        with shared_scene(scene, stream.key, self.slots_in_use, self.iteration) as fly_until:
            for number, some in spells(first, first + count, rules.shelter_every, rules.collapse_every):
                if number % rules.shelter_every == 0:
                    ground.spread_lid()
                if number and number % rules.collapse_every == 0:
                    ground.settle(derive(stream.key, self.iteration))
                self.iteration += some
                fly_until(self.iteration)

    def _rules(self, wind: Segment) -> tuple[Any, Any]:
        """How grains bounce and are lifted, and what impacts throw out, under a wind."""
        return (self.bounce(), self.lift_off(wind)), self.splash(wind)

    def _follow(self, key: int, grains: Any, air: Any, ground: GrainGround, wind: Segment) -> None:
        """As many grains as the field has cells fly from lift-off to rest, one after the other."""
        from barchan.kernels.grains.trajectories import trajectories

        ground.shuffle_anew(derive(key, self.lattice.cells))
        rules = self.lift_off(wind), (self.bounce(), self.lift_off(wind, 0.0))
        slopes = ground.sequences, ground.repose, ground.queue, ground.waiting
        trajectories(
            *(self.lattice.cells, np.uint64(key), grains, air, ground.arrays, ground.scale, ground.grid),
            *(rules, self.splash(wind), slopes, ground.events, ground.counts),
        )

    def grains(self) -> Any:
        """The grains as the kernels take them."""
        return grains_in(self.motion, self.marks, self.kinds)

    def paths(
        self, bed: Bed, wind: Segment, stream: Stream, count: int, longest: float = 10.0
    ) -> list[NDArray[np.float64]]:
        """The paths of ``count`` grains, each for ``longest`` seconds at most; see ``grain_paths.follow``."""
        from barchan.grains.trajectories import follow

        return follow(self, bed, wind, stream, count, longest)

    def speed(self, wind: Segment | None) -> float:
        """Speed of the wind (m/s at 10 m); a calm has none."""
        if wind is not None and wind.polls == 0:
            return 0.0
        if wind is None or wind.speed is None:
            return self.parameters.wind_speed
        return wind.speed

    def wind_profile(self, height: NDArray[np.float64], friction: float) -> NDArray[np.float64]:
        """Wind speed (m/s) at heights (m) above the surface, of a wind with this friction velocity (m/s)."""
        rules = self.parameters
        return unstable_wind(height, friction, rules.roughness_length, rules.displacement, rules.stability)

    def wind_tables(self, friction: float) -> tuple[Any, Any]:
        """The wind by height over the surface as the kernels take it, and nothing to come to it."""
        return table(lambda height: self.wind_profile(height, friction), HEIGHTS), None

    def air(self, wind: Segment) -> Any:
        """What the air does to grains in one time step."""
        rules = self.parameters
        friction = rules.friction_velocity(self.speed(wind))
        x, y = (0.0 if abs(part) < _CALM else part for part in downwind(wind.direction))
        step = rules.time_step
        late = 1.0 if rules.scheme == "euler" else 0.5
        early = 1.0 - late
        fall = rules.gravity * step
        numbers = (x, y, fall, fall * early)
        moves = [share * step for share in (early, late)]
        profile, above = self.wind_tables(friction)
        lengths = [move / self.lattice.cell_size for move in moves]
        found: tuple[Any, ...] = tuple(np.float32(number) for number in (*numbers, *lengths, *moves))
        return Air(profile, self._drag_table, *found)._replace(above=above)

    def change(self, parameters: Any) -> None:
        """Take new parameters from now on; state is kept."""
        super().change(parameters)
        self.__dict__.pop("_drag_table", None)

    @cached_property
    def _drag_table(self) -> Any:
        """The share of a velocity difference that drag takes away in a time step, for each size."""
        tables = [table(partial(_drag_at, one), SQUARED_SPEEDS) for one in self.parameters.by_size]
        if self.sizes is None:
            return tables[0]
        return tables[0]._replace(values=np.concatenate([one.values for one in tables]))

    def moves(self, wind: Segment | None = None) -> bool:
        """Whether the wind is above the threshold."""
        return self.parameters.friction_velocity(self.speed(wind)) > self.parameters.threshold()

    def settle(self, bed: Bed, where: NDArray[np.bool_] | None = None) -> int:
        """Relax slopes to the angle of repose."""
        ground = self.ground_of(bed, _ANY)
        slid = ground.settle_where(np.ones(bed.sand.size, np.bool_) if where is None else where.ravel())
        self._store(bed, ground)
        return slid

    def slope_limits(self) -> dict[str, tuple[int, ...]]:
        """The steps (parcels) that stand towards faces and corners; the filter holds none."""
        if self.parameters.collapse == "filter":
            return {}
        return {"sand": repose_limits(self.parameters.repose_angle, self.lattice)}

    def slope_rules(self) -> Hashable:
        """The angle of repose."""
        return self.parameters.repose_angle


def _drag_at(rules: GrainFlight, squared: NDArray[np.float64]) -> NDArray[np.float64]:
    return rules.drag_share(np.sqrt(squared))
