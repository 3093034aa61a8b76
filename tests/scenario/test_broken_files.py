"""Broken scenario files are refused in a few words, never with a traceback and never at length."""

import json
from random import Random

import pytest

from barchan.errors import MOST_CHARACTERS, BarchanError, Problem, ScenarioError
from barchan.scenario import load_scenario, preset_names
from barchan.scenario.files import validate
from barchan.scenario.overrides import value_of

LINES, CHARACTERS = 25, 120


def refusal(folder, text):
    """How a file with this text is refused."""
    (folder / "broken.json").write_text(text, "utf-8")
    with pytest.raises(ScenarioError) as error:
        load_scenario(folder / "broken.json")
    return str(error.value)


@pytest.mark.parametrize("depth", [60, 1_000, 100_000])
@pytest.mark.parametrize("brackets", ["[]", '{"a":}'])
def test_groups_nested_too_deeply_are_refused(tmp_path, depth, brackets):
    opening, closing = brackets[:-1], brackets[-1]
    text = '{"barchan": 5, "sand": ' + opening * depth + "1" + closing * depth + "}"
    assert "deep in one another" in refusal(tmp_path, text)


def test_data_that_hold_themselves_are_refused():
    data = {"barchan": 5}
    data["sand"] = data
    with pytest.raises(ScenarioError, match="deep in one another"):
        validate(data)


def test_data_that_are_no_json_are_refused():
    with pytest.raises(ScenarioError, match="cannot be written as JSON"):
        validate({"barchan": 5, "title": object()})


@pytest.mark.parametrize("text", ["[" * 100_000, "9" * 10_000, "NaN", "{"])
def test_a_value_on_the_command_line_that_is_no_json_is_taken_as_text(text):
    assert value_of(text) == text


def test_three_thousand_problems_fill_a_screen_and_are_counted(tmp_path):
    keys = {f"unknown_{number}": number for number in range(3000)}
    text = refusal(tmp_path, json.dumps({"barchan": 5, "run": keys}))
    assert text.startswith(f"{tmp_path / 'broken.json'}: 3000 problems\n")
    assert text.endswith("\n  and 2,980 more")
    assert len(text.splitlines()) <= LINES
    assert len(text) < LINES * CHARACTERS * 2


def test_all_problems_are_kept_for_programs_however_many_are_shown(tmp_path):
    (tmp_path / "broken.json").write_text(json.dumps({"barchan": 5, "run": {f"k{n}": 1 for n in range(99)}}))
    with pytest.raises(ScenarioError) as error:
        load_scenario(tmp_path / "broken.json")
    assert len(error.value.problems) == 99


def test_a_key_or_a_message_of_any_length_is_cut():
    problem = Problem("k" * 10_000, "m" * 100_000, "file:3")
    assert len(str(problem)) < MOST_CHARACTERS + 200
    assert str(problem).endswith("… (file:3)")


def test_a_very_long_unknown_key_is_refused_at_once(tmp_path):
    assert "unknown key" in refusal(tmp_path, json.dumps({"barchan": 5, "x" * 200_000: 1}))


def _mutated(rng, text):
    """A text with some characters, numbers or whole pieces changed, dropped, doubled or put elsewhere."""
    for _ in range(rng.randint(1, 3)):
        at = rng.randrange(len(text))
        end = min(len(text), at + rng.choice([1, 1, 5, 40]))
        piece = rng.choice(
            [
                "",
                text[at:end] * rng.choice([2, 50]),
                "[" * rng.choice([1, 2000]),
                '"',
                "null",
                "1e999",
                "-",
                "\\ud800",
            ]
        )
        text = text[:at] + piece + text[end:]
    return text


def _answer(path):
    """How a file is refused; nothing where it is read."""
    try:
        load_scenario(path)
    except BarchanError as error:
        return str(error)
    return ""


def test_mutations_of_presets_are_read_or_refused(tmp_path):
    """No other exception than a refusal, and none that is longer than a screen or two."""
    rng = Random(8)
    presets = [load_scenario(name).text() for name in preset_names()]
    for _ in range(400):
        text = _mutated(rng, rng.choice(presets))
        (tmp_path / "broken.json").write_text(text, "utf-8")
        assert len(_answer(tmp_path / "broken.json")) < 25_000
