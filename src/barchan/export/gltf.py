"""glTF in one binary file: arrays one after the other, and the text that says what they are."""

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from barchan.version import __version__

ARRAY, ELEMENTS = 34962, 34963
JSON_CHUNK, BINARY_CHUNK = 0x4E4F534A, 0x004E4942
TYPES = {"f4": 5126, "u1": 5121, "u2": 5123, "u4": 5125}
"""Numbers by which the format names uses of buffers, chunks, and types."""

SHORT = 65_535
"""Vertices that 16 bits number: the highest number of them has a meaning of its own."""


@dataclass(frozen=True)
class Track:
    """What a property of some nodes does over time."""

    nodes: list[int]
    path: Literal["weights", "scale"]
    seconds: NDArray[np.float32]
    values: NDArray[np.float32]
    """A row for each time: weights of all shapes, or the scale along three axes."""
    steps: bool = False
    """Whether values jump at their times; otherwise they change along straight lines between them."""


class Gltf:
    """A scene that grows by arrays, meshes and nodes, and is written at the end."""

    def __init__(self, colour: tuple[float, float, float] = (1.0, 1.0, 1.0)) -> None:
        """Begin an empty scene with one rough material, of a colour in proportion to light."""
        self._blocks: list[NDArray] = []
        self._offset = 0
        rough = {"metallicFactor": 0.0, "roughnessFactor": 1.0, "baseColorFactor": [*colour, 1.0]}
        self._lists: dict[str, list[dict[str, Any]]] = {
            "nodes": [],
            "meshes": [],
            "materials": [{"name": "surface", "pbrMetallicRoughness": rough}],
            "bufferViews": [],
            "accessors": [],
            "animations": [],
        }
        self._roots: list[int] = []

    def array(self, values: NDArray, use: int | None = ARRAY, extent: bool = False) -> int:
        """Add an array; returns its number. ``extent`` states its lowest and highest values, as some must."""
        block = np.ascontiguousarray(values)
        view: dict[str, Any] = {"buffer": 0, "byteOffset": self._offset, "byteLength": block.nbytes}
        if use is not None:
            view["target"] = use
        made: dict[str, Any] = {
            "bufferView": len(self._lists["bufferViews"]),
            "componentType": TYPES[f"{block.dtype.kind}{block.dtype.itemsize}"],
            "count": len(block),
            "type": "SCALAR" if block.ndim == 1 else f"VEC{block.shape[1]}",
        }
        if block.dtype.itemsize == 1:
            made["normalized"] = True
        if extent:
            made |= _extent(block.reshape(len(block), -1))
        self._blocks.append(block)
        self._offset += block.nbytes + -block.nbytes % 4
        self._lists["bufferViews"].append(view)
        return self._add("accessors", made)

    def triangles(self, numbers: NDArray[np.uint32], vertices: int) -> int:
        """Add the numbers of triangles' vertices, in 16 bits where they suffice; returns the array's."""
        return self.array(numbers.ravel().astype("<u2" if vertices <= SHORT else "<u4"), ELEMENTS)

    def mesh(
        self,
        name: str,
        attributes: dict[str, int],
        triangles: int,
        targets: list[dict[str, int]] | None = None,
    ) -> int:
        """Add a mesh of arrays and a node that shows it, with displaced shapes where there are any.

        Returns the node's number.
        """
        part: dict[str, Any] = {"attributes": attributes, "indices": triangles, "material": 0}
        mesh: dict[str, Any] = {"primitives": [part]}
        if targets:
            part["targets"] = targets
            mesh["weights"] = [0.0] * len(targets)
        return self._node({"mesh": self._add("meshes", mesh), "name": name})

    def group(self, name: str, nodes: list[int], shown: bool) -> int:
        """Add a node that holds others, of no size unless they are shown at first; returns its number."""
        self._roots = [root for root in self._roots if root not in nodes]
        return self._node({"name": name, "children": nodes, "scale": [float(shown)] * 3})

    def animate(self, name: str, tracks: list[Track]) -> None:
        """Let properties of nodes follow tracks, all at the same time."""
        samplers: list[dict[str, Any]] = []
        channels: list[dict[str, Any]] = []
        for track in tracks:
            targets = [{"node": node, "path": track.path} for node in track.nodes]
            channels += [{"sampler": len(samplers), "target": target} for target in targets]
            values = track.values.ravel() if track.path == "weights" else track.values
            samplers.append(
                {
                    "input": self.array(track.seconds, None, extent=True),
                    "output": self.array(values, None),
                    "interpolation": "STEP" if track.steps else "LINEAR",
                }
            )
        self._add("animations", {"name": name, "samplers": samplers, "channels": channels})

    def write(self, path: Path) -> None:
        """Write the scene."""
        head = {
            "asset": {"version": "2.0", "generator": f"Barchan {__version__}"},
            "scene": 0,
            "scenes": [{"nodes": self._roots}],
            "buffers": [{"byteLength": self._offset}],
            **{name: found for name, found in self._lists.items() if found},
        }
        text = json.dumps(head, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        with path.open("wb") as file:
            length = 12 + 8 + len(text) + 8 + self._offset
            file.write(b"glTF" + np.array([2, length, len(text), JSON_CHUNK], "<u4").tobytes() + text)
            file.write(np.array([self._offset, BINARY_CHUNK], "<u4").tobytes())
            for block in self._blocks:
                file.write(block.tobytes() + b"\0" * (-block.nbytes % 4))

    def _node(self, made: dict[str, Any]) -> int:
        self._roots.append(self._add("nodes", made))
        return self._roots[-1]

    def _add(self, kind: str, made: dict[str, Any]) -> int:
        self._lists[kind].append(made)
        return len(self._lists[kind]) - 1


def _extent(rows: NDArray) -> dict[str, list[float]]:
    """Lowest and highest values of each column, one after the other: many times as fast as all at once."""
    columns = rows.T
    return {"min": [float(c.min()) for c in columns], "max": [float(c.max()) for c in columns]}
