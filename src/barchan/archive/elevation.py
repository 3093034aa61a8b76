"""The elevation of archived frames, computed from ground and sand where it is read."""

from typing import Any

import numpy as np
from numpy.typing import NDArray
from xarray.backends import BackendArray
from xarray.core import indexing


class LazyElevation(BackendArray):
    """Elevation (m) over (step, y, x): ground plus slabs, computed for the part that is asked for."""

    def __init__(self, ground: Any, sand: Any, thickness: float) -> None:
        """Compute from variables of ground (m) and sand (slabs of ``thickness`` m)."""
        self.ground, self.sand, self.thickness = ground, sand, thickness
        self.shape = sand.shape
        self.dtype = np.dtype("float64")

    def __getitem__(self, key: Any) -> Any:
        support = indexing.IndexingSupport.BASIC
        return indexing.explicit_indexing_adapter(key, self.shape, support, self._part)

    def _part(self, key: tuple[Any, ...]) -> NDArray[np.float64]:
        return np.asarray(self.ground[key].values + self.sand[key].values * self.thickness)
