"""Winds whose drift is known."""

import numpy as np

from barchan.wind.records import WindRecord


def record(speeds, directions, hours=None):
    """A record of winds (m/s, degrees) that last an hour each, or ``hours`` hours."""
    speeds, directions = np.broadcast_arrays(np.asarray(speeds, float), np.asarray(directions, float))
    duration = 3600.0 * np.broadcast_to(1.0 if hours is None else np.asarray(hours, float), speeds.shape)
    return WindRecord(np.cumsum(duration) - duration, duration, speeds.copy(), directions.copy())
