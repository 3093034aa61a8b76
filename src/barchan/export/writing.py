"""Writing frames of a run in any of the formats, with the side-car file that tells what the numbers mean."""

import re
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from barchan.errors import ExportError
from barchan.export.formats import Format, format_of
from barchan.export.options import Options
from barchan.export.sidecar import sidecar_of, write_sidecar
from barchan.export.source import Source
from barchan.replacing import replacing
from barchan.scenario import Scenario, nearest
from barchan.words import counted

if TYPE_CHECKING:
    import xarray as xr

Steps = int | Sequence[int] | Literal["all", "last"] | None

FIRST_FIELDS = ("elevation", "ground", "depth")
"""Fields that files of several fields hold first."""

_HIDDEN = re.compile(r"error message = '([^']*)'")

NEAR = 4
"""Saved steps that an error names about one that was not saved."""


def export(
    run: "str | Path | xr.Dataset",
    target: str | Path,
    *,
    step: Steps = None,
    fields: Sequence[str] | str | None = None,
    format: str | None = None,  # noqa: A002
    progress: Callable[[int], None] | None = None,
    **options: Any,
) -> list[Path]:
    """Write frames of a run for another program; returns the files written, the side-car file last.

    ``run`` is a run's folder, or the frames as ``barchan.open_run`` or ``barchan.simulate`` return them. The
    suffix of ``target`` tells the format; ``format`` names it where a suffix has several. Formats of one
    frame a file, and of one field a file, put field and step into the names where there are several.

    ``step`` is a saved step, several, ``"all"`` or ``"last"``; without it formats that hold a series have all
    frames, the others the last one. ``fields`` are names of fields, or ``"all"``; without it formats of one
    field have the elevation, and those of several elevation, ground, depth, the layers, the fields that the
    model keeps and those that show what lies in its layers. Further options are those of
    :class:`barchan.export.Options`. ``progress`` is called with the number of frames of a film that are
    drawn; what it raises ends the export.

    Raises ExportError for an unknown suffix, an option or a field that does not exist, a step that was not
    saved, a missing library and a file that cannot be written, after which nothing half-written stays; and
    ArchiveError where there is no run, or it has no frames.
    """
    path = Path(target)
    chosen = format_of(path, format)
    wishes = _options(options)
    chosen.check(wishes.given)
    dataset, scenario = opened(run)
    try:
        steps = chosen_steps(dataset, step if step is not None else ("all" if chosen.series else "last"))
        source = Source(dataset, scenario, steps, (), wishes, progress=progress, all_steps=steps)
        source = source.only(steps, chosen_fields(source, chosen, fields))
        return _written(path, chosen, source)
    finally:
        if not isinstance(run, type(dataset)):
            dataset.close()


def _options(given: dict[str, Any]) -> Options:
    known = list(Options.__dataclass_fields__)
    for name in given:
        if name not in known:
            raise ExportError(f"{name}: no such option; there are {', '.join(known)}{nearest(name, known)}")
    return Options(**given)


def opened(run: "str | Path | xr.Dataset") -> "tuple[xr.Dataset, Scenario]":
    """The frames of a run and its scenario, from a folder or from what was opened before."""
    import json

    from barchan.archive import open_run
    from barchan.archive.folder import scenario_of
    from barchan.scenario import load_scenario

    if isinstance(run, str | Path):
        return open_run(run), scenario_of(Path(run))
    if "scenario" not in run.attrs:
        raise ExportError("the dataset is no run: it has no attribute 'scenario'")
    dataset = run if "step" in run.dims else run.expand_dims("step")
    return dataset, load_scenario(json.loads(run.attrs["scenario"]))


def chosen_steps(dataset: "xr.Dataset", wanted: Steps) -> tuple[int, ...]:
    """The steps that are wanted; raises ExportError for one that was not saved."""
    saved = [int(step) for step in dataset["step"].values]
    if wanted == "all":
        return tuple(saved)
    if wanted == "last" or wanted is None:
        return (saved[-1],)
    several = [wanted] if isinstance(wanted, int | np.integer) else wanted
    for step in several:
        if step not in saved:
            near = sorted(sorted(saved, key=lambda one: abs(one - int(step)))[:NEAR])
            count = f"{counted(len(saved), 'frame')} from step {saved[0]} to {saved[-1]}"
            raise ExportError(f"step {step} was not saved; near it are {_and(near)} ({count})")
    return tuple(int(step) for step in several)


def _and(numbers: list[int]) -> str:
    return ", ".join(map(str, numbers))


def chosen_fields(source: Source, chosen: Format, wanted: Sequence[str] | str | None) -> tuple[str, ...]:
    """The fields that are wanted, of those that the run has; raises ExportError for another one."""
    from barchan.analysis.fields import field_names

    if chosen.fields == "none":
        if wanted is not None:
            raise ExportError(f"--fields: {chosen.name} holds no fields")
        return ("elevation",)
    known = field_names(source.frame(source.steps[-1]), source.scenario)
    if isinstance(wanted, str):
        wanted = known if wanted == "all" else [name.strip() for name in wanted.split(",")]
    if wanted is None:
        return ("elevation",) if chosen.fields == "one" else _usual_fields(source, known)
    for name in wanted:
        if name not in known:
            raise ExportError(f"no field '{name}'; this run has {', '.join(known)}{nearest(name, known)}")
    if not wanted:
        raise ExportError(f"--fields: none given; this run has {', '.join(known)}")
    return tuple(dict.fromkeys(wanted))


def _usual_fields(source: Source, known: Sequence[str]) -> tuple[str, ...]:
    """Elevation, ground, depth, what frames keep, and what a model that keeps layers shows of them."""
    kept = [str(name) for name in source.dataset.data_vars if name in known]
    of_layers = [field.name for field in source.scenario.new_model().derived if field.of_layers]
    return tuple(dict.fromkeys([*FIRST_FIELDS, *kept, *of_layers]))


def _written(path: Path, chosen: Format, source: Source) -> list[Path]:
    assert source.grid.shape  # a grid that cannot be made is refused before anything is written
    files: list[tuple[Path, Source]] = [(path, source)]
    if not chosen.series:
        files = _split(path, source, by_field=chosen.fields == "one")
    values: dict[str, Any] = {}
    try:
        if not path.parent.is_dir():
            raise ExportError(f"cannot write {path}: there is no folder {path.parent}")
        if "limits" in chosen.options:
            for name in source.fields:
                source.range_of(name)
        for file, part in files:
            if file.is_dir():
                raise ExportError(f"cannot write {file}: it is a folder")
            with replacing(file) as partial:
                values = _joined(values, chosen.write(partial, part))
        beside = _reference_files(chosen, source, files)
        listed = [(file, part.steps, part.fields) for file, part in files]
        car = write_sidecar(path, sidecar_of(chosen, source, listed, values))
    except OSError as error:
        raise ExportError(f"cannot write {path}: {_reason(error)}") from error
    return [*(file for file, _ in files), *beside, car]


def _joined(told: dict[str, Any], more: dict[str, Any]) -> dict[str, Any]:
    """What the side-car file says of several files: tables of fields have the fields of all of them."""
    tables = {
        name: {**told[name], **value}
        for name, value in more.items()
        if isinstance(value, dict) and isinstance(told.get(name), dict)
    }
    return {**told, **more, **tables}


def _reference_files(chosen: Format, source: Source, files: list[tuple[Path, Source]]) -> list[Path]:
    """Write the reference system into a .prj file beside each file that cannot hold it itself."""
    if not chosen.reference_beside or source.grid.wkt is None:
        return []
    from rasterio.crs import CRS

    text = CRS.from_wkt(source.grid.wkt).to_wkt(version="WKT1_ESRI")
    written = [file.with_suffix(".prj") for file, _ in files]
    for path in written:
        with replacing(path) as partial:
            partial.write_text(text + "\n", "utf-8")
    return written


def _reason(error: OSError) -> str:
    """The cause of an error in writing, in the system's words; HDF5 hides these in a longer text."""
    hidden = _HIDDEN.search(str(error))
    return hidden[1] if hidden else error.strerror or str(error)


def _split(path: Path, source: Source, by_field: bool) -> list[tuple[Path, Source]]:
    """A file for each frame, and for each field where a file holds one; names tell which."""
    groups = [(name,) for name in source.fields] if by_field else [source.fields]
    digits = len(str(max(source.steps)))
    made = []
    for step in source.steps:
        for group in groups:
            name = f"-{group[0]}" if len(groups) > 1 else ""
            number = f"-{step:0{digits}d}" if len(source.steps) > 1 else ""
            made.append(
                (path.with_name(f"{path.stem}{name}{number}{path.suffix}"), source.only([step], group))
            )
    return made
