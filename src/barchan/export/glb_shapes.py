"""glTF whose surface glides: the first frame as a mesh, each later one as a shape that it turns into."""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.export.glb import AXES, linear, name_of, parts_facts, turned
from barchan.export.gltf import Gltf, Track
from barchan.export.mesh import Part, mesh_facts, parts_of, quads, surface_of, triangles
from barchan.export.source import Source

BYTES = 24
"""Bytes of a vertex of one frame: place and normal."""


def write(path: Path, source: Source, rate: float) -> dict[str, Any]:
    """Write a mesh of one colour and its shapes, at ``rate`` frames a second."""
    level, _ = source.range_of("elevation")
    surfaces = (surface_of(source.only([step], source.fields), level) for step in source.steps)
    frames = [(turned(surface.vertices), turned(surface.normals)) for surface in surfaces]
    shape, scene = source.grid.shape, Gltf(_colour(source))
    parts = parts_of(shape, source.options.split)
    nodes = [_part(scene, part, frames, shape, name_of(part, parts, source)) for part in parts]
    seconds = (np.arange(len(frames)) / rate).astype("<f4")
    scene.animate("run", [Track(nodes, "weights", seconds, np.eye(len(frames), dtype="<f4")[:, 1:])])
    scene.write(path)
    facts = {"shapes": "heights and normals of each frame less those of the first"}
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


def _colour(source: Source) -> tuple[float, float, float]:
    """The colour in the middle of the material's range; colours at vertices would stay in place."""
    from barchan.figures.style import colour_map, material_of

    middle = np.asarray(colour_map("natural", material_of(source.scenario))(0.5))[:3]
    red, green, blue = linear(middle.astype("<f4")).tolist()
    return red, green, blue
