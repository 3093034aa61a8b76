"""The formats that frames can be written in: a table, one module each."""

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from barchan.errors import ExportError
from barchan.export.options import flag
from barchan.scenario import nearest

if TYPE_CHECKING:
    from barchan.export.source import Source

FieldsTaken = Literal["one", "many", "none"]

Writer = Callable[[Path, "Source"], dict[str, Any]]
"""Writes a file and returns what the side-car file says of its values."""

GRIDS = ("smooth", "cells", "close")
WHOLE = (*GRIDS, "limits", "flip")
PICTURES = (*GRIDS, "flip")
MESHES = (*GRIDS, "exaggerate", "scale")
FILMS = ("frames_per_second", "pixels")
DRAWN = ("size", "dpi")


@dataclass(frozen=True)
class Format:
    """A row of the table."""

    name: str
    suffixes: tuple[str, ...]
    meaning: str
    module: str
    """Module of this package whose function ``write`` writes it."""
    series: bool = False
    """Whether all chosen frames go into one file; otherwise each frame has its own."""
    fields: FieldsTaken = "many"
    """Fields that a file holds."""
    options: tuple[str, ...] = ()
    """Names of the options that it takes; see ``Options``."""
    reference_beside: bool = False
    """Whether the reference system of the coordinates stands in a .prj file beside it."""
    needs: tuple[str, ...] = ()
    """Modules that must be installed, and the names that they are installed by."""

    @property
    def write(self) -> Writer:
        """The function that writes it."""
        writer: Writer = import_module(f"barchan.export.{self.module}").write
        return writer

    def check(self, given: dict[str, Any]) -> None:
        """Raise ExportError for an option that this format does not take, and where a library is missing."""
        for name in given:
            if name not in self.options:
                taken = ", ".join(map(flag, self.options)) or "none"
                raise ExportError(
                    f"{flag(name)}: {self.name} does not take it; of these options it takes {taken}"
                )
        if self.needs and find_spec(self.needs[0]) is None:
            other = ALTERNATIVES.get(self.name, "")
            raise ExportError(
                f"{self.name} is written with {self.needs[1]}, which is not installed; "
                f"install it with: python -m pip install {self.needs[1]}{other}"
            )


ALTERNATIVES = {
    "geotiff": "; or write --format tiff32, .asc or .nc, which need nothing more",
    "exr": "; or write .tif with --format tiff32, which needs nothing more",
    "mp4": "; or write .webp, which needs nothing more",
}
"""What to write instead where a library is missing."""

FORMATS = (
    Format("vtkhdf", (".vtkhdf",), "ParaView: all frames in one file", "vtkhdf", True, "many", GRIDS),
    Format(
        "pvd", (".pvd",), "ParaView, VisIt: a list of .vti files, one a frame", "pvd", True, "many", GRIDS
    ),
    Format("vti", (".vti",), "ParaView, VisIt: one frame", "vti", False, "many", GRIDS),
    Format(
        "netcdf",
        (".nc",),
        "CF-NetCDF: QGIS, ParaView, Panoply, xarray",
        "netcdf",
        True,
        "many",
        (*GRIDS, "epoch"),
    ),
    Format(
        "geotiff",
        (".tif", ".tiff"),
        "GeoTIFF, cloud-optimised, a field a band: QGIS, ArcGIS",
        "geotiff",
        False,
        "many",
        GRIDS,
        needs=("rasterio", "rasterio"),
    ),
    Format("asc", (".asc",), "ESRI ASCII grid", "asc", False, "one", GRIDS, reference_beside=True),
    Format("png16", (".png",), "16-bit height map: engines, Blender", "png16", False, "one", WHOLE),
    Format("r16", (".r16", ".raw"), "raw 16-bit height map: Unreal, Unity", "raw", False, "one", WHOLE),
    Format("r32", (".r32",), "raw 32-bit height map: World Machine, Gaea", "raw", False, "one", PICTURES),
    Format(
        "tiff32",
        (".tif", ".tiff"),
        "plain 32-bit TIFF without coordinates: Blender, Gaea",
        "tiff32",
        False,
        "one",
        PICTURES,
    ),
    Format(
        "exr",
        (".exr",),
        "32-bit OpenEXR: Blender, Houdini",
        "exr",
        False,
        "one",
        PICTURES,
        needs=("OpenEXR", "openexr"),
    ),
    Format(
        "glb",
        (".glb",),
        "mesh with normals and colours: Blender, engines",
        "glb",
        False,
        "none",
        (*MESHES, "split", "colour_by"),
    ),
    Format(
        "animation",
        (".glb",),
        "mesh that moves over the frames: Blender, the web",
        "glb_animation",
        True,
        "none",
        (*MESHES, "split", "colour_by", "frames_per_second"),
    ),
    Format("obj", (".obj",), "mesh as text", "obj", False, "none", MESHES),
    Format(
        "ply",
        (".ply",),
        "mesh with fields at its vertices",
        "ply",
        False,
        "many",
        (*MESHES, "colour_by"),
    ),
    Format("stl", (".stl",), "closed solid to print", "stl", False, "none", (*MESHES, "base")),
    Format("measures", (".csv",), "table of measures, a row a frame", "measures", True, "none"),
    Format("section", (".csv",), "table of a section along the wind", "section", False, "many", ("at",)),
    Format("layers", (".csv",), "table of the layers along that section", "layers", True, "none", ("at",)),
    Format("mp4", (".mp4",), "film", "film", True, "none", FILMS, needs=("av", "av")),
    Format("film", (".webp", ".gif"), "film", "film", True, "none", FILMS),
    Format("picture", (".pdf", ".svg", ".png"), "map with title and scale", "picture", False, "one", DRAWN),
)
"""Every format; of those with the same suffix the first one is meant where no name is given."""


def format_of(path: Path, name: str | None = None) -> Format:
    """The format of a file's suffix, or the named one; raises ExportError where there is none."""
    if name is not None:
        for known in FORMATS:
            if known.name == name:
                return known
        names = [known.name for known in FORMATS]
        raise ExportError(
            f"--format {name}: no such format; there are {', '.join(names)}{nearest(name, names)}"
        )
    suffix = path.suffix.lower()
    for known in FORMATS:
        if suffix in known.suffixes:
            return known
    given = (
        f"no format is written to '{path.suffix}'" if suffix else "the file has no suffix to tell its format"
    )
    raise ExportError(f"{path}: {given}; there are:\n{listed()}")


def listed() -> str:
    """The formats in lines: suffixes, name, meaning."""
    rows = [(" ".join(one.suffixes), one.name, one.meaning) for one in FORMATS]
    widths = [max(len(row[column]) for row in rows) for column in (0, 1)]
    return "\n".join(f"  {a:{widths[0]}}  {b:{widths[1]}}  {c}" for a, b, c in rows)


DATA_SUFFIXES = frozenset(
    suffix
    for one in FORMATS
    if one.name not in ("film", "mp4", "picture", "png16")
    for suffix in one.suffixes
)
"""Suffixes that promise numbers, under which no picture is written."""
