"""Winds of a known speed without a direction: they count as time, and in no direction of their own."""

import math

import numpy as np
import pytest

from barchan.aeolian import Saltation
from barchan.theory.assessment import assess_record
from barchan.theory.roses import wind_rose
from barchan.theory.seasons import by_part_of_year
from barchan.wind import Recorded
from barchan.wind.records import read_record
from barchan.wind.records.writing import write_record
from tests.wind.blown import segments


@pytest.fixture
def read(tmp_path):
    def reading(*rows):
        path = tmp_path / "station.csv"
        times = (f"2024-01-{1 + k // 24:02d}T{k % 24:02d}:00" for k in range(len(rows)))
        lines = [f"{time},{row}" for time, row in zip(times, rows, strict=True)]
        path.write_text("\n".join(["time,speed (kn),direction", *lines]) + "\n")
        return read_record(path)

    return reading


def test_light_winds_without_a_direction_are_time_without_drift(read):
    """20² (20 - 12) = 3200 VU in one of four hours: 800. Without the two variable hours it were 1600."""
    found = assess_record(read("20,270", "3,VRB", "5,", "0,VRB"), Saltation())
    assert found.potential.total == pytest.approx(800.0)
    assert found.potential.steadiness == pytest.approx(1.0)
    assert any("below the threshold: time without drift" in remark for remark in found.remarks)


def test_light_winds_without_a_direction_are_neither_missing_nor_calm(read):
    record = read("20,270", "3,VRB", "0,VRB", ",90", "5,990")
    assert (len(record), record.missing, record.calms) == (4, 1, 1)
    np.testing.assert_array_equal(record.without_direction, [False, True, False, True])
    assert record.calm_share == pytest.approx(1 / 4)
    assert any(
        "in 2 rows (50.0 % of the time) there is a speed, up to 2.6 m/s, and no" in r for r in record.remarks
    )


def test_the_drift_of_strong_winds_without_a_direction_is_shared_as_that_of_the_others(read):
    """3200 VU in three of four hours; from north and from west alike, so that RDP/DP is 1/√2."""
    found = assess_record(read("20,270", "20,VRB", "20,0", "6,0"), Saltation())
    assert found.potential.total == pytest.approx(2400.0)
    assert found.potential.steadiness == pytest.approx(math.sqrt(0.5))
    assert found.potential.toward == pytest.approx(135.0)
    assert any(
        "in 1 row without a direction the speed exceeds the threshold: 33 % of" in r for r in found.remarks
    )


def test_months_and_roses_count_winds_without_a_direction(read):
    record = read("20,270", "20,VRB", "3,VRB", "0,")
    [january] = by_part_of_year(record, "month")
    assert january.potential.total == pytest.approx(1600.0 * 31 / 365.25)
    table, calms, unknown = wind_rose(record, (5.0,))
    assert (table.sum(), calms, unknown) == (0.25, 0.25, 0.5)
    assert table[12].sum() == 0.25


def test_a_run_passes_time_and_takes_the_direction_before(read, tmp_path):
    read("20,", "20,270", "20,VRB", "3,VRB", "20,90")
    recorded = Recorded(kind="record", path=str(tmp_path / "station.csv"), repeat=False)
    blown = segments(recorded, 0, 5, step_seconds=3600.0)
    assert [s.direction for s in blown if s.speed is not None and s.speed > 6.0] == [270, 270, 270, 90]
    assert sum(s.steps for s in blown) == pytest.approx(5.0)


def test_a_vane_out_of_order_is_said_with_its_time(read):
    record = read("20,270", *["20,"] * 48, "20,90")
    assert any("no direction, for up to 2 days on end" in remark for remark in record.remarks)


def test_a_written_record_has_no_direction_where_there_was_none(read, tmp_path):
    record = read("20,270", "3,VRB", "20,90")
    write_record(record, tmp_path / "again.csv")
    again = read_record(tmp_path / "again.csv")
    np.testing.assert_array_equal(again.without_direction, record.without_direction)


def test_of_two_rows_of_one_time_that_with_a_direction_is_kept(tmp_path):
    path = tmp_path / "twice.csv"
    rows = ["2024-01-01T00:00,,", "2024-01-01T00:00,5,VRB", "2024-01-01T00:00,5,90", "2024-01-01T01:00,5,90"]
    path.write_text("\n".join(["time,speed (m/s),direction", *rows]) + "\n")
    record = read_record(path)
    assert (record.duplicates, record.direction.tolist(), record.undirected) == (2, [90, 90], None)
