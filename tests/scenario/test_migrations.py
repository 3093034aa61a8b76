"""Files of earlier formats are brought up to date, one format after the other."""

import pytest

from barchan.scenario import migrations
from barchan.scenario.migrations import migrate


@pytest.fixture
def third_format(monkeypatch):
    """A program of format 3 that knows what changed from 1 to 2 and from 2 to 3."""
    monkeypatch.setattr(migrations, "FORMAT", 3)
    steps = {
        1: lambda data: {**data, "seen": [*data.get("seen", []), 1]},
        2: lambda data: {**data, "seen": [*data.get("seen", []), 2]},
    }
    monkeypatch.setattr(migrations, "STEPS", steps)


@pytest.mark.parametrize(("version", "seen"), [(1, [1, 2]), (2, [2]), (3, None)])
def test_each_change_of_format_is_made_once_in_order(third_format, version, seen):
    data, trouble = migrate({"barchan": version})
    assert trouble == ""
    assert data == {"barchan": 3} | ({"seen": seen} if seen else {})


def test_a_format_of_the_future_is_refused(third_format):
    assert "newer Barchan" in migrate({"barchan": 4})[1]


@pytest.mark.parametrize("version", [0, -1, 1.0, "1", True, None, [1]])
def test_a_version_is_a_whole_number_from_one(version):
    assert "allowed: a format version" in migrate({"barchan": version})[1]


def test_each_regime_of_format_1_keeps_its_ramp_under_the_name_of_today():
    bend = {"kind": "points", "points": [{"time": 0.5, "value": 0.1}]}
    regimes = [{"direction": 270, "steps": 3, "course": bend}, {"direction": 90, "steps": 5}]
    wind = {"kind": "regimes", "regimes": regimes}
    data, trouble = migrate({"barchan": 1, "wind": wind})
    assert trouble == ""
    assert data["wind"]["regimes"] == [
        {"direction": 270, "steps": 3, "speed_ramp": bend},
        {"direction": 90, "steps": 5},
    ]


def test_mixed_axes_of_format_1_keep_the_number_of_their_alternations():
    data, _ = migrate({"barchan": 1, "wind": {"kind": "mixed_axes", "turns": 3}})
    assert data["wind"] == {"kind": "mixed_axes", "alternations": 3}


def test_a_wind_of_an_unknown_form_is_left_to_the_validation():
    for wind in (None, "west", {"kind": "regimes", "regimes": "none"}, {"kind": "regimes", "regimes": [1]}):
        assert migrate({"barchan": 1, "wind": wind})[0]["wind"] == wind
