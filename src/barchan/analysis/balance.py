"""The balance of what the wind can move on a field, in whole units: what was, came, went and is."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from barchan.scenario import Scenario
from barchan.simulation import Simulation

if TYPE_CHECKING:
    import xarray as xr


@dataclass(frozen=True)
class Balance:
    """Whole units of all layers of a field, slabs or quanta, up to a moment."""

    unit: str
    mass: float | None
    """Mass of a unit (kg/m²), of layers that count masses."""
    start: int
    """On the bed and in the air at the start."""
    fallen: int
    """Fallen as snow."""
    entered: int
    """Come in across open edges, or laid by a brush."""
    left: int
    """Gone across open edges, or taken by a brush."""
    airborne: int
    held: int
    """On the bed."""

    @property
    def missing(self) -> int:
        """Units that are not accounted for: 0, always."""
        return self.start + self.fallen + self.entered - self.left - self.airborne - self.held

    def rows(self) -> dict[str, int]:
        """Each part of the balance by the name that people read."""
        return {
            "at the start": self.start,
            "fallen": self.fallen,
            "entered": self.entered,
            "left": self.left,
            "in the air": self.airborne,
            "held": self.held,
        }

    def text(self) -> str:
        """The balance in a line."""
        parts = [f"{self.held} {self.unit} held"]
        if self.airborne:
            parts.append(f"{self.airborne} in the air")
        came = f"{self.start} at the start + {self.fallen} fallen + {self.entered} entered - {self.left} left"
        closes = "" if self.missing == 0 else f"; {self.missing} are not accounted for"
        return f"{' + '.join(parts)} = {came}{closes}"


def balance_now(simulation: Simulation) -> Balance:
    """The balance of a simulation as it is."""
    ledger, fallen = simulation.ledger, simulation.tally.fallen
    layer = simulation.bed.layers[-1]
    return Balance(
        layer.unit,
        layer.mass,
        ledger.initial,
        fallen,
        ledger.entered - fallen,
        ledger.left,
        ledger.airborne,
        simulation.bed.units,
    )


def balance_of(run: "xr.Dataset", scenario: Scenario) -> Balance:
    """The balance at the last frame of a run, counted from its first frame and the counters of both.

    Runs of earlier versions do not tell fallen from entered; all of it counts as entered.
    """
    layers = scenario.layers
    first, last = (_counts(run.isel(step=at), [layer.name for layer in layers]) for at in (0, -1))
    return Balance(
        layers[-1].unit,
        layers[-1].mass,
        first["held"] + first["airborne"] - first["entered"] + first["left"],
        last["fallen"],
        last["entered"] - last["fallen"],
        last["left"],
        last["airborne"],
        last["held"],
    )


def _counts(frame: "xr.Dataset", layers: list[str]) -> dict[str, Any]:
    counters = ("entered", "fallen", "left", "airborne")
    known = {name: int(frame[name]) if name in frame else 0 for name in counters}
    return {**known, "held": sum(int(frame[name].values.sum(dtype="int64")) for name in layers)}
