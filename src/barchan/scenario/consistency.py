"""Checks across the parts of a scenario."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.directions import downwind
from barchan.errors import ScenarioError
from barchan.ground.edges import unmatched_edges
from barchan.models import Model
from barchan.scenario.source_map import Path
from barchan.streams import Stream
from barchan.wind import Recorded, SeriesWind
from barchan.wind.weather_course import Course

if TYPE_CHECKING:
    from barchan.scenario.definition import Scenario

Found = tuple[Path, str]
"""The key at fault and the problem."""


def inconsistencies(scenario: "Scenario", model: Model) -> list[Found]:
    """All that does not go together in a scenario whose parts are right by themselves."""
    found = [*_lattice_problems(scenario, model)]
    found += [*_clock_problems(scenario, model), *_influx_problems(scenario, model)]
    if not found:
        found += [(("model", key), text) for key, text in model.problems(scenario.step_seconds)]
    found += _hops_problems(scenario, model)
    return [*found, *_unclocked(scenario, model), *_weather_problems(scenario, model)]


def _lattice_problems(scenario: "Scenario", model: Model) -> Iterator[Found]:
    """Cells that a model is not made for, and files of squares on a lattice of hexagons."""
    kind = scenario.lattice.kind
    if kind not in model.lattices:
        yield ("lattice", "kind"), f"is {kind}; allowed with {model.title}: {', '.join(model.lattices)}"
    if kind == "square":
        return
    plants = getattr(scenario.model, "vegetation", None)
    parts = {("ground",): scenario.ground, ("sand",): scenario.sand, ("model", "vegetation"): plants}
    for path, part in parts.items():
        if getattr(part, "kind", None) == "file":
            yield (
                (*path, "kind"),
                "is file, whose cells are squares; allowed with lattice.kind hex: other kinds",
            )


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


def _influx_problems(scenario: "Scenario", model: Model) -> list[Found]:
    if scenario.influx is None:
        return []
    if not model.takes_influx:
        return [(("influx",), f"is given, but {model.title} lets nothing enter; leave it out")]
    if not open_edges(scenario):
        text = (
            "is given, but no wind blows in across an open edge; open boundary_x or boundary_y of the lattice"
        )
        return [(("influx",), text)]
    if scenario.influx.kind == "saturation":
        try:
            model.step_volume()
        except ValueError as error:
            return [(("influx",), str(error))]
    return []


def _hops_problems(scenario: "Scenario", model: Model) -> list[Found]:
    """Speeds in cells under a model that knows no hop length; a calm is one in any unit."""
    if model.takes_hops:
        return []
    text = f"is a hop length in cells, which {model.title} does not use"
    hint = "state the speed in m/s (unit m/s), or leave it out and set the wind speed of the model"
    parts = scenario.wind.placed_parts()
    return [(("wind", *path, "speed"), f"{text}; {hint}") for path, part in parts if part.longest_hop]


_INTO = 1e-9
"""Components of the wind's direction below this do not cross an edge."""


def open_edges(scenario: "Scenario") -> list[str]:
    """The open edges across which the scenario's winds blow into the field, by their sides."""
    if isinstance(scenario.wind, SeriesWind):
        blown = {"west", "east", "south", "north"}
    else:
        blown = set()
        for _, part in scenario.wind.placed_parts():
            x, y = downwind(part.direction)
            blown |= {"west" if x > 0 else "east"} if abs(x) > _INTO else set()
            blown |= {"south" if y > 0 else "north"} if abs(y) > _INTO else set()
    periodic_y, periodic_x = scenario.lattice.periodic
    closed = {"west", "east"} if periodic_x else set()
    closed |= {"south", "north"} if periodic_y else set()
    return sorted(blown - closed)


def starved_edges(scenario: "Scenario") -> list[str]:
    """A remark where wind blows in across open edges and brings nothing."""
    edges = open_edges(scenario)
    if not edges or scenario.influx is not None:
        return []
    sides = " and ".join(edges)
    plural = "edges are" if len(edges) > 1 else "edge is"
    text = f"the {sides} {plural} open and nothing enters there: the wind will empty the field"
    return [f"{text}; state what enters, for instance an influx of kind saturation with a share of 0.2"]


def broken_edges(scenario: "Scenario", ground: NDArray[np.float64] | None) -> list[str]:
    """A remark where edges are joined and the ground does not go on over them; made here if not given."""
    if ground is None:
        try:
            ground = scenario.ground.elevation(scenario.lattice, Stream(scenario.run.seed or 0, "ground"))
        except ScenarioError:  # said where the bed is made
            return []
    return unmatched_edges(ground, scenario.lattice)


def _unclocked(scenario: "Scenario", model: Model) -> list[Found]:
    """Speeds and durations that ask for a clock where there is none."""
    if scenario.clock is not None:
        return []
    own_steps = model.step_seconds is not None
    by_speed = not model.takes_hops or model.strength is not None
    found = [] if by_speed else list(_unclocked_speeds(scenario, model, own_steps))
    if own_steps:
        return found
    for path, seconds in _durations(scenario):
        text = f"is {seconds:g} s, which needs a clock"
        found.append((path, f"{text}; give the scenario a clock, or state it in steps"))
    return found


def _unclocked_speeds(scenario: "Scenario", model: Model, own_steps: bool) -> Iterator[Found]:
    """Winds in m/s, whose number of polls nothing tells."""
    if own_steps:
        text = f"in m/s do not tell how far slabs of {model.title} hop; state a speed in cells"
        series, speed = f"whose winds {text}", f"is m/s; speeds {text}"
    else:
        needs = "a clock for its number of polls"
        series = "whose winds need a clock for their number of polls; give the scenario a clock"
        speed = f"is m/s, which needs {needs}; give the scenario a clock, or state the speed in cells"
    if isinstance(scenario.wind, SeriesWind):
        kind = "a record" if isinstance(scenario.wind, Recorded) else scenario.wind.kind
        yield ("wind", "kind"), f"is {kind}, {series}"
    for path, part in scenario.wind.placed_parts():
        if part.unit == "m/s":
            yield ("wind", *path, "unit"), speed


def _durations(scenario: "Scenario") -> Iterator[tuple[Path, float]]:
    """The durations that are stated in seconds, and their keys."""
    for path, part in scenario.wind.placed_parts():
        if part.lasting_seconds is not None:
            yield ("wind", *path, "seconds"), part.lasting_seconds
    for name, course in _courses(scenario):
        if course.seconds is not None:
            yield ("weather", name, "seconds"), course.seconds


def _courses(scenario: "Scenario") -> Iterator[tuple[str, Course]]:
    """The quantities of the weather that the scenario states over the run, and their keys."""
    if scenario.weather is not None:
        named = zip(("temperature", "snowfall"), scenario.weather.parts(), strict=True)
        yield from ((name, course) for name, course in named if course is not None)


def _weather_problems(scenario: "Scenario", model: Model) -> list[Found]:
    """Temperatures for which the model's rules do not hold."""
    if model.temperature_range is None:
        return []
    coldest, warmest = model.temperature_range
    stated: list[tuple[Path, tuple[float, ...]]] = [
        (("wind", *path, "temperature"), part.temperatures) for path, part in scenario.wind.placed_parts()
    ]
    stated += [
        (("weather", name), course.change.range())
        for name, course in _courses(scenario)
        if name == "temperature"
    ]
    text = f"°C; allowed with {model.title}: temperatures from {coldest:g} to {warmest:g} °C"
    return [
        (path, f"comes to {value:g} {text}")
        for path, values in stated
        for value in dict.fromkeys(values)
        if not coldest <= value <= warmest
    ]
