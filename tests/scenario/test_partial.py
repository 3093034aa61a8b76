import json

import pytest

from barchan.errors import ScenarioError
from barchan.scenario.partial import changes, read_text, salvage

GOOD = {"barchan": 5, "model": {"name": "momiji", "p_s": 0.7}, "wind": {"kind": "steady", "direction": 200}}


def test_a_sound_text_is_the_scenario_without_problems():
    scenario, problems = salvage(json.dumps(GOOD), "mine.json")
    assert problems == []
    assert scenario == read_text(json.dumps(GOOD), "mine.json")
    assert scenario.model.p_s == 0.7


def test_every_bad_key_is_named_and_the_rest_is_used():
    broken = {**GOOD, "sand": {"mean": "much"}, "wind": {"direction": 700}, "colour": "red"}
    broken["model"] = {**GOOD["model"], "hops": 3}
    scenario, problems = salvage(json.dumps(broken), "mine.json")
    assert {p.key for p in problems} == {"sand.mean", "wind.direction", "colour", "model.hops"}
    assert scenario.model.p_s == 0.7
    assert scenario.wind.direction == 270.0


def test_a_group_that_lacks_something_is_left_out():
    regimes = {"kind": "regimes", "regimes": [{"direction": 10, "steps": 5}, {"steps": 6}]}
    scenario, problems = salvage(json.dumps({**GOOD, "wind": regimes}), "mine.json")
    assert [p.key for p in problems] == ["wind.regimes[1].direction"]
    assert [regime.direction for regime in scenario.wind.regimes] == [10]


def test_every_regime_that_is_right_stays_and_the_loss_of_the_others_is_named():
    broken = [{"direction": -900, "steps": 80}, {"steps": 0}, {"direction": 90, "steps": 40}]
    broken += [{"direction": 180, "steps": 80, "directon": 90}]
    text = json.dumps({**GOOD, "wind": {"kind": "regimes", "regimes": broken}})
    scenario, _ = salvage(text, "mine.json")
    assert [(one.direction, one.steps) for one in scenario.wind.regimes] == [(90, 40), (180, 80)]
    assert changes(text, "mine.json", scenario) == ["wind.regimes: 2 of 4 are used, the others are left out"]


def test_a_wind_that_cannot_be_used_at_all_and_its_replacement_are_named():
    text = json.dumps({**GOOD, "wind": {"kind": "regimes", "regimes": [{"direction": "NNW", "steps": 80}]}})
    scenario, _ = salvage(text, "mine.json")
    assert scenario.wind.kind == "steady"
    said = ["wind: steady, with its defaults, takes the place of regimes, which is left out"]
    assert changes(text, "mine.json", scenario) == said


def test_a_missing_or_unknown_version_is_taken_as_todays():
    without = {key: value for key, value in GOOD.items() if key != "barchan"}
    for broken in (without, {**GOOD, "barchan": 99}):
        scenario, problems = salvage(json.dumps(broken), "mine.json")
        assert [p.key for p in problems] == ["barchan"]
        assert scenario.model.name == "momiji"


@pytest.mark.parametrize("text", ["", "{", "[]", "3", "nonsense"])
def test_what_is_no_scenario_at_all_is_refused(text):
    with pytest.raises(ScenarioError):
        salvage(text, "mine.json")
