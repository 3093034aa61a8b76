"""The changes of a run's parameters and wind, in the order in which they were made."""

from copy import deepcopy
from typing import Any

from barchan.simulation import SetParameter, SetWind, Simulation

WIND = "wind"


def changes_of(simulation: Simulation) -> list[dict[str, Any]]:
    """Step, key, value before and since of every change, and whether it can be undone.

    Of several changes of one key only the newest can: undoing it is a change back to the value before.
    """
    scenario = deepcopy(simulation.scenario.data())
    found: list[dict[str, Any]] = []
    for record in simulation.events:
        event = record.event
        if not isinstance(event, SetParameter | SetWind):
            continue
        key = event.key if isinstance(event, SetParameter) else WIND
        before = deepcopy(_value(scenario, key))
        event.amend(scenario)
        for earlier in found:
            earlier["undo"] &= earlier["key"] != key
        found.append(
            {
                "step": record.step,
                "key": key,
                "before": before,
                "value": _value(scenario, key),
                "undo": before != _value(scenario, key),
                "summary": event.wind.summary() if isinstance(event, SetWind) else "",
            }
        )
    return found


def _value(scenario: dict[str, Any], key: str) -> Any:
    value: Any = scenario
    for name in key.split("."):
        value = value[name]
    return value
