"""glTF whose surface moves: the first frame as a mesh, each later one as a shape that it turns into."""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.errors import ExportError
from barchan.export.glb import AXES, linear, name_of, parts_facts, turned
from barchan.export.gltf import Gltf
from barchan.export.mesh import Part, mesh_facts, parts_of, quads, surface_of, triangles
from barchan.export.source import Source

MOST_BYTES = 1_000_000_000
"""Size of a file, about, up to which it is written: it is made in memory, and readers hold it there too."""

BYTES = 24
"""Bytes of a vertex of one frame: place and normal."""


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write the surfaces of all chosen frames, y up and north towards -z, and the animation over them.

    Raises ExportError for a single frame, and for more vertices and frames than fit into a file.
    """
    from barchan.figures.film import RATE

    _refuse(source)
    rate = source.options.frames_per_second or RATE
    level, _ = source.range_of("elevation")
    surfaces = (surface_of(source.only([step], source.fields), level) for step in source.steps)
    frames = [(turned(surface.vertices), turned(surface.normals)) for surface in surfaces]
    shape, scene = source.grid.shape, Gltf(_colour(source))
    parts = parts_of(shape, source.options.split)
    nodes = [_part(scene, part, frames, shape, name_of(part, parts, source)) for part in parts]
    seconds = (np.arange(len(frames)) / rate).astype("<f4")
    scene.animate("run", nodes, seconds, np.eye(len(frames), dtype="<f4")[:, 1:])
    scene.write(path)
    facts = {"frames_per_second": rate, "shapes": "heights and normals of each frame less those of the first"}
    return {**mesh_facts(source, AXES), **parts_facts(parts), **facts}


def _part(
    scene: Gltf,
    part: Part,
    frames: list[tuple[NDArray[np.float32], NDArray[np.float32]]],
    shape: tuple[int, int],
    name: str,
) -> int:
    """Add a part of the surface in all frames; returns the number of its node."""
    names = ("POSITION", "NORMAL")
    first, *later = [dict(zip(names, frame, strict=True)) for frame in frames]

    def added(values: NDArray[np.float32], of: str) -> int:
        return scene.array(part.of(values, shape), extent=of == "POSITION")

    attributes = {of: added(first[of], of) for of in names}
    targets = [{of: added(frame[of] - first[of], of) for of in names} for frame in later]
    return scene.mesh(name, attributes, scene.triangles(triangles(quads(part.shape)), part.vertices), targets)


def _refuse(source: Source) -> None:
    frames, (rows, columns) = len(source.steps), source.grid.shape
    if frames < 2:
        raise ExportError("an animation needs two frames; choose more with --step, or leave --format out")
    size = BYTES * frames * rows * columns
    if size > MOST_BYTES:
        raise ExportError(
            f"{columns} × {rows} cells in {frames} frames make a file of {size / 1e9:.1f} GB; allowed: up to "
            f"{MOST_BYTES / 1e9:g} GB, so fewer --cells, or fewer frames by --step"
        )


def _colour(source: Source) -> tuple[float, float, float]:
    """The colour in the middle of the material's range; colours at vertices would stay in place."""
    from barchan.figures.style import colour_map, material_of

    middle = np.asarray(colour_map("natural", material_of(source.scenario))(0.5))[:3]
    red, green, blue = linear(middle.astype("<f4")).tolist()
    return red, green, blue
