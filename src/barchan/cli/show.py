"""``barchan show``: pictures of a run."""

import json
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from barchan.cli.drawing import Drawing, Size
from barchan.cli.info import MOST_EVENTS

if TYPE_CHECKING:
    import xarray as xr

    from barchan.simulation import Record

View = Literal["map", "contours", "oblique", "profile", "space-time", "series", "paths", "hops"]


def show(
    run: Path,
    /,
    *,
    view: View = "map",
    field: str | None = None,
    drawing: Drawing = Drawing(),  # noqa: B008 (frozen)
    size: Size = Size(),  # noqa: B008 (frozen)
    out: Path | None = None,
) -> None:
    """Draw a frame of a run, a section, or its measures over time.

    Parameters
    ----------
    run
        The run's folder.
    view
        A hill-shaded map, contours, the surface seen obliquely from the south, a section along the wind with
        its shadow zones, that section over time, the measures over time, paths of grains over the surface
        and from the side, or lengths, heights and impact angles of their hops; the last two for models that
        follow grains.
    field
        Draw this field instead of the elevation (map), or below it (profile): one that frames carry, such as
        sand, or one derived, such as slope, shadow, hop, speedup, stress, effectiveness, and of snow
        threshold_wind, age, loose_depth, density; an unknown name is answered with those that the run has.
    out
        The picture's file (PNG, PDF or SVG by its ending); in the run's folder without it.
    """
    from barchan.analysis.fields import field_of, scenario_at
    from barchan.archive import open_run
    from barchan.archive.folder import scenario_of
    from barchan.cli.terminal import print_note, save_picture
    from barchan.cli.views import Source, view_of

    given = drawing.given()
    chosen = view_of(view, field)
    chosen.check(given)
    step = given.pop("step", None)
    scenario = scenario_of(run)
    with open_run(run) as dataset:
        frame = _frame(dataset, step)
        shown = None if field is None else field_of(frame, scenario, field)
        if chosen.of_frame:
            scenario = scenario_at(frame, scenario)
        for record in _events(dataset, int(frame["step"])):
            print_note(f"changed {record}")
        figure = chosen.draw(Source(scenario, dataset, frame, shown), **given)
    size.apply(figure)
    name = view if field is None else f"{view}-{field}"
    file = f"{name}-{int(frame['step'])}.png" if chosen.of_frame else f"{name}.png"
    save_picture(figure, out or run / file, size.dpi)


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
