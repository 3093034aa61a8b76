"""The measures of a run's frames, one after the other: a table of declared measures."""

from collections import deque
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.analysis.fields import as_modelled, bed_in
from barchan.bed import Bed
from barchan.directions import downwind
from barchan.measures.amounts import bare_fraction, flux, highest_stack
from barchan.measures.migration import Migration, migration
from barchan.measures.orientation import Orientation, crest_orientation
from barchan.measures.relief import bedform_height, bedform_index
from barchan.measures.slopes import Slopes, streamwise_slopes
from barchan.measures.spacing import dominant_spacing
from barchan.models import Model, ModelMeasure, models
from barchan.scenario import Scenario
from barchan.wind.clock import YEAR
from barchan.wind.segment import Segment

if TYPE_CHECKING:
    import xarray as xr


@dataclass(frozen=True)
class MeasuredFrame:
    """One frame of a run, compared with the frames before it."""

    modelled: Callable[[], tuple[Model, Bed, Segment]]
    """The model, the bed and the wind as they were then."""
    bed: Bed
    """Ground and layers."""
    elevation: NDArray[np.float64]
    scenario: Scenario
    direction: float
    """Direction that the wind comes from (degrees clockwise from north)."""
    orientation: Orientation
    slopes: Slopes
    migration: Migration
    travel: float
    """Distance (cells) travelled downwind since the frame before, summed over slabs."""
    steps: int
    """Steps since the frame before."""

    def __repr__(self) -> str:
        rows, columns = self.elevation.shape
        return f"<MeasuredFrame of {rows} × {columns} cells, {self.steps} steps after the one before>"

    @property
    def periodic(self) -> tuple[bool, bool]:
        """Whether the field is periodic south to north and west to east."""
        return self.scenario.lattice.periodic

    @property
    def speed(self) -> float:
        """Migration along the wind (cells per step)."""
        return self.migration.along(*downwind(self.direction))


@dataclass(frozen=True)
class Measure:
    """A declared measure."""

    name: str
    title: str
    unit: str
    compute: Callable[[MeasuredFrame], float]

    def __repr__(self) -> str:
        return f"<Measure {self.name}: {self.title}{f' ({self.unit})' if self.unit != '-' else ''}>"


MEASURES = (
    Measure("highest_stack", "highest stack", "slabs", lambda m: highest_stack(m.bed.stack)),
    Measure("highest", "highest stack", "m", lambda m: float(m.bed.depth.max())),
    Measure("bare_fraction", "bare ground", "-", lambda m: bare_fraction(m.bed.stack)),
    Measure(
        "spacing",
        "dominant spacing",
        "m",
        lambda m: dominant_spacing(m.elevation, m.scenario.lattice.cell_size, m.direction, m.periodic),
    ),
    Measure("bedform_height", "bedform height", "m", lambda m: bedform_height(m.elevation, m.periodic)),
    Measure(
        "bedform_index",
        "bedform index",
        "-",
        lambda m: bedform_index(m.elevation, m.scenario.lattice.cell_size, m.direction, m.periodic),
    ),
    Measure("crest_azimuth", "crest orientation", "degrees", lambda m: m.orientation.azimuth),
    Measure("straightness", "crest straightness", "-", lambda m: m.orientation.coherence),
    Measure("speed_cells", "migration downwind", "cells/step", lambda m: m.speed),
    Measure("speed", "migration downwind", "m/step", lambda m: m.speed * m.scenario.lattice.cell_size),
    Measure("windward_slope", "windward slope", "degrees", lambda m: m.slopes.windward),
    Measure("lee_slope", "lee slope", "degrees", lambda m: m.slopes.lee),
    Measure(
        "flux",
        "flux",
        "m²/step",
        lambda m: flux(
            m.travel, m.bed.lattice.cells, m.steps, m.scenario.lattice.thickness, m.scenario.lattice.cell_size
        ),
    ),
    Measure(
        "volume",
        "volume",
        "m³",
        lambda m: m.bed.volume,
    ),
)
"""Every measure of any frame, in the order in which tables show them."""


PER_YEAR = (
    Measure("speed_per_year", "migration downwind", "m/yr", lambda m: _per_year(m, "speed")),
    Measure("flux_per_year", "flux", "m²/yr", lambda m: _per_year(m, "flux")),
)
"""Measures of a frame whose steps have a duration."""


def measures_of(scenario: Scenario) -> tuple[Measure, ...]:
    """Every measure of a scenario's frames: those of any frame, by year too, and its model's own."""
    timed = () if scenario.step_seconds is None else PER_YEAR
    return (*MEASURES, *timed, *map(_own, models()[scenario.model.name].measures))


def _own(own: ModelMeasure) -> Measure:
    return Measure(own.name, own.title, own.unit, lambda m: float(own.compute(*m.modelled())))


def _per_year(frame: MeasuredFrame, name: str) -> float:
    """A measure per step as one per year."""
    compute = next(measure.compute for measure in MEASURES if measure.name == name)
    return compute(frame) * YEAR / (frame.scenario.step_seconds or float("nan"))


LAGS = 3
"""Earlier frames that a frame's migration is measured from."""


class FrameMeasurer:
    """Compares each frame of a run with those before it, of which it keeps up to ``LAGS``."""

    def __init__(self, scenario: Scenario) -> None:
        """Begin without earlier frames."""
        self.scenario = scenario
        self._recent: deque[tuple[int, NDArray[np.float64], NDArray[np.float64]]] = deque(maxlen=LAGS + 1)

    @property
    def last_step(self) -> int | None:
        """The step of the newest frame."""
        return self._recent[-1][0] if self._recent else None

    def keep(self, step: int, elevation: NDArray[np.float64], travelled: Sequence[float]) -> None:
        """Keep a frame to compare later ones with: elevation (m) and distances travelled (cells, x and y)."""
        self._recent.append((step, elevation, np.asarray(travelled)))

    def measured(
        self,
        step: int,
        bed: Bed,
        elevation: NDArray[np.float64],
        direction: float,
        travelled: Sequence[float],
        modelled: Callable[[], tuple[Model, Bed, Segment]],
    ) -> MeasuredFrame:
        """The next frame of the run."""
        self.keep(step, elevation, travelled)
        steps, surfaces, distances = zip(*self._recent, strict=True)
        before = max(len(steps) - 2, 0)
        lattice = self.scenario.lattice
        return MeasuredFrame(
            modelled=modelled,
            bed=bed,
            elevation=elevation,
            scenario=self.scenario,
            direction=direction,
            orientation=crest_orientation(elevation, lattice.cell_size, lattice.periodic),
            slopes=streamwise_slopes(elevation, lattice.cell_size, direction, lattice.periodic),
            migration=migration(steps, surfaces, lattice.periodic),
            travel=float(np.dot(downwind(direction), distances[-1] - distances[before])),
            steps=step - steps[before],
        )


def measured_frames(dataset: "xr.Dataset", scenario: Scenario, first: int = 0) -> Iterator[MeasuredFrame]:
    """The frames of a run from number ``first`` on; migration is from up to ``LAGS`` frames before."""
    measurer = FrameMeasurer(scenario)
    steps = dataset["step"].values
    travelled = np.stack([dataset["travel_x"].values, dataset["travel_y"].values], axis=1)
    for at in range(max(0, first - LAGS), first):
        measurer.keep(int(steps[at]), dataset["elevation"][at].values, travelled[at])
    for at in range(first, len(steps)):
        yield measurer.measured(
            int(steps[at]),
            bed_in(dataset.isel(step=at), scenario),
            dataset["elevation"][at].values,
            float(dataset["wind_direction"][at]),
            travelled[at],
            partial(as_modelled, dataset.isel(step=at), scenario),
        )


def measure_series(dataset: "xr.Dataset", scenario: Scenario) -> "xr.Dataset":
    """Every measure over the steps of a run."""
    import xarray as xr

    measures = measures_of(scenario)
    rows = [[measure.compute(frame) for measure in measures] for frame in measured_frames(dataset, scenario)]
    values = np.array(rows, float).T
    return xr.Dataset(
        {
            m.name: ("step", v, {"long_name": m.title, "unit": m.unit})
            for m, v in zip(measures, values, strict=True)
        },
        {name: dataset[name] for name in ("step", "time") if name in dataset.coords},
    )


def last_measures(dataset: "xr.Dataset", scenario: Scenario) -> dict[str, float]:
    """The measures of a run's last frame, by name."""
    last = next(iter(measured_frames(dataset, scenario, dataset.sizes["step"] - 1)))
    return {measure.name: float(measure.compute(last)) for measure in measures_of(scenario)}
