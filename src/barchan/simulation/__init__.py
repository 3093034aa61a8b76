"""The simulation: owns the bed, advances a model through the wind, takes events, emits frames."""

from barchan.simulation.core import Frame, Simulation
from barchan.simulation.events import (
    AnyEvent,
    Event,
    PlantStroke,
    Record,
    RockStroke,
    SetParameter,
    SetWind,
    Stroke,
    event_from,
    in_force,
)
from barchan.simulation.ledger import Ledger
from barchan.simulation.state import State
from barchan.simulation.stop import StopCondition
from barchan.simulation.strokes import AnyStroke, asked_by, change_by

__all__ = [
    "AnyEvent",
    "AnyStroke",
    "Event",
    "Frame",
    "Ledger",
    "PlantStroke",
    "Record",
    "RockStroke",
    "SetParameter",
    "SetWind",
    "Simulation",
    "State",
    "StopCondition",
    "Stroke",
    "asked_by",
    "change_by",
    "event_from",
    "in_force",
]
