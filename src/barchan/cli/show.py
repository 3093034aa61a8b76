"""``barchan show``: pictures of a run."""

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter
from cyclopts.validators import Number

from barchan.cli.info import MOST_EVENTS
from barchan.errors import BarchanError

if TYPE_CHECKING:
    import xarray as xr

    from barchan.simulation import Record

View = Literal["map", "contours", "profile", "space-time", "series", "paths", "hops"]
Colours = Literal["perceptual", "grey", "red-green"]


def show(
    run: Path,
    /,
    *,
    view: View = "map",
    step: int | None = None,
    out: Path | None = None,
    colours: Colours | None = None,
    limits: Annotated[tuple[float, float] | None, Parameter(negative=())] = None,
    interval: Annotated[float | None, Parameter(validator=Number(gt=0))] = None,
    count: Annotated[int | None, Parameter(validator=Number(gte=1, lte=1000))] = None,
    smoothing: Annotated[float | None, Parameter(validator=Number(gte=0, lte=1000))] = None,
    at: Annotated[float | None, Parameter(validator=Number(gte=0, lte=1))] = None,
    bare: bool | None = None,
    layers: bool | None = None,
    grains: Annotated[int | None, Parameter(validator=Number(gte=1, lte=100_000))] = None,
    field: str | None = None,
) -> None:
    """Draw a frame of a run, a section, or its measures over time.

    Parameters
    ----------
    run
        The run's folder.
    view
        A hill-shaded map, contours, a section along the wind with its shadow zones, that section over time,
        the measures over time, paths of grains over the surface and from the side, or lengths, heights and
        impact angles of their hops; the last two for models that follow grains.
    step
        The frame nearest to this step; the last one without it.
    out
        The picture's file (PNG, PDF or SVG by its ending); in the run's folder without it.
    colours
        Colour map of maps, contours and space-time: perceptual (without it), grey, or red-green with red the
        highest.
    limits
        Lowest and highest elevation (m), or value of the field, of the colour scale of maps and contours; the
        frame's own without it.
    interval
        Contour interval (m), instead of a number of contours.
    count
        Number of contours; 10 without it.
    smoothing
        Cells over which the surface, or the field, is smoothed for maps, contours and profiles:
        1 for contours, 0 for the rest without it; the curve of a field along a section is smoothed over 2
        cells at least.
    at
        Where the section (profile, space-time) lies across the wind, from 0 to 1; through the highest stack
        without it.
    bare
        Show bare ground in grey on maps; yes without it.
    grains
        Number of grains to follow for paths and hops: 20 for paths, 1000 for hops without it.
    layers
        Draw the model's layers over the surface on maps, such as plants, light to dark green; yes without
        it.
    field
        Draw this field instead of the elevation (map), or below it (profile): one that frames carry, such as
        sand, or one derived, such as slope, shadow, hop, speedup, stress, effectiveness; an unknown name is
        answered with those that the run has.
    """
    from barchan.analysis.fields import field_of, scenario_at
    from barchan.archive import open_run
    from barchan.archive.folder import scenario_of
    from barchan.cli.terminal import print_note, save_picture
    from barchan.cli.views import Source, view_of

    if limits is not None and not limits[0] < limits[1]:
        raise BarchanError(f"--limits {limits[0]:g} {limits[1]:g}: the lowest must be below the highest")
    chosen = view_of(view, field)
    options = {
        "step": step,
        "colours": colours,
        "limits": limits,
        "interval": interval,
        "count": count,
        "smoothing": smoothing,
        "at": at,
        "bare": bare,
        "layers": layers,
        "grains": grains,
    }
    given = {name: value for name, value in options.items() if value is not None}
    chosen.check(given)
    given.pop("step", None)
    scenario = scenario_of(run)
    with open_run(run) as dataset:
        frame = _frame(dataset, step)
        shown = None if field is None else field_of(frame, scenario, field)
        if chosen.of_frame:
            scenario = scenario_at(frame, scenario)
        for record in _events(dataset, int(frame["step"])):
            print_note(f"changed {record}")
        figure = chosen.draw(Source(scenario, dataset, frame, shown), **given)
    name = view if field is None else f"{view}-{field}"
    file = f"{name}-{int(frame['step'])}.png" if chosen.of_frame else f"{name}.png"
    save_picture(figure, out or run / file)


def _frame(dataset: "xr.Dataset", step: int | None) -> "xr.Dataset":
    if step is None:
        return dataset.isel(step=-1).load()
    return dataset.sel(step=step, method="nearest").load()


def _events(dataset: "xr.Dataset", step: int) -> list["Record"]:
    """The changes of wind and parameters before a step, the last of them."""
    from barchan.simulation import Record, SetParameter, SetWind

    records = [Record.from_data(data) for data in json.loads(dataset.attrs["events"])]
    told = [r for r in records if isinstance(r.event, SetParameter | SetWind) and r.step < max(step, 1)]
    return told[-MOST_EVENTS:]
