"""``barchan presets``: the scenarios that ship with Barchan."""

import json

import pytest

from barchan.scenario import load_scenario, preset_names


def test_every_preset_is_listed_by_its_model_with_title_size_time_and_source(barchan):
    lines = barchan("presets").out.splitlines()
    for name in preset_names():
        scenario = load_scenario(name)
        (at,) = (at for at, line in enumerate(lines) if line.startswith(f"  {name} "))
        assert scenario.title in lines[at]
        size = f"{scenario.lattice.columns} × {scenario.lattice.rows} cells, {scenario.run.steps} steps, "
        assert lines[at + 1].strip().startswith(size)
        assert lines[at + 1].endswith(scenario.citation)
        heading = next(line for line in reversed(lines[:at]) if line and not line.startswith(" "))
        assert heading.endswith(f", model {scenario.model.name}")


def test_the_expected_time_of_a_preset_stands_beside_it(barchan):
    """1000 steps of 65,536 polls at 20 million a second: 3.3 s."""
    lines = barchan("presets").out.splitlines()
    (at,) = (at for at, line in enumerate(lines) if line.startswith("  barchans "))
    assert "256 × 256 cells, 1000 steps, about 3 seconds; " in lines[at + 1]


@pytest.mark.parametrize("name", preset_names())
def test_a_preset_is_printed_as_a_complete_scenario_file(barchan, name):
    out = barchan("presets", name).out
    assert load_scenario(json.loads(out)) == load_scenario(name)
    assert out == load_scenario(name).text()
