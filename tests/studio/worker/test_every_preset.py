"""Every preset can be told to the page, with every field that it offers."""

import pytest

from barchan.parameters import Parameters
from barchan.scenario import load_scenario, preset_names
from barchan.simulation import Simulation
from barchan.studio.worker.description import description
from barchan.studio.worker.frame_fields import CHANGE, encoded_field


def one_of_each_kind():
    """Of presets that change the same parts of a model the first one always; the others before a release."""
    seen, marked = set(), []
    for name in preset_names():
        rules = load_scenario(name).model
        plain = type(rules)()
        changed = {key for key, part in rules if isinstance(part, Parameters) and part != getattr(plain, key)}
        kind = (rules.name, *sorted(changed))
        marked.append(pytest.param(name, marks=[pytest.mark.extended] if kind in seen else []))
        seen.add(kind)
    return marked


@pytest.mark.parametrize("name", one_of_each_kind())
def test_a_preset_is_described_and_each_of_its_fields_is_sent(name):
    scenario = load_scenario(name, [("run.seed", "1")])
    simulation = Simulation(scenario)
    told = description(simulation, scenario)
    names = [field["name"] for field in told["fields"]]
    assert len(names) == len(set(names))
    for field in names:
        sent = encoded_field(simulation, field, simulation.elevation if field == CHANGE else None)
        assert sent is not None
        assert sent.name == field
