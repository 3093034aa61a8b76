"""Strokes of a brush on a running simulation, with undo and redo.

While no step has been done since, undoing puts back exactly what was there, the journal of events included.
Later it is an event of its own: the strokes are made again the other way round.
"""

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from barchan.errors import BarchanError
from barchan.simulation import MOST_TRAIL, AnyStroke, BrushStroke, Simulation, Stamp, State, event_from
from barchan.studio.protocol import Request

MOST_GESTURES = 100
"""Gestures that can be undone."""

_PLACE = {"x", "y", "trail"}
"""What differs between the stamps of a gesture."""


@dataclass
class Gesture:
    """All strokes from pressing the button to letting it go."""

    before: State | None
    after: State | None = None
    strokes: list[AnyStroke] = field(default_factory=list)
    inverse: list[AnyStroke] = field(default_factory=list)


class Painting:
    """The gestures made on one simulation."""

    def __init__(self) -> None:
        """Nothing painted."""
        self.done: list[Gesture] = []
        self.undone: list[Gesture] = []

    def begin(self, simulation: Simulation) -> None:
        """A gesture begins."""
        self.done = [*self.done, Gesture(simulation.state())][-MOST_GESTURES:]
        self.undone = []

    def stroke(self, simulation: Simulation, stroke: AnyStroke) -> None:
        """Paint, as part of the gesture that was begun last."""
        gesture = self.done[-1]
        stroke = stroke.model_copy(update={"trail": _trail(gesture, stroke)})
        gesture.inverse.insert(0, _inverse(simulation, stroke))
        simulation.apply(stroke)
        gesture.strokes.append(stroke)

    def end(self, simulation: Simulation) -> None:
        """The gesture ends."""
        self.done[-1].after = simulation.state()

    def undo(self, simulation: Simulation) -> Simulation:
        """Undo the last gesture; returns the simulation to continue with."""
        if not self.done:
            return simulation
        gesture = self.done.pop()
        self.undone.append(gesture)
        return _brought(simulation, gesture.after, gesture.before, gesture.inverse)

    def redo(self, simulation: Simulation) -> Simulation:
        """Repeat the gesture that was undone last; returns the simulation to continue with."""
        if not self.undone:
            return simulation
        gesture = self.undone.pop()
        self.done.append(gesture)
        return _brought(simulation, gesture.before, gesture.after, gesture.strokes)

    def stepped(self) -> None:
        """Steps were done: the states before the gestures can no longer be put back exactly."""
        for gesture in (*self.done, *self.undone):
            gesture.before = gesture.after = None


def strokes_in(request: Request) -> list[AnyStroke]:
    """The strokes that a request asks for: one at each of its ``places``, or one at its own place.

    Raises BarchanError for what is no stroke.
    """
    if "stroke" not in request:
        return []
    places = request.get("places")
    at = [{}] if places is None else [{"x": x, "y": y} for x, y in places]
    return [_stroke({**request["stroke"], **place}) for place in at]


def _stroke(data: Any) -> AnyStroke:
    """A stroke of any brush from its data."""
    event = event_from({"kind": "stroke", **data})
    if not isinstance(event, BrushStroke):
        raise BarchanError(f"'{event.kind}' is no stroke")
    return event


def _trail(gesture: Gesture, stroke: AnyStroke) -> list[Stamp]:
    """The latest stamps of a gesture that reach into the patch of another one and are like it."""
    asked = stroke.model_dump(exclude=_PLACE)
    alike = [other for other in gesture.strokes if other.model_dump(exclude=_PLACE) == asked]
    near = [
        Stamp(x=other.x, y=other.y)
        for other in alike
        if math.hypot(other.x - stroke.x, other.y - stroke.y) < 2.0 * stroke.radius
    ]
    return near[-MOST_TRAIL:]


def _brought(
    simulation: Simulation, here: State | None, there: State | None, strokes: list[AnyStroke]
) -> Simulation:
    """The simulation brought from one state to another, exactly if it is still in the first one."""
    if here is not None and there is not None and here.data["events"] == _journal(simulation):
        return Simulation.from_state(there)
    for stroke in strokes:
        simulation.apply(stroke)
    return simulation


def _journal(simulation: Simulation) -> list[dict[str, object]]:
    return [record.data() for record in simulation.events]


def _inverse(simulation: Simulation, stroke: AnyStroke) -> AnyStroke:
    """The stroke that reverses the amount which this one will add or take."""
    given = float(np.abs(stroke.change(simulation.bed, simulation.model)).sum())
    asked = float(np.abs(stroke.requested(simulation.lattice)).sum())
    amount = -stroke.amount * (given / asked if asked else 0.0)
    return stroke.model_copy(update={"amount": round(amount) if isinstance(stroke.amount, int) else amount})
