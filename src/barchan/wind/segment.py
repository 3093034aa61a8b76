"""A segment of constant forcing, on which a model works."""

from dataclasses import dataclass, replace

from barchan.wind.influx import Influx
from barchan.wind.weather import UNKNOWN, Weather


@dataclass(frozen=True)
class Segment:
    """Polls ``first`` to ``first + polls`` of each of ``steps`` steps from ``step`` on, under one wind."""

    step: int
    steps: int
    first: int
    polls: int
    direction: float
    """Where the wind comes from, degrees clockwise from north."""
    hop_length: float | None = None
    """Hop length that this wind states (cells), instead of the model's."""
    speed: float | None = None
    """Wind speed (m/s) at the height it is stated for, where the wind states one."""
    share: float = 1.0
    """Fraction of each step's time in which this wind blows."""
    step_seconds: float | None = None
    """Duration of a whole step (s), if known."""
    ends: bool = True
    """Whether the segment is the last of its steps."""
    influx: Influx | None = None
    """Sand that enters across open edges from upwind, where any does."""
    driving_speed: float | None = None
    """Mean wind (m/s) weighted by flux, of a wind whose speed varies within the segment."""
    weather: Weather = UNKNOWN
    """Air temperature and snowfall, where the forcing states them."""

    @property
    def seconds(self) -> float | None:
        """Duration of the segment (s), if known."""
        return None if self.step_seconds is None else self.step_seconds * self.share * self.steps

    def part(self, first: int, steps: int) -> "Segment":
        """``steps`` steps of the segment, from its step ``first`` (0: the segment's own first) on."""
        return replace(self, step=self.step + first, steps=steps)
