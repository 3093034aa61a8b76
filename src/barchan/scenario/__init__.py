"""The scenario: everything that defines a run, as validated data, and the files it is kept in."""

from barchan.scenario.definition import FORMAT, Run, Scenario, SteadyState, Until
from barchan.scenario.files import load_scenario, preset_names, validate
from barchan.scenario.messages import nearest

__all__ = [
    "FORMAT",
    "Run",
    "Scenario",
    "SteadyState",
    "Until",
    "load_scenario",
    "nearest",
    "preset_names",
    "validate",
]
