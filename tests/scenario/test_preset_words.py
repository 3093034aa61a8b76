"""The words of presets, which the studio shows as they are."""

import re

import pytest

from barchan.scenario import load_scenario, preset_names


@pytest.mark.parametrize("name", preset_names())
def test_words_of_a_preset_hold_no_command_and_no_file_of_ours(name):
    scenario = load_scenario(name)
    for words in (scenario.title, scenario.citation, scenario.look_for):
        assert not re.search(r"--\w|`|barchan \w+ \w*--|seed 0\d", words)


@pytest.mark.parametrize("name", preset_names())
def test_words_of_a_preset_call_others_by_their_titles_with_their_names_behind(name):
    """The page shows the title, as on the card; the command line needs the name."""
    scenario = load_scenario(name)
    other = "|".join(sorted(map(re.escape, preset_names()), key=len, reverse=True))
    for words in (scenario.citation, scenario.look_for, scenario.question):
        called = re.findall(r"“([^”]+)” \(([a-z0-9.-]+)\)", words)
        assert all(load_scenario(found).title == title for title, found in called)
        rest = re.sub(r"” \([a-z0-9.-]+\)", "”", words)
        named = re.findall(rf"(?<![\w-])(?:{other})(?![\w-])", rest)
        assert [found for found in named if "-" in found] == []
        assert not re.search(rf"[Cc]ompare with (?:{other})(?![\w-])", rest)


@pytest.mark.parametrize("name", preset_names())
def test_words_of_a_preset_tell_directions_by_compass(name):
    """What is up or to the right on the screen depends on where the camera stands."""
    scenario = load_scenario(name)
    assert not re.search(
        r"\b(upper|lower) (left|right)\b|\bto the (left|right)\b", scenario.look_for + scenario.question
    )
