"""Compass directions and vectors: where a wind comes from, and where it blows."""

import math


def downwind(direction: float) -> tuple[float, float]:
    """Unit vector (x east, y north) that points where a wind from ``direction`` blows."""
    angle = math.radians(direction)
    return -math.sin(angle), -math.cos(angle)


def bearing(x: float, y: float) -> float:
    """Where a wind that blows along a vector (x east, y north) comes from (degrees)."""
    return math.degrees(math.atan2(-x, -y)) % 360.0
