"""glTF in one binary file: the surface with normals, texture coordinates and colours."""

import json
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.export.mesh import colours_of, mesh_facts, surface_of
from barchan.export.source import Source
from barchan.version import __version__

FLOAT, BYTE, INDEX = 5126, 5121, 5125
ARRAY, ELEMENTS = 34962, 34963
JSON_CHUNK, BINARY_CHUNK = 0x4E4F534A, 0x004E4942
"""Numbers by which the format names types, uses of buffers, and chunks."""


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write the surface, y up and north towards -z, as the format wants it; the texture's top lies north."""
    surface = surface_of(source)
    turned = [surface.vertices[:, (0, 2, 1)], surface.normals[:, (0, 2, 1)]]
    for vectors in turned:
        vectors[:, 2] *= -1.0
    rows, columns = surface.z.shape
    u, v = np.meshgrid(np.linspace(0, 1, columns), np.linspace(1, 0, rows))
    arrays = {
        "POSITION": turned[0],
        "NORMAL": turned[1],
        "TEXCOORD_0": np.stack([u, v], axis=-1).reshape(-1, 2).astype("<f4"),
        "COLOR_0": _linear(colours_of(source)),
    }
    _write(path, arrays, surface.triangles, source)
    return mesh_facts(source, "x to the east, y up, z to the south")


def _linear(colours: NDArray[np.float32]) -> NDArray[np.uint8]:
    """Colours as the format wants them: in proportion to light, four bytes each."""
    light = np.where(colours <= 0.04045, colours / 12.92, ((colours + 0.055) / 1.055) ** 2.4)
    opaque = np.full((len(light), 1), 255.0)
    return np.rint(np.concatenate([light * 255.0, opaque], axis=1)).astype("u1")


def _write(path: Path, arrays: dict[str, NDArray], triangles: NDArray[np.uint32], source: Source) -> None:
    blocks = [*arrays.values(), triangles.ravel()]
    views, accessors, offset = [], [], 0
    for block in blocks:
        last = block is blocks[-1]
        views.append(
            {
                "buffer": 0,
                "byteOffset": offset,
                "byteLength": block.nbytes,
                "target": ELEMENTS if last else ARRAY,
            }
        )
        accessors.append(_accessor(len(views) - 1, block))
        offset += block.nbytes
    head = {
        "asset": {"version": "2.0", "generator": f"Barchan {__version__}"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": source.scenario.title or "Run"}],
        "meshes": [
            {
                "primitives": [
                    {
                        "attributes": {name: number for number, name in enumerate(arrays)},
                        "indices": len(arrays),
                        "material": 0,
                    }
                ]
            }
        ],
        "materials": [
            {"name": "surface", "pbrMetallicRoughness": {"metallicFactor": 0.0, "roughnessFactor": 1.0}}
        ],
        "buffers": [{"byteLength": offset}],
        "bufferViews": views,
        "accessors": accessors,
    }
    text = json.dumps(head, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    with path.open("wb") as file:
        length = 12 + 8 + len(text) + 8 + offset
        file.write(b"glTF" + np.array([2, length, len(text), JSON_CHUNK], "<u4").tobytes() + text)
        file.write(np.array([offset, BINARY_CHUNK], "<u4").tobytes())
        for block in blocks:
            file.write(np.ascontiguousarray(block).tobytes())


def _accessor(view: int, block: NDArray) -> dict[str, Any]:
    kind = {"f": FLOAT, "u": BYTE if block.itemsize == 1 else INDEX}[block.dtype.kind]
    shape = "SCALAR" if block.ndim == 1 else f"VEC{block.shape[1]}"
    made: dict[str, Any] = {"bufferView": view, "componentType": kind, "count": len(block), "type": shape}
    if kind == BYTE:
        made["normalized"] = True
    if kind == FLOAT and shape == "VEC3":
        made |= {"min": block.min(axis=0).tolist(), "max": block.max(axis=0).tolist()}
    return made
