"""The words of presets, which the studio shows as they are."""

import re

import pytest

from barchan.scenario import load_scenario, preset_names


@pytest.mark.parametrize("name", preset_names())
def test_words_of_a_preset_hold_no_command_and_no_file_of_ours(name):
    scenario = load_scenario(name)
    for words in (scenario.title, scenario.citation, scenario.look_for):
        assert not re.search(r"--\w|`|barchan \w+ \w*--|seed 0\d", words)
