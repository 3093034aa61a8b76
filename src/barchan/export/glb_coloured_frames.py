"""glTF whose surface changes with its colours: a mesh for each frame, of which one at a time has its size."""

from pathlib import Path
from typing import Any

import numpy as np

from barchan.export.colours import colour_facts
from barchan.export.glb import AXES, Parts, attributes_of, parts_facts
from barchan.export.gltf import Gltf, Track
from barchan.export.mesh import mesh_facts, surface_of
from barchan.export.source import Source

BYTES = 28
"""Bytes of a vertex of one frame: place, normal and colour."""


def write(path: Path, source: Source, rate: float) -> dict[str, Any]:
    """Write a mesh for each frame with its own colours, shown for one frame each at ``rate`` a second.

    All others have no size meanwhile, which is how the format hides what is not to be drawn.
    """
    level, _ = source.range_of("elevation")
    scene = Gltf()
    parts = Parts(scene, source.grid.shape, source)
    tracks, number = [], len(source.steps)
    for place, step in enumerate(source.steps):
        frame = source.only([step], source.fields)
        nodes = parts.add(attributes_of(surface_of(frame, level), frame))
        group = scene.group(f"step {step}", nodes, shown=place == 0)
        tracks.append(_track(group, place, number, rate))
    scene.animate("run", tracks)
    scene.write(path)
    facts = {"frames": "a mesh each; those that are not shown have a scale of 0"}
    return {**mesh_facts(source, AXES), **parts_facts(parts.parts), **colour_facts(source), **facts}


def _track(node: int, place: int, number: int, rate: float) -> Track:
    """The size of a frame's node: 1 while it is shown, 0 before and after, to the end of the last frame."""
    times = sorted({0, place, place + 1, number})
    size = np.array([[float(time == place)] * 3 for time in times], "<f4")
    if place + 1 == number:
        size[-1] = 1.0
    return Track([node], "scale", (np.array(times) / rate).astype("<f4"), size, steps=True)
