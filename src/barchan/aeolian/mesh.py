"""Fields over mesh cells: the squares between a stack and its neighbours in the east and north."""

import numpy as np
from numpy.typing import NDArray


def following(values: NDArray[np.float64], axis: int, joined: bool) -> NDArray[np.float64]:
    """The values one place on along an axis; at an open edge the last ones again."""
    found = np.empty_like(values)
    there, here = values.swapaxes(0, axis), found.swapaxes(0, axis)
    here[:-1], here[-1] = there[1:], there[0 if joined else -1]
    return found


def over_mesh(values: NDArray[np.float64], periodic: tuple[bool, bool]) -> NDArray[np.float64]:
    """The mean over each mesh cell of values on its four stacks."""
    for axis, joined in enumerate(periodic):
        values = 0.5 * (values + following(values, axis, joined))
    return values
