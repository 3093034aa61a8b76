"""The engine of grains in flight: the grains in the air, their iterations, the bed they meet."""

from collections.abc import Hashable
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Bed
from barchan.errors import ScenarioError
from barchan.grains import checks
from barchan.grains.bed import GrainGround
from barchan.grains.canopy import PAINTED, PLANT_HEIGHT, PLANT_SHARE, PLANTS, Canopy, planted
from barchan.grains.closure import Closure
from barchan.grains.collapse import repose_limits
from barchan.grains.friction_over_relief import FRICTION_VELOCITY
from barchan.grains.parameters import GrainFlight
from barchan.grains.pool import SLOT_BYTES, Pool
from barchan.grains.rules import entrainment_of
from barchan.grains.sized_sand import SizedSand
from barchan.grains.sizes import Sizes
from barchan.grains.steps import follow_trajectories, iterate
from barchan.grains.wind_feedback import Feedback, WindFeedback
from barchan.grains.wind_over_bed import ANY_DIRECTION, WindOverGrains
from barchan.kernels.grains.air_state import Air
from barchan.kernels.grains.rules import Rules
from barchan.kernels.grains.state import Bonds, Ejecta, Landings, Scene
from barchan.lattice import Lattice
from barchan.model import Derived, Tally
from barchan.streams import Stream
from barchan.wind.segment import Segment

_CELL_BYTES = 120
"""Memory (bytes) that flight over a cell takes at most, with wind that varies in space."""


class GrainModel(WindOverGrains):
    """A model that follows grains through the air, each standing for the parcel that it takes along.

    A subclass names its ``closures`` and composes its parameters of them.
    """

    takes_hops = False
    work_unit = "grain updates"
    work_per_second = 6e7
    closures: ClassVar[tuple[type[Closure], ...]] = ()
    Parameters = GrainFlight
    parameters: GrainFlight
    derived: tuple[Derived, ...] = (FRICTION_VELOCITY,)

    def __init__(self, parameters: Any, lattice: Lattice) -> None:
        """Set the model up with no grain in the air."""
        super().__init__(parameters, lattice)
        rules = self.parameters
        feedback, sizes = rules.part(Feedback), rules.part(Sizes)
        self.feedback = None if feedback is None else WindFeedback(feedback, rules, lattice)
        self.sized_sand: SizedSand | None = None
        if sizes is not None and rules.size_classes:
            thickness = sizes.active_layer * rules.diameter
            capacity = max(1, round(thickness / lattice.thickness))
            self.sized_sand = SizedSand(rules.size_classes, capacity)
            self.fields = (*self.fields, *self.sized_sand.surface, *self.sized_sand.substrate)
        if self.plants is not None:
            self.fields = (*self.fields, PLANT_HEIGHT)
            self.derived = (*self.derived, PLANT_SHARE)
            self.overlays = (*self.overlays, PLANTS)
        grains = max(1, round(rules.max_grains_per_cell * lattice.cells))
        self.pool = Pool(grains, self.sized_sand is not None)
        self.iteration = 0

    @property
    def plants(self) -> Canopy | None:
        """The canopy, where the scenario has any stand."""
        canopy = self.parameters.part(Canopy)
        return canopy if canopy is not None and canopy.stands else None

    def initialise(self, bed: Bed, seed: int) -> None:
        """Add sizes and plants to a bed; raises ScenarioError with all that keeps grains from flying."""
        rules = self.parameters
        fastest = entrainment_of(self.setting()).max_speed
        found = checks.problems(rules, bed, fastest)
        if found:
            raise ScenarioError(found)
        if self.sized_sand is not None:
            self.sized_sand.initialise(bed, seed)
        if self.plants is not None:
            bed.add(PLANT_HEIGHT, planted(self.plants.stands, self.lattice))

    def paintable(self) -> dict[str, tuple[float, float]]:
        """The height of plants, where the scenario has any."""
        if self.plants is None:
            return {}
        tallest = (stand.height for stand in self.plants.stands)
        return {PLANT_HEIGHT.name: (0.0, max(PAINTED, *tallest))}

    @property
    def step_seconds(self) -> float | None:
        """Duration of a step (s), where iterations are the clock."""
        return self.parameters.step_seconds

    def facts(self) -> dict[str, str]:
        """Parcels, settling and time, for people to read."""
        return checks.facts(self.parameters, self.lattice)

    def remarks(self, hop_length: float | None, direction: float) -> list[str]:
        """Parcels unlike those of the sources."""
        return checks.remarks(self.parameters, self.lattice)

    def state(self) -> dict[str, NDArray | float | int | str]:
        """The grains in the air, the number of iterations done, and the stress that grains take."""
        found: dict[str, NDArray | float | int | str] = {**self.pool.state(), "iteration": self.iteration}
        if self.sized_sand is not None:
            found["left_by_size"] = self.sized_sand.left
        if self.feedback is not None:
            found["grain_stress"] = self.feedback.stress
        return found

    def restore(self, state: dict[str, Any]) -> None:
        """Take up grains in the air, and the stress that they took."""
        self.pool.restore(state)
        self.iteration = int(state["iteration"])
        if self.sized_sand is not None:
            self.sized_sand.left[...] = state["left_by_size"]
        if self.feedback is not None:
            self.feedback.stress[...] = state["grain_stress"]

    def change(self, parameters: Any) -> None:
        """Take new parameters from now on; state is kept."""
        super().change(parameters)
        closure = self.parameters.part(Feedback)
        if self.feedback is not None and closure is not None:
            self.feedback.change(closure, self.parameters)

    def work_bytes(self) -> int:
        """The grains, their landings, and the bed as they meet it."""
        return SLOT_BYTES * self.pool.size + _CELL_BYTES * self.lattice.cells

    @property
    def airborne(self) -> int:
        """Parcels in the air."""
        return self.pool.flying * self.parameters.carried

    def advance(self, bed: Bed, segment: Segment, stream: Stream) -> Tally:
        """Let the grains in the air fly, land and be replaced."""
        total = Tally(airborne=self.airborne)
        ground = self.ground_of(bed, segment.direction, self.pool.work)
        for _ in range(segment.steps):
            ground.counts[:] = 0
            do_step = follow_trajectories if self.parameters.clock == "step" else iterate
            do_step(self, segment, stream, ground)
            self.pass_time(segment, ground)
            total.add(ground.tally(self.airborne))
            if self.sized_sand is not None:
                self.sized_sand.left += ground.left_by_size
        self._store(bed, ground)
        return total

    def ground_of(
        self, bed: Bed, direction: float, work: tuple[Landings, Ejecta] | None = None
    ) -> GrainGround:
        """A bed under a wind from ``direction`` (degrees), with ``work`` space for grains."""
        rules, canopy = self.parameters, self.plants
        layer = None if self.sized_sand is None else self.sized_sand.active_layer(bed)
        plants = None
        if canopy is not None:
            plants = canopy.roughness_of(bed.arrays[PLANT_HEIGHT.name], self.lattice, rules)
        return GrainGround(rules, bed, direction, work, layer, plants, self.bonds_of(bed))

    def bonds_of(self, bed: Bed) -> Bonds | None:
        """The bonds between grains of a bed; sand has none."""
        return None

    def pass_time(self, wind: Segment, ground: GrainGround) -> None:
        """Let what lies on the ground age by a step; sand does not."""

    def _store(self, bed: Bed, ground: GrainGround) -> None:
        if self.sized_sand is not None and ground.arrays.active_layer is not None:
            self.sized_sand.store(bed, ground.arrays.active_layer)

    def scene(self, ground: GrainGround, air: Air, rules: Rules, pool: Pool | None = None) -> Scene:
        """Everything that takes part in an iteration, with the model's grains or those of another pool."""
        grains = (pool or self.pool).grains
        return Scene(grains, air, ground.arrays, rules, ground.landings, ground.ejecta, ground.counts)

    def paths(
        self, bed: Bed, wind: Segment, stream: Stream, count: int, longest: float = 10.0
    ) -> list[NDArray[np.float64]]:
        """The paths of ``count`` grains, each of ``longest`` seconds at most; see ``trajectories.follow``."""
        from barchan.grains.trajectories import follow

        return follow(self, bed, wind, stream, count, longest)

    def relax(self, bed: Bed, where: NDArray[np.bool_] | None = None) -> int:
        """Relax slopes to the angle of repose."""
        ground = self.ground_of(bed, ANY_DIRECTION)
        slid = ground.relax_where(np.ones(bed.sand.size, np.bool_) if where is None else where.ravel())
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
