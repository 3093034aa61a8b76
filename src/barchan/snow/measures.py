"""Measures of snow: how much of it moves and is bonded, which way its forms lean, how rough they are.

Those of forms need scipy and are imported where they are taken: a list of models goes without.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Bed
from barchan.model import ModelMeasure
from barchan.snow.conditions import Conditions
from barchan.snow.fields import surface_age, threshold_wind
from barchan.wind.segment import Segment


def _surface(bed: Bed) -> NDArray[np.float64]:
    from barchan.measures.bedform_surface import bedform_surface

    lattice = bed.lattice
    return bedform_surface(bed.ground, bed.depth, lattice.cell_size, lattice.periodic)


def _share_of_snow(bed: Bed, holds: NDArray[np.bool_]) -> float:
    covered = bed.stack > 0
    return float(holds[covered].mean()) if covered.any() else float("nan")


def mobile_share(bed: Bed, now: Conditions) -> float:
    """Share of the cells with snow that the wind could take on the flat; NaN without snow."""
    return _share_of_snow(bed, threshold_wind(bed, now) < now.wind)


def bonded_share(bed: Bed, loose_hours: float) -> float:
    """Share of the cells with snow whose uppermost layer has bonded; NaN without snow."""
    return _share_of_snow(bed, surface_age(bed) >= loose_hours)


def _mobile(model: Any, bed: Bed, wind: Segment) -> float:
    return mobile_share(bed, model.conditions(wind))


def _bonded(model: Any, bed: Bed, _wind: Segment) -> float:
    bonding = model.parameters.bonding
    return bonded_share(bed, bonding.loose_hours) if bonding.grows else 0.0


def _relief(_model: Any, bed: Bed, _wind: Segment) -> float:
    from barchan.measures.snow_forms import central_relief

    return central_relief(_surface(bed))


def _skewness(_model: Any, bed: Bed, wind: Segment) -> float:
    from barchan.measures.snow_forms import slope_skewness

    return slope_skewness(_surface(bed), bed.lattice.cell_size, wind.direction, bed.lattice.periodic)


def _roughness(_model: Any, bed: Bed, wind: Segment) -> float:
    from barchan.measures.snow_forms import roughness_length

    return roughness_length(_surface(bed), bed.lattice.cell_size, wind.direction, bed.lattice.periodic)


MEASURES = (
    ModelMeasure("mobile_share", "snow that the wind can take", "fraction", _mobile),
    ModelMeasure("bonded_share", "bonded surface", "fraction", _bonded),
    ModelMeasure("relief", "relief, 1st to 99th percentile", "m", _relief),
    ModelMeasure("slope_skewness", "skewness of slopes along the wind", "-", _skewness),
    ModelMeasure("roughness_length", "roughness length of the forms", "m", _roughness),
)
"""Measures that tables show for snow beside those of every bed."""
