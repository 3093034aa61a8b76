import json

import pytest

from barchan.errors import ScenarioError
from barchan.scenario.partial import read_text, salvage

GOOD = {"barchan": 3, "model": {"name": "momiji", "p_s": 0.7}, "wind": {"kind": "steady", "direction": 200}}


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
