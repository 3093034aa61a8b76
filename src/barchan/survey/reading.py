"""Surfaces from files and from runs."""

import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from barchan.errors import ArchiveError, SurveyError
from barchan.export.grid import Grid
from barchan.ground.fitting import FromFile
from barchan.ground.raster import UnreadableError
from barchan.ground.reading import READERS
from barchan.ground.reference import name_of
from barchan.survey.height_field import HeightField

_CRS = re.compile(r"\bcrs(?= '|, for instance)")
"""The key of a scenario's ground by which messages ask for a reference system; here it is an option."""

ADVICE = "--missing {codes} if it is one, --missing none if all are heights"


def read_field(
    source: str | Path,
    *,
    cell_size: float | None = None,
    crs: str | None = None,
    variable: str | None = None,
    missing: list[float] | None = None,
    limits: tuple[float, float] | None = None,
    step: int | None = None,
    periodic: bool = False,
) -> HeightField:
    """The surface in a file of heights or in a frame of a run.

    ``cell_size`` (m) is needed where the file has no coordinates; ``crs``, ``variable`` and ``missing`` are
    as for the ground of a scenario; ``limits`` are the heights (m) of black and white in an image; ``step``
    is the frame of a run, its last without it; ``periodic`` says that a file's opposite edges are joined.
    Raises SurveyError, or ArchiveError for a run.
    """
    path = Path(source)
    given = {
        "--cell-size": cell_size,
        "--crs": crs,
        "--variable": variable,
        "--missing": missing,
        "--range": limits,
    }
    if path.is_dir():
        if told := [name for name, value in given.items() if value is not None]:
            raise SurveyError(f"{path}: a run knows its cells and heights; leave {', '.join(told)} out")
        return _frame(path, step)
    if step is not None:
        raise SurveyError(f"{path}: --step {step} is for runs; this is no run's folder")
    low, high = limits or (None, None)
    file = FromFile(
        kind="file", path=str(path), lowest=low, highest=high, missing=missing, crs=crs, variable=variable
    )
    try:
        return _file(file, path, cell_size, periodic)
    except UnreadableError as error:
        error = UnreadableError(_CRS.sub("--crs", str(error)))
        folder = "; a run is a folder" if path.suffix.lower() not in READERS else ""
        raise SurveyError(f"{path}: {error}{folder}") from None


def _file(file: FromFile, path: Path, cell_size: float | None, periodic: bool) -> HeightField:
    raster = file.raster()
    joined = (periodic, periodic)
    if raster.place is None:
        if cell_size is None:
            raise UnreadableError("has no coordinates; give --cell-size, the side of a cell in metres")
        return HeightField.of_array(file.scaled(raster, cell_size, ADVICE), cell_size, joined, str(path))
    place = raster.place
    if cell_size is not None:
        raise UnreadableError(f"has cells of {place.cell_size:g} m by itself; leave --cell-size out")
    heights = file.scaled(raster, place.cell_size, ADVICE)
    rows, columns = heights.shape
    name, wkt = (None, None) if place.crs is None else (name_of(place.crs), str(place.crs.to_wkt()))
    grid = Grid(rows, columns, place.width, place.height, place.west, place.south, name, wkt, joined)
    return HeightField(np.where(np.isinf(heights), np.nan, heights), grid, str(path))


def _frame(path: Path, step: int | None) -> HeightField:
    """The surface of the bedforms in a frame of a run, its wind, and the measures that need the run."""
    from barchan.analysis.declared_measures import measures_of
    from barchan.analysis.time_series import measured_frames
    from barchan.archive import open_run
    from barchan.archive.folder import scenario_of

    with open_run(path) as dataset:
        scenario = scenario_of(path)
        steps = dataset["step"].values
        at = len(steps) - 1 if step is None else int(np.searchsorted(steps, step))
        if at == len(steps) or (step is not None and steps[at] != step):
            raise ArchiveError(f"{path}: no frame at step {step}; saved: {_spoken(steps)}")
        frame = next(iter(measured_frames(dataset.isel(step=slice(0, at + 1)), scenario, at)))
        values = tuple(measure.of(frame) for measure in measures_of(scenario))
        seconds = float(dataset["time"].values[at]) if "time" in dataset.coords else np.nan
    grid = Grid.of(scenario.lattice, scenario.ground.georeference())
    field = HeightField(np.asarray(frame.surface, np.float64), grid, str(path), frame.upwind, seconds)
    return replace(field, name=f"{path} at step {int(steps[at])}", known=values)


def _spoken(steps: Any) -> str:
    listed = [str(int(step)) for step in steps]
    return ", ".join(listed if len(listed) <= 12 else [*listed[:3], "…", *listed[-3:]])
