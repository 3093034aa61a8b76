"""What a scenario's wind does: whether it moves anything, and which keys it leaves without effect."""

from dataclasses import replace
from typing import TYPE_CHECKING

from barchan.scenario.cost import sampled_segments
from barchan.wind import SeriesWind
from barchan.wind.segment import Segment

if TYPE_CHECKING:
    from barchan.scenario.definition import Scenario


def stated_speeds(scenario: "Scenario") -> list[float]:
    """The speeds (m/s) that the winds of the run state, gusts among them; of a record the whole range."""
    if isinstance(scenario.wind, SeriesWind):
        speed = scenario.wind.series(scenario.seeded().seed).record.speed
        return [float(speed.min()), float(speed.max())]
    return [segment.speed for segment in sampled_segments(scenario) if segment.speed is not None]


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
    clock = scenario.clock
    polls = 1 if speed > 0 and (clock is None or float(clock.volume_flux(speed)) > 0) else 0
    return [replace(scenario.seeded().forcing().wind_of(0), speed=speed, polls=polls)]


def beyond_range(scenario: "Scenario") -> list[str]:
    """A remark on a record with air warmer or colder than the model's rules hold for."""
    limits = scenario.new_model().temperature_range
    if limits is None or not isinstance(scenario.wind, SeriesWind):
        return []
    temperature = scenario.wind.series(scenario.seeded().seed).record.temperature
    if temperature is None:
        return []
    low, high = limits
    outside = temperature[(temperature < low) | (temperature > high)]
    if not outside.size:
        return []
    told = (
        f"{outside.size} of the record's {temperature.size} rows have air of {outside.min():.3g} to "
        f"{outside.max():.3g} °C, beyond {low:g} to {high:g} °C, for which the rules of "
        f"{scenario.new_model().title} hold: they count as the nearest of these; melt is not modelled"
    )
    return [told]


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
