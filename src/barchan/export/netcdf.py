"""CF-NetCDF: all frames, with coordinates, reference system, and a time axis that readers find."""

from contextlib import suppress
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from barchan.archive.coordinates import GRID_MAPPING, attributes_of, mapped, mapping_attributes
from barchan.errors import ExportError, ScenarioError
from barchan.export.numbers import plain
from barchan.export.source import Sheet, Source
from barchan.udunits import cf_units
from barchan.version import __version__
from barchan.wind.recorded import Recorded

if TYPE_CHECKING:
    import h5netcdf

EPOCH = datetime(2000, 1, 1)
"""The moment of step 0 where none is given and the wind has no dates: arbitrary, and said to be."""

ROUNDING = 1.0
"""Seconds by which dates of a record, which are whole ones, may be off."""


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write all frames over (time, y, x), or (step, y, x) where steps have no duration; y ascends."""
    import h5netcdf

    first = _first_axis(source)
    with h5netcdf.File(path, "w") as file:
        _describe(file, source)
        file.dimensions = {first: len(source.steps), "y": source.grid.rows, "x": source.grid.columns}
        _write_axes(file, source, first)
        for place, (step, sheets) in enumerate(source.each()):
            for name, sheet in sheets.items():
                values = plain(sheet.values)
                if name not in file.variables:
                    _declare(file, source, first, sheet, values.dtype)
                file.variables[name][place] = values
            file.variables["wind_direction"][place] = float(source.frame(step)["wind_direction"])
    return {"first_axis": first}


def _first_axis(source: Source) -> str:
    clocked = source.seconds(0) is not None
    if source.options.epoch is not None and not clocked:
        raise ExportError("--epoch: the steps of this run have no duration, so they have no dates")
    return "time" if clocked else "step"


def _put(target: Any, attributes: dict[str, Any]) -> None:
    """Attributes as characters in UTF-8: VTK's reader does not see strings of variable length.

    Without these it finds no time. Plain bytes would be marked as ASCII, which readers do not decode.
    """
    for name, value in attributes.items():
        target.attrs[name] = _characters(value) if isinstance(value, str) else value


def _characters(text: str) -> NDArray:
    import h5py

    coded = text.encode()
    return np.array(coded, h5py.string_dtype("utf-8", len(coded)))


def _describe(file: "h5netcdf.File", source: Source) -> None:
    scenario = source.scenario
    told = {
        "Conventions": "CF-1.11",
        "title": scenario.title or "Run",
        "source": f"Barchan {__version__}",
        "references": scenario.citation,
        "scenario": scenario.text(),
    }
    _put(file, {name: text for name, text in told.items() if text})


def _write_axes(file: "h5netcdf.File", source: Source, first: str) -> None:
    grid, place = source.grid, source.scenario.ground.georeference()
    for name, values in (("x", grid.x), ("y", grid.y)):
        _put(file.create_variable(name, (name,), "f8", data=values), attributes_of(name, place))
    if mapping := mapping_attributes(place):
        _put(file.create_variable(GRID_MAPPING, (), "i4", data=np.int32(0)), mapping)
    steps = file.create_variable(
        "step", (first,), "i4" if first == "step" else "i8", data=np.array(source.steps)
    )
    _put(steps, {"units": "1", "long_name": "steps done"})
    if first == "step":
        _put(steps, {"axis": "T"})
    else:
        _write_times(file, source)
    wind = file.create_variable("wind_direction", (first,), "f8")
    _put(
        wind,
        {
            "units": "degree",
            "standard_name": "wind_from_direction",
            "long_name": "where the wind comes from; of several winds in one step their mean transport",
        },
    )


def _write_times(file: "h5netcdf.File", source: Source) -> None:
    seconds = np.array([source.seconds(step) for step in source.steps], "f8")
    epoch, told = _start(source, seconds)
    _put(
        file.create_variable("time", ("time",), "f8", data=seconds),
        {
            "units": f"seconds since {epoch.isoformat(' ')}",
            "calendar": "proleptic_gregorian",
            "standard_name": "time",
            "long_name": f"time{told}",
            "axis": "T",
        },
    )


def _start(source: Source, seconds: NDArray[np.float64]) -> tuple[datetime, str]:
    """The moment of step 0, and what is to be said of it: the one given, or that of the wind's record."""
    if source.options.epoch is not None:
        return source.options.epoch, ""
    wind = source.scenario.wind
    dates = None
    if isinstance(wind, Recorded):
        with suppress(ScenarioError):  # the record is no longer where it was
            dates = wind.dates(np.append(0.0, seconds))
    if dates is None:
        return EPOCH, "; its start is arbitrary"
    start, known = dates[0], ~np.isnat(dates[1:])
    apart = (dates[1:] - start)[known].astype(np.float64) - seconds[known]
    skipped = bool((np.abs(apart) > ROUNDING).any())
    more = "; times without a known wind are left out" if skipped else ""
    return start.astype(datetime), f" from the beginning of the wind's record{more}"


def _declare(file: "h5netcdf.File", source: Source, first: str, sheet: Sheet, kind: np.dtype) -> None:
    grid = source.grid
    variable = file.create_variable(
        sheet.name,
        (first, "y", "x"),
        kind,
        chunks=(1, grid.rows, grid.columns),
        compression="gzip",
        compression_opts=1,
        shuffle=True,
        **({"fillvalue": np.float32(np.nan)} if kind.kind == "f" else {}),
    )
    told = {**cf_units(sheet.unit), "long_name": sheet.meaning}
    if sheet.name == "elevation":
        told["standard_name"] = "surface_altitude"
    _put(variable, {**told, **mapped(source.scenario.ground.georeference())})
