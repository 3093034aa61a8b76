"""Winds whose drift potential is known, and what numpy makes of it without our code."""

import numpy as np

from barchan.aeolian import Saltation
from barchan.theory.assessment import assess_record
from barchan.wind.records import RecordFormat, read_record

HOURS = np.datetime64("2024-01-30T00") + np.arange(60) * np.timedelta64(1, "h")
SIZE = {"m/s": 1.0, "0.1 m/s": 0.1, "km/h": 1 / 3.6, "kn": 1852 / 3600, "mph": 0.44704}


def winds(seed=5, count=60):
    """Speeds (m/s, tenths) and directions (tens of degrees, 10 to 360) of some hours."""
    random = np.random.default_rng(seed)
    speeds = np.round(2.0 + 7.0 * random.weibull(2.0, count), 1)
    return speeds, random.choice(np.arange(10, 370, 10), count)


def potential(speeds, directions, hours=None):
    """DP, eastward and northward RDP (VU): U² (U - 12) t in knots, t the share of the time."""
    knots = np.asarray(speeds, float) * 3600 / 1852
    share = np.full(len(knots), 1.0 / len(knots)) if hours is None else np.asarray(hours) / np.sum(hours)
    weight = np.where(knots > 12, knots**2 * (knots - 12), 0.0) * share
    angle = np.radians(np.asarray(directions, float))
    return weight.sum(), -(weight * np.sin(angle)).sum(), -(weight * np.cos(angle)).sum()


def read_potential(path, **form):
    """The same three numbers as Barchan reads them from a file, and the record."""
    record = read_record(path, RecordFormat(**form))
    found = assess_record(record, Saltation()).potential
    return (found.total, *found.vector), record
