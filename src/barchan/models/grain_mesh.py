"""Fields over mesh cells: the squares between a stack and its neighbours in the east and north."""

import numpy as np
from numpy.typing import NDArray


def following(values: NDArray[np.float64], axis: int, joined: bool) -> NDArray[np.float64]:
    """The values one place on along an axis; at an open edge the last ones again."""
    size = values.shape[axis]
    after = np.arange(1, size + 1)
    after[-1] = 0 if joined else size - 1
    return np.asarray(np.take(values, after, axis))


def over_mesh(values: NDArray[np.float64], periodic: tuple[bool, bool]) -> NDArray[np.float64]:
    """The mean over each mesh cell of values on its four stacks."""
    for axis, joined in enumerate(periodic):
        values = 0.5 * (values + following(values, axis, joined))
    return values
