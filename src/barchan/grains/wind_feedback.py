"""Wind feedback: near the bed the wind is slowed by the momentum that grains take from it (Owen 1964)."""

import math
from typing import TYPE_CHECKING, ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.flow_over_relief import LinearFlow
from barchan.grains.closure import Closure
from barchan.lattice import Lattice
from barchan.parameters import parameter

if TYPE_CHECKING:
    from barchan.grains.parameters import GrainFlight

RESPONSE = 0.05
"""Time (s) over which the wind near the bed adjusts to the grains: about a hop."""

LEAST_SHARE = 0.1
"""Share of the friction velocity that grains leave near the bed at least."""


class Feedback(Closure):
    """The wind near the bed, slowed by grains."""

    key: ClassVar[str] = "feedback"

    near_bed: Literal["slowed", "threshold", "log"] = parameter(
        "slowed",
        unit="-",
        live=True,
        meaning="Wind below the focus: slowed by the momentum that grains take from it, that of the impact "
        "threshold, or the law of the wall all the way down.",
        source="slowed: Owen 1964, Ungar & Haff 1987; threshold: Bagnold 1941; log: Szabó 2019, eq. 2.1",
    )
    focus_height: float = parameter(
        0.01,
        unit="m",
        gt=0,
        le=1,
        live=True,
        acts_with={"near_bed": ["slowed", "threshold"]},
        meaning="Height of the focus, below which all winds are the same.",
        source="Bagnold 1941: about a centimetre over sand of mixed sizes",
    )
    length: float | None = parameter(
        0.05,
        unit="m",
        gt=0,
        le=10,
        acts_with={"near_bed": "slowed"},
        meaning="Length (standard deviation) along the wind over which the air shares the momentum that "
        "grains take from it; over the whole field if null, and then grains crowd into lanes.",
        source="ours",
    )
    width: float = parameter(
        0.02,
        unit="m",
        gt=0,
        le=10,
        acts_with={"near_bed": "slowed"},
        meaning="Width (standard deviation) across the wind over which the air shares that momentum. Where "
        "it is as wide as the length, lanes of grains break ripples up into pits.",
        source="ours: slowed air spreads by some tenth or fifth of its way",
    )
    momentum_weight: float = parameter(
        0.1,
        unit="-",
        gt=0,
        le=1,
        scale="log",
        meaning="Share of a grain's sand that slows the wind. With 1 the air carries as much sand as real "
        "wind does. With less it carries more and the bed changes faster by the inverse of this share (the "
        "morphological acceleration factor): a second of flight counts for that number of seconds of wind.",
        source="ours",
    )
    update_every: int = parameter(
        50,
        unit="iterations",
        ge=1,
        le=1_000_000,
        acts_with={"near_bed": "slowed"},
        meaning="Iterations after which the wind near the bed is recomputed.",
        source="ours",
    )

    @property
    def varies_in_space(self) -> bool:
        """Whether the near-bed wind differs from cell to cell."""
        return self.near_bed == "slowed" and self.length is not None


class WindFeedback:
    """The stress that grains take from the wind: one for the field, or one for each cell."""

    def __init__(self, closure: Feedback, rules: "GrainFlight", lattice: Lattice) -> None:
        """Start with air that no grain has slowed."""
        self.closure, self.rules, self.lattice = closure, rules, lattice
        self.stress = np.zeros(lattice.shape if closure.varies_in_space else ())
        """Recent stress (Pa) that grains take."""

    def change(self, closure: Feedback, rules: "GrainFlight") -> None:
        """Take new parameters from now on; the stress is kept."""
        varied = self.closure.varies_in_space
        self.closure, self.rules = closure, rules
        if closure.varies_in_space != varied:
            mean = self.stress.mean()
            self.stress = np.full(self.lattice.shape if closure.varies_in_space else (), mean)

    def update(self, loss: NDArray[np.float64], seconds: float, direction: float) -> None:
        """Adjust to the loss of speed (m/s) by impacts in some seconds, under a wind from ``direction``."""
        closure, rules = self.closure, self.rules
        thickness = rules.carried * self.lattice.thickness
        mass = closure.momentum_weight * rules.grain_density * (1.0 - rules.porosity) * thickness
        loss = self._shared(loss, direction) if closure.varies_in_space else np.asarray(loss.mean())
        self.stress += (mass * loss / seconds - self.stress) * -math.expm1(-seconds / RESPONSE)

    def near_bed_ustar(self, ustar: float) -> NDArray[np.float64]:
        """Friction velocity (m/s) below the focus, of a wind with friction velocity ``ustar`` above."""
        if self.closure.near_bed == "threshold":
            return np.asarray(self.rules.impact_threshold())
        left = ustar**2 - self.stress / self.rules.air_density
        return np.asarray(np.sqrt(np.maximum(left, (LEAST_SHARE * ustar) ** 2)))

    def _shared(self, loss: NDArray[np.float64], direction: float) -> NDArray[np.float64]:
        """The loss carried along by the wind, and spread less to its sides."""
        closure = self.closure
        return LinearFlow(loss, self.lattice, direction).spread(closure.length or 0.0, closure.width)
