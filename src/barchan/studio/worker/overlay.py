"""A terrain from a file, draped over the surface to compare it with."""

from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pydantic import ValidationError

from barchan.errors import ScenarioError
from barchan.ground.surface import FileGround
from barchan.ground.terrain import HIGHEST
from barchan.lattice import Lattice
from barchan.scenario.messages import problems_of
from barchan.simulation import Simulation
from barchan.studio.protocol import Request
from barchan.studio.worker.frame_fields import AvailableField

OVERLAY, ABOVE = "overlay", "above_overlay"
"""Fields of a run with an overlay: its elevation, and that of the surface less it."""


@dataclass(frozen=True)
class Overlay:
    """Elevations of another terrain on the lattice of a run."""

    lattice: Lattice
    heights: NDArray[np.float64]
    """Elevation (m) by cell."""
    level: bool
    """Whether it is shifted to the mean elevation of the surface that it is compared with."""

    def fits(self, simulation: Simulation) -> bool:
        """Whether it lies on the lattice of a run."""
        return simulation.lattice == self.lattice

    def fields(self) -> list[dict[str, Any]]:
        """What the browser may ask for of it."""
        shifted = ", both with mean 0" if self.level else ""
        return [
            asdict(AvailableField(OVERLAY, "m", "elevation of the overlay", None)),
            asdict(AvailableField(ABOVE, "m", f"elevation less that of the overlay{shifted}", 0.0)),
        ]

    def values(self, name: str, simulation: Simulation) -> NDArray[np.float64] | None:
        """One of its fields for a state of the run; None for any other field."""
        if name == OVERLAY:
            return self.heights
        if name != ABOVE:
            return None
        above: NDArray[np.float64] = simulation.elevation - self.heights
        return above - above.mean() if self.level else above


def read_overlay(request: Request, lattice: Lattice) -> Overlay:
    """The terrain in the file that a request names, on a lattice.

    It is read as ``ground`` of kind ``file`` would be: an elevation model at its own scale from its
    south-west corner, others stretched over the field, gaps filled. Raises ScenarioError for what is wrong.
    """
    keys = ("path", "lowest", "highest", "missing")
    given = {key: request[key] for key in keys if request.get(key) is not None}
    data = {**given, "resample": True, "fill": "interpolate"}
    try:
        file = FileGround.model_validate(data)
    except ValidationError as error:
        raise ScenarioError(problems_of(error, FileGround, data, lambda _: "overlay")) from None
    return Overlay(lattice, file.heights(lattice, "overlay", -HIGHEST, HIGHEST), bool(request.get("level")))
