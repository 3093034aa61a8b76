"""Checks across the parts of a scenario."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.directions import downwind
from barchan.errors import ScenarioError
from barchan.ground.edges import unmatched_edges
from barchan.models import Model
from barchan.scenario.source_map import Path
from barchan.streams import Stream
from barchan.wind import Recorded

if TYPE_CHECKING:
    from barchan.scenario.definition import Scenario

Found = tuple[Path, str]
"""The key at fault and the problem."""


def inconsistencies(scenario: "Scenario", model: Model) -> list[Found]:
    """All that does not go together in a scenario whose parts are right by themselves."""
    found = [*_clock_problems(scenario, model), *_influx_problems(scenario, model)]
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


_INTO = 1e-9
"""Components of the wind's direction below this do not cross an edge."""


def open_edges(scenario: "Scenario") -> list[str]:
    """The open edges across which the scenario's winds blow into the field, by their sides."""
    if isinstance(scenario.wind, Recorded):
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
    return [f'{text}; state what enters with "influx", for instance {{"kind": "saturation", "share": 0.2}}']


def broken_edges(scenario: "Scenario", ground: NDArray[np.float64] | None) -> list[str]:
    """A remark where edges are joined and the ground does not go on over them; made here if not given."""
    if ground is None:
        try:
            ground = scenario.ground.elevation(scenario.lattice, Stream(scenario.run.seed or 0, "ground"))
        except ScenarioError:  # said where the bed is made
            return []
    return unmatched_edges(ground, scenario.lattice)


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
