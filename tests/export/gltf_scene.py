"""A binary glTF file as pygltflib reads it."""

import numpy as np
import pygltflib
import pytest

KINDS = {5126: "<f4", 5121: "u1", 5123: "<u2", 5125: "<u4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


class Scene:
    """A file as pygltflib reads it, and the numbers of its accessors."""

    def __init__(self, path):
        self.file = pygltflib.GLTF2().load(str(path))
        self.binary = self.file.binary_blob()

    def array(self, number):
        accessor = self.file.accessors[number]
        view = self.file.bufferViews[accessor.bufferView]
        width = WIDTHS[accessor.type]
        found = np.frombuffer(
            self.binary, KINDS[accessor.componentType], accessor.count * width, view.byteOffset
        )
        values = found.reshape(-1, width)
        for name, edge in (("min", accessor.min), ("max", accessor.max)):
            if edge:
                assert getattr(values, name)(axis=0).tolist() == pytest.approx(edge)
        return values

    @property
    def parts(self):
        return [mesh.primitives[0] for mesh in self.file.meshes]
