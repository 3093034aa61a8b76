"""The rules of the snow kernel under one wind and weather."""

import math

import numpy as np
from numpy.typing import NDArray

from barchan.fields import HEIGHT_UNIT
from barchan.kernels.slabs.state import SlabRules
from barchan.kernels.snow.state import DENSITY_UNIT, UPWIND, Giving, SnowRules
from barchan.snow.conditions import Conditions, layer_tables
from barchan.snow.drift_meter import DRIFTING


def rules_under(
    now: Conditions,
    drift: float,
    cell_size: float,
    slabs: SlabRules,
    epoch: int,
    stress: NDArray[np.float32] | None,
) -> SnowRules:
    """The rules under these conditions, with ``drift`` over saturation in the air.

    ``stress``: shear stress on each cell over that on the flat; None: uniform.
    """
    parameters = now.parameters
    tables = layer_tables(now, drift > DRIFTING, drift, cell_size)
    always = stress is None and not parameters.bonding.grows and parameters.erosion_chance == 1.0
    exposure = max(round(parameters.abrasion.height / HEIGHT_UNIT), 1)
    along, across = slabs.wind.unit_along, slabs.wind.unit_across
    corner = UPWIND + (1 if across > 0.0 else -1)
    oblique = round(abs(across) / along * 2**32)
    giving = Giving(
        parameters.abrasion.rate > 0.0 and drift > 0.0,
        exposure,
        corner,
        now.spread,
        parameters.drift.stress_power,
        oblique,
    )
    return SnowRules(
        slabs=slabs,
        tables=tables,
        giving=None if always else giving,
        stress=stress,
        impact_threshold=min(now.impact_threshold / max(now.stress, 1e-12), 0.999),
        creep=now.creep(cell_size),
        epoch=epoch,
        density=round(now.drift_density * DENSITY_UNIT),
        gentlest=int(tables.face_limit.min()),
        corner_factor=math.sqrt(2.0) if parameters.neighbourhood == "moore" else 0.0,
    )
