"""The simulation: owns the bed, advances a model through the wind, takes events, emits frames."""

from barchan.simulation.core import Frame, Simulation, Watch
from barchan.simulation.events import Event, Record, SetParameter, SetWind, Stroke, event_from, in_force
from barchan.simulation.ledger import Ledger
from barchan.simulation.state import State

__all__ = [
    "Event",
    "Frame",
    "Ledger",
    "Record",
    "SetParameter",
    "SetWind",
    "Simulation",
    "State",
    "Stroke",
    "Watch",
    "event_from",
    "in_force",
]
