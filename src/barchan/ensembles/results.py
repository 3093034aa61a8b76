"""The frames of an ensemble as one dataset, read when they are used."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray
from xarray.backends import BackendArray
from xarray.core import indexing

from barchan.archive import open_run
from barchan.ensembles.axes import value_label
from barchan.ensembles.plan import Member, Plan, load_plan
from barchan.ensembles.reports import State, member_folder, read_report, state_of
from barchan.ensembles.table import short_names
from barchan.errors import ArchiveError
from barchan.udunits import cf_units

if TYPE_CHECKING:
    import xarray as xr

MISSING = -1
"""Stands for whole numbers of frames that are not there."""

FRAME = ("step", "y", "x")

POINT = "point"


def open_ensemble(folder: str | Path) -> "xr.Dataset":
    """All frames of an ensemble: a dimension for each axis, ``realization``, ``step``, ``y`` and ``x``.

    A grid has a dimension for each varied key, named by its last part; other designs have one dimension
    ``point`` along which the keys are coordinates. Frames are read when asked for; those of members that are
    not at their end are NaN, or −1 among whole numbers. ``status`` tells how far each member is, ``member``
    its name, and the final measures stand beside the fields. Raises ArchiveError where there is no ensemble,
    no finished member, or members of unlike size.
    """
    import xarray as xr

    folder = Path(folder)
    plan = load_plan(folder)
    frame = _Layout(plan)
    done = {m.id: m for m in plan.members if state_of(folder, m.id) == State.DONE}
    if not done:
        raise ArchiveError(f"{folder}: no member is at its end yet")
    runs = {name: open_run(member_folder(folder, name)) for name in done}
    first = next(iter(runs.values()))
    _check_sizes(folder, runs)
    steps = np.unique(np.concatenate([run["step"].values for run in runs.values()]))
    dataset = xr.Dataset(
        coords={**frame.coordinates, "step": steps, "y": first["y"], "x": first["x"]},
        attrs={"title": plan.title, "design": plan.design},
    )
    placed = [(frame.place(member), member.id) for member in plan.members]
    dataset["member"] = (frame.names, frame.filled(placed, lambda name: name, "<U12", ""))
    dataset["status"] = (
        frame.names,
        frame.filled(placed, lambda name: str(state_of(folder, name)), "<U8", State.WAITING),
    )
    for name in _shared_fields(runs):
        lazy = _Frames(name, frame.shape, dict(placed), runs, steps)
        variable = indexing.LazilyIndexedArray(lazy)
        dataset[name] = ((*frame.names, *FRAME), variable, first[name].attrs)
    reports = {name: read_report(folder, name) for name in done}
    known = next(report for report in reports.values() if report is not None)
    for measure in known.units:
        values = frame.filled(
            [(at, name) for at, name in placed if reports.get(name) is not None],
            lambda name, measure=measure: reports[name].last(measure),  # type: ignore[union-attr]
            "f8",
            np.nan,
        )
        about = {**cf_units(known.units[measure]), "long_name": known.titles[measure]}
        dataset[measure] = (frame.names, values, about)
    return dataset


class _Layout:
    """The dimensions of an ensemble, and where each member stands."""

    def __init__(self, plan: Plan) -> None:
        names = short_names(plan)
        count = plan.seeds.count
        realizations = np.arange(count)
        about = {"standard_name": "realization", "units": "1"}
        self.grid = plan.design == "grid"
        self.values = [tuple(axis.values) for axis in plan.axes]
        if self.grid:
            self.names = (*names, "realization")
            self.shape = (*map(len, self.values), count)
            keyed = {
                n: (n, _column(v), {"key": a.key})
                for n, v, a in zip(names, self.values, plan.axes, strict=True)
            }
        else:
            points = plan.points
            self.names = (POINT, "realization")
            self.shape = (len(points), count)
            columns = zip(*points, strict=True)
            keyed = {
                n: (POINT, _column(c), {"key": a.key})
                for n, c, a in zip(names, columns, plan.axes, strict=True)
            }
            keyed[POINT] = (POINT, np.arange(len(points)), {})
        self.coordinates: dict[str, Any] = {**keyed, "realization": ("realization", realizations, about)}

    def place(self, member: Member) -> tuple[int, ...]:
        if not self.grid:
            return member.point, member.realization
        within = (values.index(value) for values, value in zip(self.values, member.values, strict=True))
        return (*within, member.realization)

    def filled(
        self, placed: Sequence[tuple[tuple[int, ...], str]], of: Any, dtype: str, missing: Any
    ) -> NDArray:
        values = np.full(self.shape, missing, dtype)
        for at, name in placed:
            values[at] = of(name)
        return values


def _column(values: Sequence[Any]) -> NDArray:
    """Values of an axis as numbers where they are, else as text."""
    numbers = all(isinstance(value, int | float) and not isinstance(value, bool) for value in values)
    return np.array(values if numbers else [value_label(value) for value in values])


def _check_sizes(folder: Path, runs: "dict[str, xr.Dataset]") -> None:
    sizes = {(run.sizes["y"], run.sizes["x"]) for run in runs.values()}
    if len(sizes) > 1:
        told = ", ".join(f"{rows} × {columns}" for rows, columns in sorted(sizes))
        raise ArchiveError(
            f"{folder}: fields of {told} cells do not fit one dataset; open members one by one, or use the "
            "table of measures"
        )


def _shared_fields(runs: "dict[str, xr.Dataset]") -> list[str]:
    """Fields over (step, y, x) that all members keep, in order."""
    first, *others = runs.values()
    named = [str(name) for name, values in first.data_vars.items() if values.dims == FRAME]
    return [name for name in named if all(name in other for other in others)]


class _Frames(BackendArray):
    """A field of all members, of which only what is asked for is read."""

    def __init__(
        self,
        name: str,
        shape: tuple[int, ...],
        members: dict[tuple[int, ...], str],
        runs: "dict[str, xr.Dataset]",
        steps: NDArray[np.int64],
    ) -> None:
        self.name, self.members, self.runs, self.steps = name, members, runs, steps
        first = next(iter(runs.values()))
        self.shape = (*shape, len(steps), first.sizes["y"], first.sizes["x"])
        kind = first[name].dtype
        complete = all(at in members and members[at] in runs for at in np.ndindex(*shape))
        self.dtype = kind if kind.kind in "if" else np.dtype("float64")
        if kind.kind == "u" and not complete:
            self.dtype = np.dtype("int64")
        self.missing = np.nan if self.dtype.kind == "f" else MISSING

    def __getitem__(self, key: Any) -> Any:
        support = indexing.IndexingSupport.BASIC
        return indexing.explicit_indexing_adapter(key, self.shape, support, self._part)

    def _part(self, key: tuple[Any, ...]) -> NDArray:
        outer, (step, y, x) = key[:-3], key[-3:]
        chosen = [np.atleast_1d(np.arange(n)[k]) for n, k in zip(self.shape[:-3], outer, strict=True)]
        steps = np.atleast_1d(np.arange(len(self.steps))[step])
        rows, columns = (np.arange(n)[k] for n, k in zip(self.shape[-2:], (y, x), strict=True))
        inner = (np.size(rows), np.size(columns))
        values = np.full((*map(len, chosen), len(steps), *inner), self.missing, self.dtype)
        for at in np.ndindex(*map(len, chosen)):
            name = self.members.get(tuple(int(c[i]) for c, i in zip(chosen, at, strict=True)), "")
            if name in self.runs:
                self._read(self.runs[name], values[at], steps, y, x)
        return np.asarray(values.reshape(_result_shape(key, values.shape)))

    def _read(self, run: "xr.Dataset", into: NDArray, steps: NDArray, y: Any, x: Any) -> None:
        """The frames of one member at those of the steps that it has."""
        own = run["step"].values
        for place, number in enumerate(steps):
            found = np.flatnonzero(own == self.steps[number])
            if found.size:
                frame = run[self.name].isel(step=int(found[0])).variable[y, x].values
                into[place] = np.reshape(frame, into[place].shape)


def _result_shape(key: tuple[Any, ...], shape: tuple[int, ...]) -> tuple[int, ...]:
    """The shape without the dimensions that single numbers chose from."""
    return tuple(n for n, k in zip(shape, key, strict=True) if not isinstance(k, int | np.integer))
