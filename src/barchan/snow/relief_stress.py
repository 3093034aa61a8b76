"""The shear stress of the wind over a field of snow: computed anew when it is due or the wind turns."""

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.bed_stress import bed_stress
from barchan.bed import Bed
from barchan.fields import HEIGHT_UNIT
from barchan.lattice import Lattice
from barchan.snow.pack import STRESS, Field
from barchan.snow.parameters import SnowParameters


def stress_on(
    height: NDArray[np.float64], lattice: Lattice, direction: float, parameters: SnowParameters
) -> NDArray[np.float64]:
    """Shear stress on a surface (m) over that on flat snow, for a wind from ``direction`` (degrees)."""
    relief = parameters.relief
    if not relief.acts:
        return np.ones(height.shape)
    return bed_stress(
        height,
        lattice,
        direction,
        roughness=parameters.drift.roughness,
        saturation_angle=relief.saturation_angle,
        smoothing=relief.smoothing,
    )


class ReliefStress:
    """The wind direction for which the stress that a bed keeps was computed; none once it is due again."""

    def __init__(self) -> None:
        """No stress has been computed yet."""
        self._direction: float | None = None

    def expire(self) -> None:
        """Have the stress computed again before it is used."""
        self._direction = None

    def renew(self, bed: Bed, field: Field, direction: float, parameters: SnowParameters) -> None:
        """Compute the stress on the bed of a field, unless that of this direction (degrees) still holds."""
        if self._direction == direction:
            return
        shape = field.frame.enter(bed.ground).shape
        height = field.frame.leave(field.pack.surface.reshape(shape)) * HEIGHT_UNIT
        bed.arrays[STRESS][...] = stress_on(height, bed.lattice, direction, parameters)
        self._direction = direction

    def state(self) -> dict[str, float]:
        """What to remember."""
        return {"stress_of": -1.0 if self._direction is None else self._direction}

    def restore(self, state: dict[str, float]) -> None:
        """Take up what was remembered."""
        direction = float(state["stress_of"])
        self._direction = None if direction < 0.0 else direction
