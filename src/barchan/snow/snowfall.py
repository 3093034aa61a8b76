"""Snow that falls, in whole quanta, evenly on all cells."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.lattice import Lattice
from barchan.streams import Stream

_BITS = 40
"""Binary places in which fallen quanta are summed."""


class Fallen:
    """How much has fallen on each cell so far, in quanta.

    A cell gets a quantum whenever the sum passes its own phase. The phases of all cells are evenly spaced, in
    random order, so that cells differ by one quantum at most and the mass on the field is exact to one
    quantum.
    """

    def __init__(self) -> None:
        """Nothing has fallen yet."""
        self.total = 0
        self._phases: NDArray[np.int64] | None = None

    def quanta(self, mean: float, lattice: Lattice) -> NDArray[np.int64]:
        """Quanta for each cell when ``mean`` quanta more fall on every cell."""
        if self._phases is None:
            order = np.argsort(Stream(0, "snowfall").draws(0, lattice.cells), kind="stable")
            phases = np.empty(lattice.cells, np.int64)
            phases[order] = (np.arange(lattice.cells, dtype=np.int64) << _BITS) // lattice.cells
            self._phases = phases.reshape(lattice.shape)
        before = self.total
        self.total = before + round(mean * 2**_BITS)
        whole = (before >> _BITS) << _BITS
        return ((self.total - whole + self._phases) >> _BITS) - ((before - whole + self._phases) >> _BITS)

    def state(self) -> dict[str, Any]:
        """What to remember."""
        return {"fallen_whole": self.total >> _BITS, "fallen_part": self.total & ((1 << _BITS) - 1)}

    def restore(self, state: dict[str, Any]) -> None:
        """Take up what was remembered."""
        self.total = (int(state["fallen_whole"]) << _BITS) + int(state["fallen_part"])
