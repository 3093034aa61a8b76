"""Drift potential by part of the year; right values by numpy from the winds themselves."""

from dataclasses import replace

import numpy as np
import pytest

from barchan.theory.drift import drift_potential
from barchan.theory.seasons import by_part_of_year
from tests.theory.winds import record

START = np.datetime64("2021-01-01T00:00:00")
KNOT = 1852 / 3600


def year(years=1):
    """Winds of every hour of whole years: 10 m/s in July, 8 m/s in January, 3 m/s otherwise."""
    hours = START + np.arange(24 * 365 * years) * np.timedelta64(1, "h")
    month = hours.astype("datetime64[M]").astype(int) % 12
    speed = np.where(month == 6, 10.0, np.where(month == 0, 8.0, 3.0))
    return replace(record(speed, np.where(month == 6, 340.0, 230.0)), start=START)


def weight(speed):
    return (speed / KNOT) ** 2 * (speed / KNOT - 12)


def test_each_month_has_its_own_drift_potential():
    parts = by_part_of_year(year(), "month")
    assert [part.name for part in parts][::6] == ["January", "July"]
    totals = {part.name: part.potential.total for part in parts}
    assert totals["July"] == pytest.approx(weight(10.0) * 31 / 365.25)
    assert totals["January"] == pytest.approx(weight(8.0) * 31 / 365.25)
    assert totals["May"] == 0
    assert parts[6].potential.toward == pytest.approx(160.0)
    assert parts[6].days == pytest.approx(31)


def test_seasons_hold_their_months_and_add_up_to_the_year():
    parts = by_part_of_year(year(), "season")
    assert [part.potential.total > 0 for part in parts] == [True, False, True, False]
    whole = sum(part.potential.total for part in parts)
    assert whole == pytest.approx(drift_potential(year()).total, rel=2e-3)


def test_a_month_that_is_half_missing_counts_for_its_length():
    whole = year()
    kept = (whole.time < 190 * 86400) | (whole.time > 205 * 86400)
    some = replace(whole, **{n: getattr(whole, n)[kept] for n in ("time", "duration", "speed", "direction")})
    july = by_part_of_year(some, "month")[6]
    assert july.potential.total == pytest.approx(weight(10.0) * 31 / 365.25)
    assert july.days < 17


def test_months_need_dates():
    with pytest.raises(ValueError, match="has no dates"):
        by_part_of_year(record([9.0], [270.0]), "month")
