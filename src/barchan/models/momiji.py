"""Momiji's model: wind that speeds up with height, and no erosion in shadow."""

from typing import Literal

from barchan.parameters import parameter
from barchan.slabs.speedup import SpeedupModel, SpeedupParameters


class MomijiParameters(SpeedupParameters):
    """Parameters of Momiji's model."""

    name: Literal["momiji"] = parameter("momiji", unit="-", meaning="Momiji's model.")


class Momiji(SpeedupModel):
    """Werner's slabs under a wind that is faster up high.

    Cells in shadow do not erode. From a cell of height h (slabs) a slab hops

        L(h) = L0 + C1 (h - h_mean) + C2 (h - h_mean)²    above the mean height,
        L(h) = L0 + C1 (h - h_mean)                       below it,

    with L0 the ``hop_length``, C1 ``speedup_linear`` and C2 ``speedup_quadratic``. L0 / C1 slabs (12.5) below
    the mean the hop is zero; deeper cells send sand against the wind, as the eddy in a deep trough does.
    A hop is at most as long as the field.

    Known deviations: the paper's rules for fractions of cells, for hops of zero and after a bounce were
    not found; see ``hop_rounding`` and ``hop_from``. Over ground that is not flat h is the height of the
    surface.
    """

    name = "momiji"
    title = "Momiji et al. 2000"
    citation = (
        "Momiji, H., Carretero-González, R., Bishop, S. R. & Warren, A. (2000). Simulation of the effect of "
        "wind speedup in the formation of transverse dune fields. Earth Surface Processes and Landforms "
        "25(8), 905-918."
    )
    Parameters = MomijiParameters
