"""``barchan export``: frames of a run for other programs."""

from dataclasses import asdict, dataclass
from datetime import datetime
from pathlib import Path
from typing import Annotated, Any

from cyclopts import Parameter

from barchan.errors import ExportError
from barchan.export.options import WORDING


def _option(name: str) -> Parameter:
    """An option that is left out unless it is given."""
    return Parameter(help=WORDING[name].meaning, negative=())


@Parameter(name="*")
@dataclass(frozen=True)
class Wishes:
    """How frames are changed and written; each format takes some of these options."""

    smooth: Annotated[float | None, _option("smooth")] = None
    cells: Annotated[tuple[int, int] | None, _option("cells")] = None
    close: Annotated[bool, _option("close")] = False
    limits: Annotated[tuple[float, float] | None, _option("limits")] = None
    flip: Annotated[bool, _option("flip")] = False
    exaggerate: Annotated[float | None, _option("exaggerate")] = None
    scale: Annotated[float | None, _option("scale")] = None
    split: Annotated[int | None, _option("split")] = None
    colour_by: Annotated[str | None, _option("colour_by")] = None
    base: Annotated[float | None, _option("base")] = None
    epoch: Annotated[datetime | None, _option("epoch")] = None
    at: Annotated[float | None, _option("at")] = None
    frames_per_second: Annotated[float | None, _option("frames_per_second")] = None
    pixels: Annotated[int | None, _option("pixels")] = None
    size: Annotated[tuple[float, float] | None, _option("size")] = None
    dpi: Annotated[int | None, _option("dpi")] = None


def export(
    run: Path,
    target: Path,
    /,
    *,
    step: str | None = None,
    fields: str | None = None,
    format: str | None = None,  # noqa: A002
    wishes: Wishes = Wishes(),
) -> None:
    """Write frames of a run for another program: GIS, ParaView, Blender, engines, printers, tables.

    The suffix of the file tells the format: .vtkhdf, .pvd, .vti (ParaView), .nc, .tif, .asc (GIS), .png,
    .r16, .r32, .exr (height maps), .glb, .obj, .ply, .stl (meshes), .csv (measures, sections, layers), .mp4,
    .webp, .gif (films), .pdf, .svg (pictures). A file beside it, named .json after it, tells what the numbers
    mean.

    Parameters
    ----------
    run
        The run's folder.
    target
        The file to write. Where there are several frames or fields to a file each, their names tell which.
    step
        A saved step, several as 100,200, all or last. Without it formats of a series (.vtkhdf, .pvd, .nc,
        measures, layers, films) have all frames, the others the last.
    fields
        Names of fields with commas between, as in elevation,slope,shadow, or all. Every run has elevation,
        ground, depth, slope and its layers, such as sand; the others depend on its model and stand under
        Fields on the model's page of the documentation. An unknown name is answered with all that the run
        has. Without it the elevation, and in formats of several fields ground, depth and what the frames
        keep.
    format
        Name of the format where a suffix has several: geotiff or tiff32 (.tif), png16 or picture (.png),
        measures, section or layers (.csv).
    """
    from barchan.cli.terminal import console
    from barchan.export import export as write

    given: dict[str, Any] = asdict(wishes)
    for path in write(run, target, step=_steps(step), fields=fields, format=format, **given):
        console.print(str(path))


def _steps(text: str | None) -> Any:
    if text is None or text in ("all", "last"):
        return text
    try:
        return [int(part) for part in text.split(",")]
    except ValueError:
        raise ExportError(
            f"--step {text}: allowed: a saved step, several with commas between, all or last"
        ) from None
