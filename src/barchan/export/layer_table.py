"""The layers that a bed is made of along a section: where each lies, how old and how dense it is."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray

from barchan.errors import ExportError
from barchan.export.options import Options
from barchan.export.source import Source
from barchan.model import Strata
from barchan.wind import Recorded

if TYPE_CHECKING:
    import xarray as xr

PLACES = {
    "step": ("-", "steps done"),
    "distance": ("m", "distance along the wind from the upwind end of the section"),
    "x": ("m", "easting of the cell's centre"),
    "y": ("m", "northing of the cell's centre"),
    "layer": ("-", "number of the layer, counted from the ground"),
    "bottom": ("m", "elevation of the layer's lower side"),
    "top": ("m", "elevation of the layer's upper side"),
}
"""Unit and meaning of the columns that tables of every model have."""

DEPOSITED = (
    "s",
    "time since the start at which bonds began to grow, between frames by their ageing; none before the run",
)
DATE = ("-", "the same as a date of the record")


def layer_table(
    run: "str | Path | xr.Dataset",
    *,
    step: int | Sequence[int] | Literal["all", "last"] = "all",
    at: float | None = None,
) -> "xr.Dataset":
    """The layers along a section of a run, a row each: long form, ``to_dataframe`` makes a table of it.

    ``run`` and ``step`` are as for :func:`barchan.export.export`; ``at`` is where the section lies across the
    wind (0 to 1), by default through the highest stack of the last chosen frame. Variables along ``row``:
    ``step``; ``distance``, ``x`` and ``y`` (m) of the cell; ``layer``, counted from the ground; ``bottom``
    and ``top`` (m), elevations; and what the model states of its layers. Of snow these are ``age`` (h at
    -10 °C; of snow_grains in bonding times), ``density`` (kg/m³), ``state`` (loose or bonded), ``mass``
    (kg/m²), and where the run has a clock for it ``deposited`` (s since the start) and ``date``, under a
    record with dates. Attributes: ``unit`` and ``long_name`` of every variable, ``at`` of the whole.

    Raises ExportError for a model without layers, a step that was not saved or a place outside 0 to 1.
    """
    from barchan.export.writing import chosen_steps, opened

    dataset, scenario = opened(run)
    try:
        steps = chosen_steps(dataset, step)
        return layers_of(Source(dataset, scenario, steps, (), Options(at=at), all_steps=steps))
    finally:
        if not isinstance(run, type(dataset)):
            dataset.close()


def layers_of(source: Source) -> "xr.Dataset":
    """The layers along a section in the chosen frames of a run; see ``layer_table``."""
    import xarray as xr

    from barchan.figures.section_lines import through_highest

    model = source.scenario.new_model()
    if not model.strata:
        raise ExportError(f"{model.title} keeps no layers; tables of layers are those of models that do")
    at = source.options.at
    if at is None:
        at = through_highest(source.frame(source.steps[-1]), source.scenario)
    frames = [_frame_table(source, step, at) for step in source.steps]
    clocks = {one.name: _clock(source, one) for one in model.strata if one.clock}
    variables: dict[str, Any] = {}
    for name, (unit, meaning) in _columns(model.strata).items():
        values = np.concatenate([frame[name] for frame in frames])
        variables[name] = ("row", values, {"unit": unit, "long_name": meaning})
    table = xr.Dataset(variables, attrs={"at": at})
    for name, clock in clocks.items():
        if clock is not None:
            table = _dated(table, source, name, clock)
    return table


def _columns(strata: Sequence[Strata]) -> dict[str, tuple[str, str]]:
    return {**PLACES, **{one.name: (one.unit, one.title) for one in strata}}


def _frame_table(source: Source, step: int, at: float) -> dict[str, NDArray]:
    """The columns of one frame: cells along the section, each from the ground up."""
    from barchan.analysis.fields import as_modelled
    from barchan.figures.section_lines import section_along_wind

    frame = source.frame(step)
    model, bed, _wind = as_modelled(frame, source.scenario)
    line = section_along_wind(source.scenario, float(frame["wind_direction"]), at)
    found = {one.name: one.compute(model, bed) for one in model.strata}
    first = next(iter(found.values()))
    thickness = np.array([layer[line.rows, line.cols] for layer, _ in first]).T
    held = thickness > 0.0
    tops = bed.ground[line.rows, line.cols][:, None] + np.cumsum(thickness, axis=1)
    cells = np.nonzero(held)[0]
    columns = {
        "step": np.full(len(cells), step),
        "distance": line.distance[cells],
        "x": source.grid.x[line.cols[cells]],
        "y": source.grid.y[line.rows[cells]],
        "layer": np.cumsum(held, axis=1)[held],
        "bottom": (tops - thickness)[held],
        "top": tops[held],
    }
    for one in model.strata:
        values = np.array([value[line.rows, line.cols] for _, value in found[one.name]]).T[held]
        columns[one.name] = np.array(one.states)[values.astype(int)] if one.states else values
    return columns


Clock = tuple[NDArray[np.float64], NDArray[np.float64], dict[int, float]]
"""Readings of the clock that layers age by, rising, when each was (s), and the reading at each step."""


def _clock(source: Source, strata: Strata) -> Clock | None:
    """The clock by which layers age over all frames of a run; None where steps or bonds have no time."""
    if strata.clock not in source.dataset or source.seconds(0) is None:
        return None
    readings = source.dataset[strata.clock].isel(y=0, x=0).values * strata.tick
    steps = [int(step) for step in source.dataset["step"].values]
    seconds = np.array([source.seconds(step) for step in steps], dtype=np.float64)
    if readings[-1] <= readings[0]:
        return None
    return readings, seconds, dict(zip(steps, readings.tolist(), strict=True))


def _dated(table: "xr.Dataset", source: Source, age: str, clock: Clock) -> "xr.Dataset":
    """A table with the times at which layers came to rest, and their dates where the wind has any."""
    readings, seconds, at_step = clock
    now = np.array([at_step[int(step)] for step in table["step"].values])
    when = np.interp(now - table[age].values, readings, seconds, left=np.nan)
    table = table.assign(deposited=("row", when, dict(zip(("unit", "long_name"), DEPOSITED, strict=True))))
    wind = source.scenario.wind
    dates = wind.dates(when) if isinstance(wind, Recorded) else None
    if dates is None:
        return table
    return table.assign(date=("row", dates, dict(zip(("unit", "long_name"), DATE, strict=True))))
