"""What is read as wind must look like wind: wrong units are doubted aloud."""

import re

import numpy as np
import pytest

from barchan.aeolian import Saltation
from barchan.errors import RecordError
from barchan.theory.assessment import assess_record
from barchan.wind.records import RecordFormat, read_record
from tests.wind.records.known import read_potential, winds

SPEEDS, DIRECTIONS = winds()


def read(folder, speeds, directions, heading="time (h),speed (m/s),direction"):
    rows = "\n".join(f"{k},{s!r},{d!r}" for k, (s, d) in enumerate(zip(speeds, directions, strict=True)))
    (folder / "wind.csv").write_text(f"{heading}\n{rows}\n")
    return read_potential(folder / "wind.csv")[1]


@pytest.mark.parametrize(
    ("speeds", "directions", "said"),
    [
        (10 * SPEEDS / 2, DIRECTIONS, "the mean speed is .* no place on Earth has more than 20 m/s"),
        (SPEEDS / 20, DIRECTIONS, "hardly a wind: is the unit right"),
        (SPEEDS, DIRECTIONS / 10, "tens of degrees"),
        (SPEEDS, np.radians(DIRECTIONS), "directions in radians"),
        (np.append(SPEEDS[1:], 80.0), DIRECTIONS, "more than in the strongest cyclones"),
    ],
)
def test_winds_that_are_hardly_possible_are_doubted(tmp_path, speeds, directions, said):
    record = read(tmp_path, speeds.tolist(), directions.tolist())
    assert len(record.warnings) == 1
    assert re.search(said, record.warnings[0])


def test_usual_winds_are_not_doubted(tmp_path):
    assert read(tmp_path, SPEEDS.tolist(), DIRECTIONS.tolist()).warnings == ()


@pytest.mark.parametrize(("step", "width"), [(10.0, 10.0), (22.5, 22.5), (45.0, 45.0), (1.0, 0.0)])
def test_the_step_in_which_directions_are_reported_is_noticed(tmp_path, step, width):
    ways = (np.arange(360) * step) % 360.0
    ways = ways[: int(360 / step)].repeat(9)
    assert read(tmp_path, [5.0] * len(ways), ways.tolist()).direction_width == width


@pytest.mark.parametrize("unit", ["", " (m/s)"])
def test_hourly_means_of_hurricanes_are_doubted_aloud_unless_the_unit_is_stated(tmp_path, unit):
    speeds = [*SPEEDS[1:].tolist(), 50.0]
    record = read(tmp_path, speeds, DIRECTIONS.tolist(), f"time (h),speed{unit},direction")
    loud, noted = (record.remarks, record.warnings)[:: 1 if unit else -1]
    assert any("a mean over 60 min, is 50.0 m/s; more than 45 m/s" in said for said in loud)
    assert not any("50.0" in said for said in noted)


@pytest.mark.parametrize("unit", ["", " (m/s)"])
def test_a_drift_potential_beyond_all_dunes_is_doubted(tmp_path, unit):
    """A steady 12 m/s is 23.3 kn: 23.3² (23.3 - 12) = 6164 VU."""
    hours = range(0, 366 * 24, 3)
    (tmp_path / "wind.csv").write_text(
        "\n".join([f"time (h),speed{unit},direction", *(f"{k},{12 + k % 2 / 10},270" for k in hours)])
    )
    found = assess_record(read_record(tmp_path / "wind.csv"), Saltation())
    loud, quiet = (found.remarks, found.warnings)[:: 1 if unit else -1]
    assert any("more than 5000 VU are hardly possible" in said for said in loud)
    assert not any("5000 VU" in said for said in quiet)


def test_a_sensor_that_is_stuck_for_a_day_is_remarked(tmp_path):
    speeds, directions = winds(count=60)
    speeds[10:40] = 11.0
    remarks = read(tmp_path, speeds.tolist(), directions.tolist()).remarks
    (said,) = [remark for remark in remarks if "stuck" in remark]
    assert "11 m/s for 30 hours on end, 50.0% of the record" in said
    speeds[::5] += 0.1
    alive = read(tmp_path, speeds.tolist(), directions.tolist())
    assert not any("stuck" in remark for remark in alive.remarks)


@pytest.mark.parametrize(
    ("words", "angles"),
    [
        (("NNO", "O", "W", "SW"), (22.5, 90.0, 270.0, 225.0)),
        (("NNO", "O", "E", "SE"), (337.5, 270.0, 90.0, 135.0)),
        (("NNO", "ZW", "W", "Z"), (22.5, 225.0, 270.0, 180.0)),
    ],
)
def test_points_of_the_compass_of_other_languages_are_told_by_a_columns_letters(tmp_path, words, angles):
    """Ost and Oost in German and Dutch, ouest and oeste in French and Spanish; Zuid in Dutch."""
    rows = "".join(
        f"{day:02}.01.2024;{hour}:00;4,5;{word}\n" for day in (30, 31) for hour, word in enumerate(words)
    )
    (tmp_path / "wind.csv").write_text(f"Datum;Uhrzeit;Windgeschwindigkeit (m/s);Windrichtung\n{rows}")
    record = read_record(tmp_path / "wind.csv", RecordFormat(time_format="%d.%m.%Y %H:%M"))
    assert tuple(record.direction[:4]) == angles
    assert record.start == np.datetime64("2024-01-30T00:00:00")


def test_points_with_o_that_could_be_east_or_west_are_refused(tmp_path):
    (tmp_path / "wind.csv").write_text("time,speed,direction\n2024-01-01 00:00,4,NO\n2024-01-01 01:00,4,S\n")
    with pytest.raises(RecordError, match=r"O is east \(Ost\) or west \(ouest\)"):
        read_record(tmp_path / "wind.csv")
