"""``barchan presets``: the scenarios that ship with Barchan."""

import json

import pytest

from barchan.cli.terminal import console
from barchan.scenario import load_scenario, preset_names


def test_every_preset_is_listed_with_its_title(barchan, monkeypatch):
    monkeypatch.setattr(console, "width", 400)
    out = barchan("presets").out
    for name in preset_names():
        scenario = load_scenario(name)
        (line,) = (line for line in out.splitlines() if line.split()[0] == name)
        assert scenario.title in line
        assert scenario.citation in line


@pytest.mark.parametrize("name", preset_names())
def test_a_preset_is_printed_as_a_complete_scenario_file(barchan, name):
    out = barchan("presets", name).out
    assert load_scenario(json.loads(out)) == load_scenario(name)
    assert out == load_scenario(name).text()
