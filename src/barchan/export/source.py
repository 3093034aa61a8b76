"""The frames of a run as exports see them: chosen steps and fields, smoothed or resampled on request."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Literal

import numpy as np
import scipy
from numpy.typing import NDArray

from barchan.analysis.fields import field_of
from barchan.export.grid import Grid
from barchan.export.options import Options
from barchan.ground.resampling import with_volume_kept
from barchan.measures.filters import smoothed
from barchan.scenario import Scenario
from barchan.squares import Squares

if TYPE_CHECKING:
    import xarray as xr


@dataclass(frozen=True)
class Sheet:
    """A field of one frame."""

    name: str
    values: NDArray
    """By row and column, row 0 at the south edge, column 0 at the west edge."""
    unit: str
    meaning: str
    along_wind: bool = False
    """Whether it is the size of something that points where the wind blows."""


@dataclass(frozen=True)
class Source:
    """Chosen frames and fields of a run, and how they are to be changed on the way out."""

    dataset: "xr.Dataset"
    scenario: Scenario
    steps: tuple[int, ...]
    fields: tuple[str, ...]
    options: Options
    ranges: dict[str, tuple[float, float]] = field(default_factory=dict)
    """Lowest and highest value of each field in all frames that were looked at."""
    progress: Callable[[int], None] | None = None
    """Takes the number of frames that are drawn, where somebody asks for it."""
    all_steps: tuple[int, ...] = ()
    """The steps of the whole export, of which this may be one file."""
    scales: dict[str, tuple[float, float]] = field(default_factory=dict)
    """Lowest and highest value of the colour scale of each field, the same in all files of an export."""

    @cached_property
    def grid(self) -> Grid:
        """The cells of all exported fields."""
        grid = Grid.of(self.scenario.lattice, self.scenario.ground.georeference())
        if self.options.cells is not None:
            grid = grid.with_cells(*self.options.cells)
        return grid.close() if self.options.close else grid

    def only(self, steps: Sequence[int], fields: Sequence[str]) -> "Source":
        """The same run with fewer steps and fields."""
        return replace(self, steps=tuple(steps), fields=tuple(fields))

    def seconds(self, step: int) -> float | None:
        """Time since the start (s), where steps have a duration."""
        duration = self.scenario.step_seconds
        return None if duration is None else step * duration

    def frame(self, step: int) -> "xr.Dataset":
        """A frame as it was saved."""
        return self.dataset.sel(step=step).load()

    def sheets(self, step: int) -> dict[str, Sheet]:
        """The chosen fields of a frame, ready to be written."""
        frame = self.frame(step)
        return {name: self._sheet(frame, name) for name in self.fields}

    def sheet(self) -> Sheet:
        """The only field of the only frame."""
        (step,), (name,) = self.steps, self.fields
        return self._sheet(self.frame(step), name)

    def each(self) -> Iterator[tuple[int, dict[str, Sheet]]]:
        """The chosen steps with their fields, one frame in memory at a time."""
        for step in self.steps:
            yield step, self.sheets(step)

    def range_of(self, name: str) -> tuple[float, float]:
        """Lowest and highest value of a field in all chosen frames."""
        for step in self.steps:
            self._sheet(self.frame(step), name)
        return self.ranges[name]

    def _sheet(self, frame: "xr.Dataset", name: str) -> Sheet:
        found = field_of(frame, self.scenario, name)
        values = Squares(self.scenario.lattice).between(found.values)
        values = changed(values, self.scenario.lattice.periodic, self.options)
        self._note(name, values)
        unit, meaning = str(found.attrs["unit"]), str(found.attrs["long_name"])
        return Sheet(name, values, unit, meaning, bool(found.attrs.get("along_wind")))

    def _note(self, name: str, values: NDArray) -> None:
        known = values[np.isfinite(values)]
        if known.size:
            low, high = self.ranges.get(name, (np.inf, -np.inf))
            self.ranges[name] = (min(low, float(known.min())), max(high, float(known.max())))


def changed(values: NDArray, periodic: tuple[bool, bool], options: Options) -> NDArray:
    """A field smoothed, brought onto other cells and closed, as far as the options ask for it.

    Yes and no are never mixed: on other cells they have the value at the nearest centre.
    """
    choice = values.dtype.kind == "b"
    if options.smooth and not choice:
        values = _smoothed(values.astype(np.float64), options.smooth, periodic)
    if options.cells is not None:
        columns, rows = options.cells
        values = (
            _nearest(values, (rows, columns))
            if choice
            else with_volume_kept(values.astype(np.float64), (rows, columns), periodic)
        )
    if options.close:
        values = np.pad(values, [(0, int(joined)) for joined in periodic], mode="wrap")
    return values


def _smoothed(values: NDArray[np.float64], width: float, periodic: tuple[bool, bool]) -> NDArray[np.float64]:
    """A field smoothed with a Gaussian; edges that are not joined mirror it, which keeps the mean.

    Cells without a value stay without one.
    """
    if not np.isfinite(values).all():
        return smoothed(values, width, periodic)
    modes: list[Literal["wrap", "reflect"]] = ["wrap" if joined else "reflect" for joined in periodic]
    return np.asarray(scipy.ndimage.gaussian_filter(values, width, mode=modes))


def _nearest(values: NDArray, shape: tuple[int, int]) -> NDArray:
    rows, columns = (
        ((np.arange(new) + 0.5) * old / new).astype(np.int64)
        for new, old in zip(shape, values.shape, strict=True)
    )
    return np.asarray(values[np.ix_(rows, columns)])
