"""The simulation: owns the bed, advances a model through the wind, takes events, emits frames."""

from barchan.simulation.core import Simulation
from barchan.simulation.events import (
    AnyEvent,
    Event,
    Record,
    SetParameter,
    SetWind,
    event_from,
    in_force,
)
from barchan.simulation.frame import Frame
from barchan.simulation.ledger import Ledger
from barchan.simulation.state import LOOK_ONLY, State
from barchan.simulation.step_pacer import StepPacer
from barchan.simulation.stop import StopCondition
from barchan.simulation.strokes import (
    MOST_TRAIL,
    AnyStroke,
    BrushStroke,
    IceStroke,
    PlantStroke,
    RockStroke,
    SnowfallStroke,
    Stamp,
    Stroke,
)

__all__ = [
    "LOOK_ONLY",
    "MOST_TRAIL",
    "AnyEvent",
    "AnyStroke",
    "BrushStroke",
    "Event",
    "Frame",
    "IceStroke",
    "Ledger",
    "PlantStroke",
    "Record",
    "RockStroke",
    "SetParameter",
    "SetWind",
    "Simulation",
    "SnowfallStroke",
    "Stamp",
    "State",
    "StepPacer",
    "StopCondition",
    "Stroke",
    "event_from",
    "in_force",
]
