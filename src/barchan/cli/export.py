"""``barchan export``: frames of a run for other programs."""

from dataclasses import asdict, dataclass
from datetime import datetime
from pathlib import Path
from typing import Annotated, Any

from cyclopts import Parameter

from barchan.errors import ExportError


def _option(text: str) -> Parameter:
    """An option that is left out unless it is given."""
    return Parameter(help=text, negative=())


@Parameter(name="*")
@dataclass(frozen=True)
class Wishes:
    """How frames are changed and written; each format takes some of these options."""

    smooth: Annotated[
        float | None,
        _option(
            "Smooth surface and layers over this many cells; their mean stays but for rounding. Whole slabs "
            "make terraces, which 1 to 2 cells remove."
        ),
    ] = None
    cells: Annotated[
        tuple[int, int] | None,
        _option("Columns and rows to bring the field onto: means over areas, so that the volume stays."),
    ] = None
    close: Annotated[
        bool, _option("Repeat the first row and column of periodic directions at their end, for engines.")
    ] = False
    limits: Annotated[
        tuple[float, float] | None,
        _option(
            "Values that 0 and 65535 stand for in 16-bit files, the same for tiles that belong together; "
            "the extremes of all written frames without it."
        ),
    ] = None
    flip: Annotated[bool, _option("Southern row first (height maps), as Unity shows them.")] = False
    exaggerate: Annotated[float | None, _option("Factor of a mesh's heights over the lowest.")] = None
    scale: Annotated[
        float | None,
        _option("Units of a mesh to the metre; slicers read units as mm, so 10 prints 1 m as 1 cm."),
    ] = None
    split: Annotated[
        int | None,
        _option(
            "Split a .glb mesh into parts of at most this many vertices along a side, 2 to 255: some "
            "programs read no more than 65,535 of a mesh."
        ),
    ] = None
    colour_by: Annotated[
        str | None,
        _option(
            "Field that colours a mesh (.glb, .ply); natural without it. A mesh that moves has one colour "
            "without it; with it frames follow one another, each with its own colours."
        ),
    ] = None
    base: Annotated[
        float | None,
        _option("Thickness (m) of a solid below its lowest point; a tenth of its relief without it."),
    ] = None
    epoch: Annotated[
        datetime | None,
        _option("Date and time of step 0 in NetCDF; 2000-01-01, said to be arbitrary, without it."),
    ] = None
    at: Annotated[
        float | None,
        _option("Where a section lies across the wind, 0 to 1; through the highest stack without it."),
    ] = None
    frames_per_second: Annotated[
        float | None, _option("Frames a second of a film or animation; 12 without it.")
    ] = None
    pixels: Annotated[int | None, _option("Pixels on the longer side of a film, about; 512 without it.")] = (
        None
    )
    size: Annotated[tuple[float, float] | None, _option("Width and height (cm) of a picture.")] = None
    dpi: Annotated[int | None, _option("Dots per inch of a picture; 150 without it.")] = None


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
    .r16, .r32, .exr (height maps), .glb, .obj, .ply, .stl (meshes), .csv (measures, sections), .mp4, .webp,
    .gif (films), .pdf, .svg (pictures). A file beside it, named .json after it, tells what the numbers mean.

    Parameters
    ----------
    run
        The run's folder.
    target
        The file to write. Where there are several frames or fields to a file each, their names tell which.
    step
        A saved step, several as 100,200, all or last. Without it formats of a series (.vtkhdf, .pvd, .nc,
        measures, films) have all frames, the others the last.
    fields
        Names of fields with commas between, or all: layers, fields of the model, or derived ones such as
        slope, depth, shadow. Without it the elevation, and in formats of several fields ground, depth and
        what the frames keep.
    format
        Name of the format where a suffix has several: geotiff or tiff32 (.tif), png16 or picture (.png),
        measures or section (.csv).
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
