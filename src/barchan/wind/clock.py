"""The clock: how long a step lasts, and how many polls a wind is worth."""

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.saltation import Saltation
from barchan.parameters import NOT_GIVEN, parameter

YEAR = 365.25 * 86400.0
"""A year (s)."""

DAY = 86400.0
"""A day (s)."""


class Clock(Saltation):
    """The flux law and the sand that give each step a duration and each wind its number of polls.

    Under the reference wind a step has as many polls as the lattice has cells. Over a flat bed of sand
    these polls carry a known volume, and a step lasts as long as the reference wind takes to carry it.
    Other winds have polls in proportion to their flux.
    """

    reference_speed: float = parameter(
        10.0,
        unit="m/s",
        gt=0,
        le=100,
        acts_with={"step_seconds": NOT_GIVEN},
        meaning="The wind under which a step polls as many cells as the field has.",
        source="ours",
    )
    step_seconds: float | None = parameter(
        None,
        unit="s",
        gt=0,
        le=1e12,
        scale="log",
        meaning="Duration of a step; by default the time in which the reference wind moves as much sand as "
        "the polls of a step.",
    )

    def duration(self, step_volume: float) -> float:
        """Duration of a step (s) that moves ``step_volume`` (m² per step: volume per width) on a flat bed.

        Raises ValueError where the reference wind moves nothing.
        """
        if self.step_seconds is not None:
            return self.step_seconds
        flux = float(self.volume_flux(self.reference_speed))
        if flux == 0.0:
            raise ValueError(
                f"is {self.reference_speed:g} m/s, which moves no sand; allowed: more than the threshold of "
                f"{self.threshold_speed():.3g} m/s"
            )
        return step_volume / flux

    def strength(self, speeds: NDArray[np.float64], step_volume: float) -> NDArray[np.float64]:
        """Polls under winds (m/s) over the polls of a step, in a step's time."""
        return self.volume_flux(speeds) * (self.duration(step_volume) / step_volume)


def suited_unit(seconds: float) -> tuple[str, float]:
    """The unit that suits a duration (s): its name and its length (s)."""
    units = (("years", YEAR), ("days", DAY), ("hours", 3600.0), ("minutes", 60.0))
    return next((unit for unit in units if seconds >= unit[1]), ("s", 1.0))


def spoken(seconds: float) -> str:
    """A duration in the unit that suits it."""
    name, size = suited_unit(seconds)
    return f"{seconds / size:.3g} {name}"
