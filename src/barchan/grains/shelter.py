"""Shelter: calm air below lines that fall downwind from all that stands high."""

import math
from typing import ClassVar

import numpy as np

from barchan.grains.closure import Closure
from barchan.kernels.grains.state import Ground
from barchan.lattice import Lattice
from barchan.parameters import parameter
from barchan.wind.frame import WindFrame


class Shelter(Closure):
    """Calm air behind crests."""

    key: ClassVar[str] = "shelter"

    angle: float | None = parameter(
        None,
        unit="degrees",
        ge=1,
        le=89,
        meaning="The wind blows above a line that falls from each crest at this angle, and no sand is lifted "
        "below it; no shelter where not given.",
        source="Prague thesis, §6.6.1, after the shadow zone of Werner 1995",
    )
    update_every: int = parameter(
        10,
        unit="iterations",
        ge=1,
        le=1_000_000,
        meaning="Iterations after which the sheltered air is recomputed.",
        source="ours",
    )

    def raise_over(self, ground: Ground, lattice: Lattice, frame: WindFrame) -> None:
        """Recompute the shelter surface of a bed under the wind of a frame; the mesh is left as it was."""
        from barchan.kernels.grains.shelter import raise_shelter_surface

        if self.angle is None:
            return
        surface = np.array(frame.enter(ground.height.reshape(lattice.shape)).T, order="C")
        across, along = lattice.periodic
        if frame.crossed:
            across, along = along, across
        offset = -math.tan(frame.angle)
        row_step = math.floor(offset + 1e-9)
        fall = math.tan(math.radians(self.angle)) * lattice.cell_size / math.cos(frame.angle)
        raise_shelter_surface(fall, row_step, max(offset - row_step, 0.0), along, across, surface)
        ground.shelter_surface.reshape(lattice.shape)[...] = frame.leave(surface.T)
