"""The friction velocity of the wind along the bed, as a field to look at."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.flow_over_relief import ReliefWind
from barchan.bed import Bed
from barchan.grains.bed import GrainGround
from barchan.grains.canopy import PLANT_HEIGHT
from barchan.grains.creep import calm_depth
from barchan.grains.relief_flow import ReliefFlow
from barchan.model import Derived
from barchan.wind.segment import Segment


def friction_velocity(model: Any, bed: Bed, wind: Segment) -> NDArray[np.float64]:
    """Friction velocity (m/s) of the wind of a model of grains on each cell, before grains slow it.

    Over waves it is that of the flat bed times the root of their relative shear stress, where the model's
    wind follows the relief; 0 in the calm behind crests and where plants keep the wind off the bed.
    """
    setting, relief, canopy = model.setting(wind), model.parameters.part(ReliefFlow), model.plants
    plants = None
    if canopy is not None:
        plants = canopy.roughness_of(bed.arrays[PLANT_HEIGHT.name], bed.lattice, model.parameters)
    ground = GrainGround(model.parameters, bed, wind.direction, plants=plants)
    ground.raise_shelter()
    over = ReliefWind() if relief is None else relief.over(bed.elevation, setting)
    ground.drag(np.asarray(setting.ustar), over)
    arrays = ground.arrays
    assert arrays.bed_stress is not None
    calm = arrays.shelter_surface > arrays.height + calm_depth(model.parameters, bed.lattice)
    return np.where(calm, 0.0, arrays.bed_stress.ustar).reshape(bed.lattice.shape)


FRICTION_VELOCITY = Derived(
    "friction_velocity",
    "m/s",
    "friction velocity of the wind along the bed before grains slow it",
    friction_velocity,
    centred=True,
    sheltered=True,
    along_wind=True,
    least=0.0,
)
