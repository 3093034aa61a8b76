"""A part of a step under one constant wind, and the clock that relates steps to seconds and polls."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from barchan.streams import Stream
from barchan.wind.weather import UNKNOWN, Weather

FOR_EVER = 2**62
"""Steps that no run does."""

Strength = Callable[[NDArray[np.float64]], NDArray[np.float64]]
"""From speeds (m/s) to polls, as a fraction of the polls of a step."""

Raised = Callable[[NDArray[np.float64], float | None], NDArray[np.float64]]
"""From speeds (m/s) at a height (m) to those at the clock's height."""


@dataclass(frozen=True)
class WindInterval:
    """A fraction of a step during which direction and speed are constant."""

    share: float
    """Fraction of the step's time; the fractions of a step add up to 1."""
    direction: float
    """Direction that the wind comes from (degrees clockwise from north)."""
    hop_length: float | None = None
    """Speed as a hop length (cells), if the wind states it so."""
    speed: float | None = None
    """Speed (m/s), if the wind states it so."""
    strength: float = 1.0
    """Polls of this interval over the polls that a step has in the same time."""
    weather: Weather = UNKNOWN
    """Air temperature and snowfall, where they are stated."""
    driving_speed: float | None = None
    """Of a speed that varies: its mean (m/s), each moment weighted by its flux; where that is known."""


@dataclass(frozen=True)
class StepClock:
    """Converts steps to seconds and speeds to polls in one run, and holds its random streams."""

    seed: int
    """Seed of the run."""
    step_seconds: float | None = None
    """Duration of a step (s), if known."""
    strength: Strength | None = None
    """Polls by speed, if polls are in proportion to the flux."""
    raised: Raised | None = None
    """Brings speeds of a record from their height to the clock's, if the clock has one."""
    deviates: bool = True
    """Whether directions deviate from their means at random."""

    @property
    def directions(self) -> Stream:
        """Random numbers for deviations from a wind's direction."""
        return Stream(self.seed, "wind direction")

    @property
    def gusts(self) -> Stream:
        """Random numbers for gusts."""
        return Stream(self.seed, "gusts")

    @property
    def samples(self) -> Stream:
        """Random numbers that pick winds from a record."""
        return Stream(self.seed, "wind record")

    def mean_strength(self, speeds: NDArray[np.float64]) -> float:
        """Mean strength of speeds (m/s) of equal duration."""
        return 1.0 if self.strength is None else float(self.strength(speeds).mean())

    def driving_speed(self, speeds: NDArray[np.float64]) -> float | None:
        """Mean of speeds (m/s) of equal duration, weighted by their strengths; None where none moves sand."""
        if self.strength is None or len(speeds) == 1:
            return None
        strengths = self.strength(speeds)
        return float(np.average(speeds, weights=strengths)) if strengths.any() else None

    def seconds(self) -> float:
        """Duration of a step (s); raises ValueError if unknown."""
        if self.step_seconds is None:
            raise ValueError("the duration of a step is not known")
        return self.step_seconds
