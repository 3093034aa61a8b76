"""What a wind does during a part of a step, and what it needs to know to say so."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from barchan.streams import Stream
from barchan.wind.weather import UNKNOWN, Weather

Strength = Callable[[NDArray[np.float64]], NDArray[np.float64]]
"""From speeds (m/s) to the polls that they are worth, over the polls of a step."""


@dataclass(frozen=True)
class Stretch:
    """A wind that holds for a share of a step."""

    share: float
    """Of the step's time; those of a step add up to 1."""
    direction: float
    """Where it comes from (degrees)."""
    hop_length: float | None = None
    """Its speed as a hop length (cells), where it is stated so."""
    speed: float | None = None
    """Its speed (m/s), where it is stated so."""
    strength: float = 1.0
    """Polls in its time over those that a step has in as much time."""
    weather: Weather = UNKNOWN
    """Air temperature and snowfall, where they are stated."""


@dataclass(frozen=True)
class Pace:
    """How steps and seconds, speeds and polls go together in a run."""

    seed: int
    """The run's."""
    step_seconds: float | None = None
    """Duration of a step, where it is known."""
    strength: Strength | None = None
    """What a speed is worth, where polls count the sand that a wind moves."""
    deviates: bool = True
    """Whether directions deviate from their means by chance."""

    @property
    def directions(self) -> Stream:
        """The stream that deviations from a wind's direction are drawn from."""
        return Stream(self.seed, "wind direction")

    @property
    def gusts(self) -> Stream:
        """The stream that gusts are drawn from."""
        return Stream(self.seed, "gusts")

    @property
    def samples(self) -> Stream:
        """The stream that winds of a record are picked with."""
        return Stream(self.seed, "wind record")

    def worth(self, speeds: NDArray[np.float64]) -> float:
        """Mean strength of speeds (m/s) that hold equally long."""
        return 1.0 if self.strength is None else float(self.strength(speeds).mean())

    def seconds(self) -> float:
        """Duration of a step; raises ValueError where it is not known."""
        if self.step_seconds is None:
            raise ValueError("the duration of a step is not known")
        return self.step_seconds
