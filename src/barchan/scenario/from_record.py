"""A run as long as the record of its wind: ``"run": {"steps": "record"}``."""

import math
from typing import Any, NoReturn

from barchan.errors import Problem, ScenarioError
from barchan.scenario.definition import MOST_STEPS, Scenario
from barchan.scenario.lengths import ROUNDED, wind_steps
from barchan.wind import SeriesWind

RECORD = "record"


def without_record(data: dict[str, Any]) -> bool:
    """Whether a scenario's data ask for a run as long as its record; the key is then taken out of them."""
    run = data.get("run")
    if not isinstance(run, dict) or run.get("steps") != RECORD:
        return False
    data["run"] = {key: value for key, value in run.items() if key != "steps"}
    return True


def as_long_as_record(scenario: Scenario) -> Scenario:
    """The scenario with as many steps as its record lasts, the last of which may reach beyond its end.

    Raises ScenarioError for a wind that is no record, for one that starts over and so has no end, and where
    the record cannot be read.
    """
    with scenario.source_map.locating_errors():
        if not isinstance(scenario.wind, SeriesWind):
            _refuse("which needs a wind of kind 'record' or 'storms'")
        if scenario.wind.repeat:
            _refuse("but the record starts over at its end and so has none; set wind.repeat to false")
        steps = wind_steps(scenario)
        if steps is None:
            _refuse("which needs steps of a known duration; give the scenario a clock")
        whole = max(math.ceil(steps - ROUNDED), 1)
        if whole > MOST_STEPS:
            _refuse(f"which comes to {whole} steps; allowed: ≤ {MOST_STEPS}")
    return scenario.model_copy(update={"run": scenario.run.model_copy(update={"steps": whole})})


def _refuse(text: str) -> NoReturn:
    raise ScenarioError([Problem("run.steps", f"is '{RECORD}', {text}")])
