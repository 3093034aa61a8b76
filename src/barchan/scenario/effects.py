"""What a scenario's wind does: whether it moves anything, and which keys it leaves without effect."""

import math
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from barchan.aeolian.wall import REFERENCE_HEIGHT
from barchan.errors import Problem, ScenarioError
from barchan.ground.sand import FileSand
from barchan.parameters import idle_keys
from barchan.scenario.cost import SAMPLES, sampled_segments
from barchan.scenario.messages import value_text
from barchan.wind import Recorded, SeriesWind, Wind
from barchan.wind.records.summary import height_remarks, record_facts
from barchan.wind.segment import Segment

if TYPE_CHECKING:
    from barchan.scenario.definition import Scenario


def stated_speeds(scenario: "Scenario") -> list[float]:
    """The speeds (m/s) that the winds of the run state, gusts among them; of a record the whole range."""
    if isinstance(scenario.wind, SeriesWind):
        speed = scenario.wind.series(scenario.seeded().seed).record.speed
        return [float(speed.min()), float(speed.max())]
    return [segment.speed for segment in sampled_segments(scenario) if segment.speed is not None]


def recorded_facts(scenario: "Scenario") -> dict[str, str]:
    """File, columns, height, time and rows of the wind's record, where it is one, for people to read."""
    wind = scenario.wind
    return record_facts(wind.record, _height_of_law(scenario)) if isinstance(wind, Recorded) else {}


def recorded_remarks(scenario: "Scenario") -> list[str]:
    """Doubts about the wind's record, where it is one, and the assumptions made in reading it."""
    if not isinstance(scenario.wind, Recorded):
        return []
    record = scenario.wind.record
    assumed = height_remarks(record, _height_of_law(scenario), "wind.columns.height")
    return [*record.warnings, *record.remarks, *assumed]


def _height_of_law(scenario: "Scenario") -> float:
    """Height (m) at which speeds are taken to be that state none: the clock's, or without a clock 10 m."""
    return REFERENCE_HEIGHT if scenario.clock is None else scenario.clock.height


def unmoved(scenario: "Scenario") -> list[str]:
    """A remark where no wind of the run can move anything."""
    if scenario.run.steps == 0 or can_move(scenario):
        return []
    speeds = stated_speeds(scenario)
    fastest = f"; the fastest wind blows at {max(speeds):.3g} m/s" if speeds else ""
    least = scenario.clock.threshold_speed() if scenario.clock is not None else None
    threshold = f", and sand moves above {least:.3g} m/s" if least is not None else ""
    return [f"nothing moves: no wind of the run is above the threshold{fastest}{threshold}"]


def can_move(scenario: "Scenario") -> bool:
    """Whether any wind of the run can move anything."""
    model = scenario.new_model()
    return any(map(model.moves, [*sampled_segments(scenario), *_strongest(scenario)]))


def _strongest(scenario: "Scenario") -> list[Segment]:
    """The strongest wind of a record, which the sampled steps may miss."""
    if not isinstance(scenario.wind, SeriesWind):
        return []
    speed = float(scenario.wind.series(scenario.seeded().seed).record.speed.max())
    clock, strength = scenario.clock, scenario.new_model().strength
    moving = speed > 0.0
    if clock is not None:
        moving &= float(clock.volume_flux(speed)) > 0.0
    elif strength is not None:
        moving &= float(strength(np.array([speed]))[0]) > 0.0
    polls = int(moving)
    return [replace(scenario.seeded().forcing().wind_of(0), speed=speed, polls=polls)]


def falls_too_little(scenario: "Scenario") -> list[str]:
    """A remark where less than a quantum of snow falls on a cell during the run."""
    layer, seconds = scenario.layers[-1], scenario.step_seconds
    segments = sampled_segments(scenario)
    rates = [(s.weather.snowfall or 0.0) * s.share for s in segments]
    if layer.mass is None or seconds is None or not any(rates):
        return []
    sampled = min(scenario.run.steps, SAMPLES)
    fallen = math.fsum(rates) / sampled * scenario.run.steps * seconds
    if fallen >= layer.mass:
        return []
    text = (
        f"about {fallen:.2g} kg/m² of snow fall during the run, {fallen / layer.mass:.2g} quanta of "
        f"{layer.mass:g} kg/m² on a cell: most cells get none"
    )
    return [text]


def refuse_weather(scenario: "Scenario", wind: Wind) -> None:
    """Raise ScenarioError where a record is colder or warmer than the model's rules hold for."""
    model = scenario.new_model()
    if model.temperature_range is None or not isinstance(wind, SeriesWind):
        return
    record = wind.series(scenario.seeded().seed).record
    if record.temperature is None:
        return
    low, high = model.temperature_range
    wrong = (record.temperature < low) | (record.temperature > high)
    if not wrong.any():
        return
    row = int(np.argmax(wrong))
    at = f"{record.time[row]:g} s" if record.start is None else str(record.start + _seconds(record.time[row]))
    others = f" ({np.count_nonzero(wrong)} rows in all)" if np.count_nonzero(wrong) > 1 else ""
    message = (
        f"{record.source} has a temperature of {record.temperature[row]:.4g} °C at {at}; allowed with "
        f"{model.title}: {low:g} to {high:g} °C{others}"
    )
    raise ScenarioError([Problem("wind", message)], record.source)


def _seconds(time: float) -> np.timedelta64:
    return np.timedelta64(round(time), "s")


def idle(scenario: "Scenario") -> list[str]:
    """Remarks on keys that the choice of another key leaves without effect."""
    return [
        f"{key} {value_text(value)} has no effect: it acts {where}"
        for key, value, where in idle_keys(scenario)
    ]


def sand_facts(scenario: "Scenario") -> dict[str, str]:
    """How many cells of a file of sand were filled, where any were."""
    filled = scenario.sand.fill_facts() if isinstance(scenario.sand, FileSand) else ""
    return {"sand": filled} if filled else {}


def unused(scenario: "Scenario") -> list[str]:
    """Remarks on a hop length or a wind speed of the model in whose place every wind states its own."""
    winds = [part for _, part in scenario.wind.placed_parts()]
    if not winds or any(part.speed is None for part in winds):
        return []
    in_cells = all(part.unit == "cells" for part in winds)
    key = "hop_length" if in_cells else "wind_speed"
    if not in_cells and any(part.unit == "cells" for part in winds):
        return []
    field = type(scenario.model).model_fields.get(key)
    value = getattr(scenario.model, key, None)
    if field is None or value == field.default:
        return []
    return [f"model.{key} {value:g} has no effect: the wind states its own speed"]
