"""A stretch of constant forcing: what a wind hands to a model."""

import math
from dataclasses import dataclass, replace


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
    seconds: float | None = None
    """Duration, where the scenario has a clock."""

    def part(self, first: int, steps: int) -> "Segment":
        """``steps`` steps of the segment, from its step ``first`` (0: the segment's own first) on."""
        seconds = None if self.seconds is None else self.seconds * steps / self.steps
        return replace(self, step=self.step + first, steps=steps, seconds=seconds)


def downwind(direction: float) -> tuple[float, float]:
    """Unit vector (x east, y north) that points where a wind from ``direction`` blows."""
    angle = math.radians(direction)
    return -math.sin(angle), -math.cos(angle)
