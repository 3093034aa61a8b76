"""Files of earlier formats are brought up to date, one format after the other."""

import pytest

from barchan.scenario import load_scenario, migrations
from barchan.scenario.migrations import migrate


@pytest.fixture
def third_format(monkeypatch):
    """A program of format 3 that knows of some change from 1 to 2 and from 2 to 3."""
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
    assert "newer Barchan" in migrate({"barchan": 5})[1]


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


def shadow_from(data, version=2):
    model = migrate({"barchan": version, **data})[0]["model"]
    return model.get("shadow_from") if isinstance(model, dict) else None


@pytest.mark.parametrize("version", [1, 2])
@pytest.mark.parametrize("name", ["werner", "momiji", "bishop", "nield_baas", "pelletier", "snow_werner"])
def test_shadow_lines_of_a_slab_model_start_at_the_centre_where_an_earlier_file_says_nothing(name, version):
    assert shadow_from({"model": {"name": name}}, version) == "centre"


def test_shadow_lines_start_where_an_earlier_file_says():
    assert shadow_from({"model": {"name": "werner", "shadow_from": "edge"}}) == "edge"


@pytest.mark.parametrize("data", [{}, {"model": {}}, {"model": {"p_s": 0.5}}])
def test_the_default_model_of_an_earlier_file_keeps_its_shadow_lines(data):
    assert shadow_from(data) == "centre"
    assert load_scenario({"barchan": 2, **data}).model.shadow_from == "centre"


HEX = {"lattice": {"kind": "hex"}}


@pytest.mark.parametrize("version", [1, 2, 3])
@pytest.mark.parametrize("model", [{}, {"shadow_from": "auto"}, {"name": "momiji"}])
def test_on_hexagons_shadow_lines_of_an_earlier_file_start_at_the_centre(version, model):
    assert shadow_from({**HEX, "model": model}, version) == "centre"


def test_on_hexagons_shadow_lines_start_where_an_earlier_file_says():
    assert shadow_from({**HEX, "model": {"shadow_from": "edge"}}, 3) == "edge"
    assert shadow_from(HEX, 3) == "centre"


@pytest.mark.parametrize("model", [{"name": "ripples"}, {"name": 3}, "werner", None])
def test_on_hexagons_too_what_has_no_shadow_lines_is_left_as_it_is(model):
    assert migrate({"barchan": 3, **HEX, "model": model}) == ({"barchan": 5, **HEX, "model": model}, "")


@pytest.mark.parametrize("lattice", [{}, {"lattice": {}}, {"lattice": {"kind": "square"}}, {"lattice": 3}])
def test_a_file_of_format_3_on_squares_keeps_its_automatic_choice(lattice):
    for model in ({"name": "werner"}, {"name": "werner", "shadow_from": "auto"}):
        data, problem = migrate({"barchan": 3, **lattice, "model": model})
        assert problem == ""
        assert data["model"].get("shadow_from", "auto") == "auto"


@pytest.mark.parametrize("version", [3, 4])
@pytest.mark.parametrize("model", [{}, {"shadow_from": "auto"}, {"name": "momiji", "shadow_from": "place"}])
def test_tops_of_stacks_of_an_earlier_file_are_level(version, model):
    assert load_scenario({"barchan": version, "model": model}).model.stack_tops == "level"


@pytest.mark.parametrize(
    "model", [{"shadow_from": "centre"}, {"name": "ripples"}, {"name": 3}, "werner", None]
)
def test_where_tops_of_stacks_do_not_act_an_earlier_file_is_left_as_it_is(model):
    (data, _) = migrate({"barchan": 4, "model": model})
    assert "stack_tops" not in (data["model"] if isinstance(data["model"], dict) else {})


def test_a_file_of_today_says_nothing_of_shadow_lines_and_gets_todays_default():
    assert load_scenario({"barchan": 5}).model.shadow_from == "auto"
    assert load_scenario({"barchan": 5}).model.stack_tops == "sloping"


@pytest.mark.parametrize(
    "model", [{"name": "ripples"}, {"name": "unknown"}, {"name": 3}, "werner", None, [1]]
)
def test_models_without_shadow_lines_and_no_models_at_all_are_left_as_they_are(model):
    assert migrate({"barchan": 2, "model": model}) == ({"barchan": 5, "model": model}, "")
