"""glTF whose surface moves: one mesh that turns into shapes, or coloured meshes that follow one another."""

from pathlib import Path
from typing import Any

from barchan.errors import ExportError
from barchan.export import glb_coloured_frames, glb_shapes
from barchan.export.source import Source

MOST_BYTES = 1_000_000_000
"""Size of a file, about, up to which it is written: it is made in memory, and readers hold it there too."""


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write the surfaces of all chosen frames, y up and north towards -z, and the animation over them.

    Shapes of a mesh have its colours in Blender, whatever they are; so a surface that is coloured by a field
    has a mesh for each frame. Raises ExportError for a single frame, and for more vertices and frames than
    fit into a file.
    """
    from barchan.figures.film import RATE

    kind = glb_shapes if source.options.colour_by is None else glb_coloured_frames
    _refuse(source, kind.BYTES)
    rate = source.options.frames_per_second or RATE
    return {**kind.write(path, source, rate), "frames_per_second": rate}


def _refuse(source: Source, vertex_bytes: int) -> None:
    frames, (rows, columns) = len(source.steps), source.grid.shape
    if frames < 2:
        raise ExportError("an animation needs two frames; choose more with --step, or leave --format out")
    size = vertex_bytes * frames * rows * columns
    if size > MOST_BYTES:
        raise ExportError(
            f"{columns} × {rows} cells in {frames} frames make a file of {size / 1e9:.1f} GB; allowed: up to "
            f"{MOST_BYTES / 1e9:g} GB, so fewer --cells, or fewer frames by --step"
        )
