"""STL, binary: a closed solid to print, the surface on four walls and a level bottom."""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.export.mesh import Surface, mesh_facts, surface_of
from barchan.export.source import Source

PART = 0.1
"""Thickness below the lowest point, as a part of the relief, where none is given."""


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write the solid, z up, its bottom at z = 0."""
    surface = surface_of(source)
    factor = source.options.scale or 1.0
    relief = float(np.ptp(surface.z))
    thinnest = source.scenario.lattice.thickness * factor
    base = source.options.base
    thickness = max(PART * relief, thinnest) if base is None else base * factor
    corners = _solid(surface, thickness)
    facets = np.zeros(len(corners), [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")])
    facets["corners"] = corners
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.linalg.norm(across, axis=1, keepdims=True)
    facets["normal"] = np.divide(across, length, out=np.zeros_like(across), where=length > 0)
    with path.open("wb") as file:
        file.write(f"Barchan: {source.scenario.title}".encode("ascii", "replace")[:80].ljust(80))
        file.write(np.uint32(len(facets)).astype("<u4").tobytes())
        file.write(facets.tobytes())
    facts = mesh_facts(source, "x to the east, y to the north, z up from the bottom")
    facts["mesh"]["bottom_below_lowest_m"] = thickness / factor
    return facts


def _solid(surface: Surface, thickness: float) -> NDArray[np.float32]:
    """The three corners of each triangle; all parts share their vertices, so the solid is closed.

    The bottom is a fan about its middle.
    """
    rows, columns = surface.z.shape
    top = surface.vertices
    top[:, 2] = surface.z.ravel() - (surface.z.min() - thickness)
    number = np.arange(rows * columns).reshape(rows, columns)
    rim = np.concatenate([number[0, :-1], number[:-1, -1], number[-1, :0:-1], number[:0:-1, 0]])
    floor = top[rim] * np.array([1, 1, 0], "f4")
    first = len(top)
    below = first + np.arange(len(rim))
    middle = np.array([[surface.x.mean(), surface.y.mean(), 0.0]], "f4")
    following, under = np.roll(rim, -1), np.roll(below, -1)
    parts = [
        surface.triangles,
        np.stack([below, under, following], axis=1),
        np.stack([below, following, rim], axis=1),
        np.stack([under, below, np.full(len(rim), first + len(rim))], axis=1),
    ]
    return np.concatenate([top, floor, middle])[np.concatenate(parts)]
