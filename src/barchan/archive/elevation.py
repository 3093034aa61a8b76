"""The elevation of archived frames, computed from ground and layers where it is read."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from xarray.backends import BackendArray
from xarray.core import indexing

from barchan.fields import GROUND, LayerInfo, count_names, depth_of


class LazyElevation(BackendArray):
    """Elevation (m) over (step, y, x): ground plus layers, computed for the part that is asked for."""

    def __init__(self, frames: Any, layers: Sequence[LayerInfo], slab_height: float) -> None:
        """Compute from the ground and the layers of a dataset of ``frames``; ``slab_height`` is in m."""
        self.layers, self.slab_height = tuple(layers), slab_height
        self.variables = {name: frames[name].variable for name in (GROUND.name, *count_names(layers))}
        self.shape = self.variables[GROUND.name].shape
        self.dtype = np.dtype("float64")

    def __getitem__(self, key: Any) -> Any:
        support = indexing.IndexingSupport.BASIC
        return indexing.explicit_indexing_adapter(key, self.shape, support, self._part)

    def _part(self, key: tuple[Any, ...]) -> NDArray[np.float64]:
        parts = {name: variable[key].values for name, variable in self.variables.items()}
        return np.asarray(parts[GROUND.name] + depth_of(self.layers, parts, self.slab_height))
