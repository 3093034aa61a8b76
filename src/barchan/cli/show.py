"""``barchan show``: pictures of a run."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter
from cyclopts.validators import Number

from barchan.errors import BarchanError

if TYPE_CHECKING:
    import xarray as xr

View = Literal["map", "contours", "profile", "space-time", "series", "paths", "hops"]
Colours = Literal["perceptual", "grey", "red-green"]


def show(
    run: Path,
    /,
    *,
    view: View = "map",
    step: int | None = None,
    out: Path | None = None,
    colours: Colours = "perceptual",
    limits: Annotated[tuple[float, float] | None, Parameter(negative=())] = None,
    interval: Annotated[float | None, Parameter(validator=Number(gt=0))] = None,
    count: Annotated[int, Parameter(validator=Number(gte=1, lte=1000))] = 10,
    smoothing: Annotated[float | None, Parameter(validator=Number(gte=0, lte=1000))] = None,
    at: Annotated[float | None, Parameter(validator=Number(gte=0, lte=1))] = None,
    bare: bool = True,
    layers: bool = True,
    grains: Annotated[int | None, Parameter(validator=Number(gte=1, lte=100_000))] = None,
    field: str | None = None,
) -> None:
    """Draw a frame of a run, a section, or its change in time.

    Parameters
    ----------
    run
        The run's folder.
    view
        A hill-shaded map, contours, a section along the wind with its shadow zones, that section over time,
        the measures over time, paths of grains over the surface and from the side, or how long, high and
        steep their hops are; the last two for models that follow grains.
    step
        The frame nearest to this step; the last one without it.
    out
        The picture's file (PNG, PDF or SVG by its ending); in the run's folder without it.
    colours
        Colour map: perceptual, grey, or red-green with red the highest.
    limits
        Lowest and highest elevation (m), or value of the field, of the colour scale; the frame's own without
        it.
    interval
        Contour interval (m), instead of a number of contours.
    count
        Number of contours.
    smoothing
        Width (cells) over which the surface, or the field, is smoothed before drawing; 1 for contours, 0 for
        the rest; the curve of a field along a section is smoothed over 2 at least.
    at
        Where the section lies across the wind, from 0 to 1; through the highest stack without it.
    bare
        Show bare ground in grey on maps.
    grains
        How many grains to follow: 20 for paths, 1000 for hops without it.
    layers
        Draw the model's layers on maps: plants, light to dark green.
    field
        Draw this field instead of the elevation (map), or below it (profile): one that frames carry, such as
        sand, or one derived, such as slope, shadow, hop, speedup, stress, effectiveness; an unknown name is
        answered with those that the run has.
    """
    from barchan.analysis.fields import field_of
    from barchan.archive import open_run
    from barchan.archive.folder import scenario_of
    from barchan.cli.terminal import save_picture

    if limits is not None and not limits[0] < limits[1]:
        raise BarchanError(f"--limits {limits[0]:g} {limits[1]:g}: the lowest must be below the highest")
    if field is not None and view not in ("map", "profile"):
        raise BarchanError(f"--field {field}: a field is drawn as --view map or profile, not {view}")
    scenario = scenario_of(run)
    with open_run(run) as dataset:
        frame = _frame(dataset, step)
        width = smoothing if smoothing is not None else float(view == "contours")
        values = None if field is None else field_of(frame, scenario, field)
        if view == "map" and values is not None:
            from barchan.figures.fields import field_map

            figure = field_map(values, frame, scenario, colours=colours, limits=limits, smoothing=width)
        elif view == "map":
            from barchan.figures.maps import relief_map

            figure = relief_map(
                frame,
                scenario,
                colours=colours,
                limits=limits,
                smoothing=width,
                show_bare=bare,
                layers=layers,
            )
        elif view == "contours":
            from barchan.figures.maps import contour_map

            figure = contour_map(
                frame,
                scenario,
                interval=interval,
                count=count,
                colours=colours,
                limits=limits,
                smoothing=width,
            )
        elif view == "profile":
            from barchan.figures.sections import profile

            figure = profile(frame, scenario, at=at, smoothing=width, field=values)
        elif view == "space-time":
            from barchan.figures.sections import space_time

            figure = space_time(dataset, scenario, at=at, colours=colours)
        elif view in ("paths", "hops"):
            from barchan.analysis.grain_paths import grain_paths
            from barchan.figures.paths import hop_histograms, path_view

            followed = grain_paths(frame, scenario, grains or (20 if view == "paths" else 1000))
            figure = (path_view if view == "paths" else hop_histograms)(frame, scenario, followed)
        else:
            from barchan.analysis.time_series import measure_series
            from barchan.figures.series import time_series

            figure = time_series(measure_series(dataset, scenario), scenario)
    name = view if field is None else f"{view}-{field}"
    whole = view in ("space-time", "series")
    save_picture(figure, out or run / (f"{name}.png" if whole else f"{name}-{int(frame['step'])}.png"))


def _frame(dataset: "xr.Dataset", step: int | None) -> "xr.Dataset":
    if step is None:
        return dataset.isel(step=-1).load()
    return dataset.sel(step=step, method="nearest").load()
