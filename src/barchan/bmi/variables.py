"""The quantities that the Basic Model Interface exchanges, by their CSDMS standard names."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.errors import BarchanError
from barchan.simulation import Simulation
from barchan.simulation.events import SetWind

FIELD, SCALAR = 0, 1
"""Identifiers of the grids: the lattice, and a grid of rank 0."""

ELEVATION = "land_surface__elevation"
BEDROCK = "bedrock_surface__elevation"
THICKNESS = "land_surface_sediment_layer__thickness"
SPEED = "land_surface_wind__speed"
AZIMUTH = "land_surface_wind__azimuth_angle_of_from_direction"


@dataclass(frozen=True)
class Variable:
    """A quantity that is exchanged, by its CSDMS standard name."""

    units: str
    grid: int
    get: Callable[[Simulation], Any]
    set: Callable[[Simulation, NDArray[np.float64]], None] | None = None


def _set_thickness(simulation: Simulation, values: NDArray[np.float64]) -> None:
    bed, ledger = simulation.bed, simulation.ledger
    if any(layer.mass is not None for layer in bed.layers) or len(bed.layers) > 1:
        raise BarchanError(
            f"{THICKNESS} cannot be set with {simulation.model.title}: layers are more than slabs"
        )
    if (values < 0).any():
        raise BarchanError(f"{THICKNESS}: {values.min():g} m; allowed: 0 and more")
    slabs = np.rint(values.reshape(bed.top.shape) / bed.lattice.thickness)
    change = slabs.astype(np.int64) - bed.top
    bed.lay(change)
    ledger.entered += int(change[change > 0].sum())
    ledger.left -= int(change[change < 0].sum())
    simulation.model.relax(bed, change != 0)
    ledger.check(bed)


def _set_wind(key: str) -> Callable[[Simulation, NDArray[np.float64]], None]:
    """Sets a value of a steady wind from now on."""

    def change(simulation: Simulation, values: NDArray[np.float64]) -> None:
        wind = {**simulation.wind.model_dump(mode="json"), key: float(values[0])}
        simulation.apply(SetWind.model_validate({"wind": wind}))

    return change


VARIABLES = {
    ELEVATION: Variable("m", FIELD, lambda s: s.elevation),
    BEDROCK: Variable("m", FIELD, lambda s: s.bed.ground),
    THICKNESS: Variable("m", FIELD, lambda s: s.bed.depth, _set_thickness),
    SPEED: Variable("m s-1", SCALAR, lambda s: s.last_segment.speed, _set_wind("speed")),
    AZIMUTH: Variable("degrees", SCALAR, lambda s: s.wind_direction, _set_wind("direction")),
}
