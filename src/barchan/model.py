"""The contract of models: their declarations and methods."""

from abc import ABC, abstractmethod
from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Bed
from barchan.fields import SAND, FieldInfo, LayerInfo
from barchan.lattice import Lattice
from barchan.parameters import Parameters
from barchan.streams import Stream
from barchan.wind.forcing import Forcing
from barchan.wind.segment import Segment


@dataclass
class Tally:
    """Counts of the events on the bed during some steps; slabs are the bed's whole units."""

    steps: int = 0
    polls: int = 0
    """Work done, in the model's ``work_unit``."""
    moved: int = 0
    """Slabs that the wind took."""
    crept: int = 0
    """Slabs that moved without being carried, in a model that counts them separately."""
    left: int = 0
    """Slabs that left through open edges."""
    entered: int = 0
    """Slabs that entered across open edges or fell as snow."""
    fallen: int = 0
    """Slabs among those that entered which fell as snow."""
    airborne: int = 0
    """Slabs in the air at the end."""
    capped: int = 0
    """Slabs put down because they never settled."""
    travel_x: float = 0.0
    """Distance that slabs travelled on the wind, eastwards, summed over slabs (cells)."""
    travel_y: float = 0.0
    exhausted: int = 0
    """Steps cut short because no cell could erode."""
    finished: str | None = None
    """Why nothing more can happen on this bed, where the model knows that; the run ends."""

    @property
    def idle(self) -> bool:
        """Whether nothing moved and nothing is in the air."""
        return not (self.moved or self.crept or self.entered or self.airborne)

    def add(self, other: "Tally") -> None:
        """Add the counts of the steps that followed."""
        for name in ("steps", "polls", "moved", "crept", "left", "entered", "fallen", "capped", "exhausted"):
            setattr(self, name, getattr(self, name) + getattr(other, name))
        self.travel_x += other.travel_x
        self.travel_y += other.travel_y
        self.airborne = other.airborne
        self.finished = other.finished


@dataclass(frozen=True)
class Derived:
    """A field that is computed from a bed when someone looks, never stored."""

    name: str
    unit: str
    meaning: str
    compute: Callable[[Any, Bed, Segment], NDArray]
    """Computes it from the model, a bed and the wind over it."""
    centred: bool = False
    """Whether pictures show it evenly about its value on a flat bed."""
    sheltered: bool = False
    """Whether it is 0 on cells in shadow, and curves along a section leave these out."""
    least: float | None = None
    """The value that it cannot lie below, where there is one."""
    along_wind: bool = False
    """Whether it is the size of something that points where the wind blows."""
    of_layers: bool = False
    """Whether it belongs to what lies on the ground: on bare ground it has no value, and is 0."""


@dataclass(frozen=True)
class ModelMeasure:
    """A measure of a bed that only this model can give; tables show it beside those of every bed."""

    name: str
    title: str
    unit: str
    compute: Callable[..., float]
    """Computes it from the model, a bed and the wind over it, or from what ``shared`` makes of them."""
    shared: Callable[[Any, Bed, Segment], Any] | None = None
    """Makes of the model, a bed and the wind what several measures need, once for all of them."""


@dataclass(frozen=True)
class Overlay:
    """How a field, kept or derived, is drawn on top of the surface: from 0, unseen, to 1, dark."""

    field: str
    title: str
    colours: str
    """Name of a colour map."""
    parts: tuple[str, ...] = ()
    """Fields that it is the sum of, where one may look at them one by one."""


@dataclass(frozen=True)
class Strata:
    """The layers of a bed from the ground up, each with a value that sections show, such as its age."""

    name: str
    title: str
    unit: str
    compute: Callable[[Any, Bed], list[tuple[NDArray, NDArray]]]
    """Computes thickness (m) and value of each layer on every cell, the lowest first, from model and bed."""
    states: tuple[str, ...] = ()
    """Words for the values 0, 1 and so on, of layers that are told apart by a state."""
    drawn: bool = True
    """Whether sections can be coloured by it; tables hold it in any case."""
    clock: str = ""
    """Of an age: the field that holds the present time of the clock of layers, alike on all cells."""
    tick: float = 1.0
    """Of an age: how much one unit of that field is, in ``unit``."""


@dataclass(frozen=True)
class Curve:
    """A curve that is part of a model's parameters, to be drawn."""

    title: str
    x: tuple[float, ...]
    y: tuple[float, ...]
    x_title: str
    y_title: str
    remark: str = ""
    source: str = ""
    """The publication that it is taken from, where it is a law and no choice of the user's."""
    log_x: bool = False
    """Whether it is drawn over the logarithm of ``x``."""


class Model(ABC):
    """One published model. Subclasses with a ``name`` are found by themselves."""

    name: ClassVar[str] = ""
    title: ClassVar[str] = ""
    citation: ClassVar[str] = ""
    lattices: ClassVar[tuple[str, ...]] = ("square",)
    """The kinds of lattices that its rules are made for."""
    takes_influx: ClassVar[bool] = False
    """Whether it lets sand enter across open edges, where the forcing brings any."""
    takes_hops: ClassVar[bool] = True
    """Whether a wind may state its speed as a hop length in cells."""
    temperature_range: ClassVar[tuple[float, float] | None] = None
    """The air temperatures (°C) that its rules hold for, where they use them."""
    material: ClassVar[str] = "sand"
    """The material of its slabs or parcels, in one word; the studio groups models by it."""
    work_unit: ClassVar[str] = "polls"
    """Name of the unit of its work, for rates that people read."""
    work_per_second: ClassVar[float] = 2e7
    """Units of work that one core of a common computer does in a second, for expected times."""
    Parameters: ClassVar[type[Parameters]]
    layers: tuple[LayerInfo, ...] = (SAND,)
    """Layers on the ground that wind can move, the lowest first; a run starts with the uppermost filled."""
    fields: tuple[FieldInfo, ...] = ()
    """Fields the model keeps on the bed beside ground and layers; parameters may ask for more of them."""
    derived: tuple[Derived, ...] = ()
    """Fields that show how the model sees a bed; parameters may ask for more of them."""
    measures: ClassVar[tuple[ModelMeasure, ...]] = ()
    overlays: tuple[Overlay, ...] = ()
    """Fields that pictures draw over the surface; parameters may ask for more."""

    strata: ClassVar[tuple[Strata, ...]] = ()
    """What sections show of the layers, of a model that keeps any; the first unless another is asked for."""
    winds_off_axes: bool = False
    """Whether any wind of the run blows off the lattice's axes; the scenario and the run say so."""
    fresh_densities: ClassVar[tuple[float, float] | None] = None
    """The densities (kg/m³) at which a brush may lay fresh snow, of a model that keeps densities."""

    def __init__(self, parameters: Any, lattice: Lattice) -> None:
        """Set the model up for a lattice."""
        self.parameters = parameters
        self.lattice = lattice

    def change(self, parameters: Any) -> None:
        """Take new parameters from now on; state is kept."""
        self.parameters = parameters

    def initialise(self, bed: Bed, seed: int) -> None:
        """Add the model's own fields to a bed; ``seed`` is the run's.

        Raises ScenarioError where the model's own files do not fit.
        """

    def check_bed(self, bed: Bed) -> None:
        """Raise ScenarioError for a bed that the model cannot work on."""

    def paintable(self) -> dict[str, tuple[float, float]]:
        """The model's fields that a brush may change, and the values that it holds them within."""
        return {}

    def lay_fresh(self, bed: Bed, quanta: NDArray[np.int64], density: float) -> None:
        """Lay fresh snow of a density (kg/m³) on each cell, where ``fresh_densities`` says that this may be.

        Raises OverflowError where a cell cannot count as many.
        """
        raise NotImplementedError

    def start(self, bed: Bed) -> None:
        """Take note of the bed once it has come to rest, before the first step."""

    @abstractmethod
    def advance(self, bed: Bed, segment: Segment, stream: Stream) -> Tally:
        """Let the wind of ``segment`` work on the bed, in place, and return what happened.

        A calm is a segment without polls: time passes, and a model whose bed changes without wind (snow
        that falls, hardens or packs) works on it too. A model that finishes says why in the tally and may
        return before all the segment's steps are done.
        """

    @abstractmethod
    def relax(self, bed: Bed, where: NDArray[np.bool_] | None = None) -> int:
        """Relax slopes to rest, in place: those of the whole bed, or those that a change ``where`` upsets.

        Returns how many slabs slid.
        """

    def slope_limits(self) -> dict[str, tuple[int, ...]]:
        """The steps (whole units) that stand towards faces and, in some models, corners, by kind of cell."""
        return {}

    def slope_rules(self) -> Hashable:
        """All that decides which slopes stand; when it changes the bed has to settle."""
        return tuple(self.slope_limits().items())

    @property
    def step_seconds(self) -> float | None:
        """Duration of a step (s), of a model whose rules define it."""
        return None

    def friction_velocity(self, wind: Segment) -> float | None:
        """Friction velocity (m/s) of a wind over a flat bed, of models that know one."""
        return None

    def expected_work(self, segment: Segment) -> float:
        """Work, in the ``work_unit``, that a segment is expected to take; by default its polls."""
        return float(segment.steps * segment.polls)

    def work_bytes(self) -> int:
        """Memory (bytes) that its work takes at most beside the bed: an estimate, made before the work is."""
        return 0

    @property
    def strength(self) -> Callable[[NDArray[np.float64]], NDArray[np.float64]] | None:
        """From wind speeds (m/s at 10 m) to polls over those of a step, of a model whose rules tell it."""
        return None

    def step_volume(self) -> float:
        """Volume of sand (m² per step: per width across the wind) that a step moves on a flat bed.

        Raises ValueError where the model cannot know it.
        """
        raise ValueError(f"is given, but how much sand a step of {self.title} moves is not known")

    def problems(self, step_seconds: float | None) -> list[tuple[str, str]]:
        """Keys of the parameters at fault, and why, under steps of a duration (None: unknown)."""
        return []

    def state(self) -> dict[str, NDArray | float | int | str]:
        """The values that the model keeps between steps beside the bed."""
        return {}

    def restore(self, state: dict[str, Any]) -> None:
        """Take up a remembered state."""

    @classmethod
    def curves(cls, parameters: Any) -> list[Curve]:
        """The curves among the parameters."""
        return []

    def remarks(self, hop_length: float | None, direction: float) -> list[str]:
        """Warnings about this choice of parameters on this lattice."""
        return []

    @property
    def unit_height(self) -> float | None:
        """Height (m) of a unit of the start's uppermost layer, where it is not a slab of the lattice."""
        return None

    @property
    def beneath(self) -> float:
        """Thickness (m) of what ``initialise`` lays beneath the units of the start."""
        return 0.0

    def held_temperature(self, temperature: float) -> float:
        """The temperature (°C) nearest to this one for which the model's rules hold."""
        if self.temperature_range is None:
            return temperature
        coldest, warmest = self.temperature_range
        return min(max(temperature, coldest), warmest)

    def moves(self, wind: Segment) -> bool:
        """Whether a wind can move anything; by default one that has polls."""
        return wind.polls > 0

    def wind_facts(self, speeds: Sequence[float]) -> dict[str, str]:
        """What the winds that blow come to, for people to read; ``speeds`` (m/s) are those they state."""
        return {}

    def wind_remarks(self) -> list[str]:
        """Warnings about the winds of the run as a whole, under this choice of parameters."""
        return []

    def facts(self) -> dict[str, str]:
        """Quantities that follow from the parameters on this lattice, by name, as text."""
        return {}

    def forecast(self, forcing: Forcing) -> dict[str, str]:
        """What can be predicted of a run under a forcing before it starts, for people to read."""
        return {}
