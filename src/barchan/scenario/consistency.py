"""Checks across the parts of a scenario."""

from typing import TYPE_CHECKING

from barchan.models import Model
from barchan.scenario.source_map import Path
from barchan.wind import Recorded

if TYPE_CHECKING:
    from barchan.scenario.definition import Scenario

Found = tuple[Path, str]
"""The key at fault and the problem."""


def inconsistencies(scenario: "Scenario", model: Model) -> list[Found]:
    """All that does not go together in a scenario whose parts are right by themselves."""
    found = list(_clock_problems(scenario, model))
    if not found:
        found += [(("model", key), text) for key, text in model.problems(scenario.step_seconds)]
    known = scenario.clock is not None or model.step_seconds is not None
    return found if known else [*found, *_timeless(scenario)]


def _clock_problems(scenario: "Scenario", model: Model) -> list[Found]:
    clock = scenario.clock
    if clock is None:
        return []
    if model.step_seconds is not None:
        text = f"is given, but the steps of {model.title} last {model.step_seconds:g} s by themselves"
        return [(("clock",), f"{text}; leave it out")]
    try:
        volume = model.step_volume()
    except ValueError as error:
        return [(("clock",), str(error))]
    try:
        clock.duration(volume)
    except ValueError as error:
        return [(("clock", "reference_speed"), str(error))]
    return []


def _timeless(scenario: "Scenario") -> list[Found]:
    """Speeds and durations that ask for a clock where there is none."""
    found: list[Found] = []
    if isinstance(scenario.wind, Recorded):
        text = 'is a record, whose winds need a clock for their number of polls; add "clock": {}'
        found.append((("wind", "kind"), text))
    for path, part in scenario.wind.placed_parts():
        if part.unit == "m/s":
            text = "is m/s, which needs a clock for its number of polls"
            found.append((("wind", *path, "unit"), f'{text}; add "clock": {{}} or state the speed in cells'))
        if part.lasting_seconds is not None:
            text = f"is {part.lasting_seconds:g} s, which needs a clock"
            found.append((("wind", *path, "seconds"), f'{text}; add "clock": {{}} or state it in steps'))
    return found
