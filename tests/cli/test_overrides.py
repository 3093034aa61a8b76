"""Values of a scenario given on the command line."""

import json

import pytest

from barchan.cli.overrides import pairs
from barchan.errors import ScenarioError
from barchan.scenario import load_scenario


@pytest.mark.parametrize(
    ("words", "found"),
    [
        ([], []),
        (["--run.seed", "3"], [("run.seed", "3")]),
        (["--run.seed=3"], [("run.seed", "3")]),
        (["--ground.level", "-5"], [("ground.level", "-5")]),
        (["--ground.level=-5"], [("ground.level", "-5")]),
        (["--title", "a=b"], [("title", "a=b")]),
        (["--title=a=b"], [("title", "a=b")]),
        (["--title="], [("title", "")]),
        (["--title", "two words", "--run.seed=3"], [("title", "two words"), ("run.seed", "3")]),
        (
            ["--model.hop-length", "7", "--model.hop-length", "8"],
            [("model.hop-length", "7"), ("model.hop-length", "8")],
        ),
    ],
)
def test_keys_and_values_come_in_pairs(words, found):
    assert pairs(tuple(words)) == found


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["5"], ["5: is not a key; write --key value"]),
        (["--run.seed"], ["run.seed: has no value; write --key value"]),
        (["--run.seed", "--title", "x"], ["run.seed: has no value; write --key value"]),
        (["--title", "x", "y"], ["y: is not a key; write --key value"]),
        (["a", "--run.b"], ["a: is not a key; write --key value", "run.b: has no value; write --key value"]),
        (["--titel", "x"], ["--titel: is no option and no key; did you mean '--title'?"]),
    ],
)
def test_every_word_that_is_neither_is_reported(words, said):
    with pytest.raises(ScenarioError) as caught:
        pairs(tuple(words))
    assert [f"{problem.key}: {problem.message}" for problem in caught.value.problems] == said
    assert {problem.place for problem in caught.value.problems} == {"command line"}


@pytest.mark.parametrize(
    "words",
    [
        ["--ground.level", "-5.5", "--model.hop-length", "7"],
        ["--ground.level=-5.5", "--model.hop_length=7"],
    ],
)
def test_given_values_reach_the_run(here, barchan, words):
    given = ["--quiet", *words, "--no-picture", "--out", "run"]
    assert barchan("run", "tiny.json", *given).code == 0
    scenario = load_scenario(here / "run" / "scenario.json")
    assert (scenario.ground.level, scenario.model.hop_length) == (-5.5, 7.0)


def test_options_and_values_may_come_in_any_order(here, barchan):
    result = barchan(
        "run", "--quiet", "tiny.json", "--run.seed", "9", "--no-picture", "--out", "run", "--title=x"
    )
    assert (result.code, result.out, result.err) == (0, "", "")
    scenario = load_scenario(here / "run" / "scenario.json")
    assert (scenario.seed, scenario.title) == (9, "x")


def test_lists_and_groups_are_given_as_json(here, barchan):
    sand = json.dumps({"kind": "dropped", "mean": 2, "parts": [{"mean": 9, "east": 0.5}]})
    assert barchan("check", "tiny.json", "--sand", sand).code == 0


def test_a_mistyped_option_is_told_with_the_option_meant(here, barchan):
    assert "--quiet" in barchan("run", "tiny.json", "--quite").err
    assert "--out" in barchan("run", "tiny.json", "--outt", "folder").err
