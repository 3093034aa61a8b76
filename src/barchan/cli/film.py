"""``barchan film``: an animated picture of a run."""

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter
from cyclopts.validators import Number

from barchan.cli.drawing import Colours


def film(
    run: Path,
    /,
    *,
    out: Path | None = None,
    frames_per_second: Annotated[float, Parameter(validator=Number(gte=0.1, lte=100))] = 12.0,
    pixels: Annotated[int, Parameter(validator=Number(gte=16, lte=8192))] = 512,
    colours: Colours = "natural",
    smoothing: Annotated[float, Parameter(validator=Number(gte=0, lte=1000))] = 0.8,
    follow: Annotated[bool, Parameter(negative=())] = False,
    layers: bool = True,
) -> None:
    """Write an animated picture of a run.

    Parameters
    ----------
    run
        The run's folder.
    out
        The film's file, .webp, .gif or, with the library av, .mp4; film.webp in the run's folder without it.
    frames_per_second
        Frames shown in a second.
    pixels
        Pixels on the longer side, about; a film has no size in cm.
    colours
        Colours of elevation: sand, light upwards; perceptual, grey, or red-green with red the highest.
    smoothing
        Width (cells) over which the surface is smoothed before drawing.
    follow
        Let the colour scale follow each frame instead of holding for the whole run.
    layers
        Draw the model's layers over the surface: plants, light to dark green.
    """
    from barchan.archive import open_run
    from barchan.archive.folder import scenario_of
    from barchan.cli.terminal import console
    from barchan.figures.film import film as write

    path = out or run / "film.webp"
    scenario = scenario_of(run)
    with open_run(run) as dataset:
        write(
            dataset,
            scenario,
            path,
            frames_per_second=frames_per_second,
            pixels=pixels,
            colours=colours,
            smoothing=smoothing,
            follow=follow,
            layers=layers,
        )
    console.print(str(path))
