"""Bishop's model: Momiji's, with heights measured from a reference that follows the relief."""

from typing import Literal

from barchan.parameters import parameter
from barchan.slabs.speedup import SpeedupModel, SpeedupParameters


class BishopParameters(SpeedupParameters):
    """Parameters of Bishop's model."""

    name: Literal["bishop"] = parameter("bishop", unit="-", meaning="Bishop's model.")


class Bishop(SpeedupModel):
    """Momiji's model with a reference height that sinks as the dunes grow.

    Hops grow with height as in Momiji's model, but from the reference

        h_ref(t) = h_mean - ½ mean abs(h - h_mean)

    which follows every slab that moves and is computed again from the whole bed at the start of each step.

    Known deviations: the wind blows from any direction, where the paper turns the field of sand about a
    pivot and loses slabs; for the rest see Momiji's model. The paper's neighbourhood is Moore's as Elder 2009
    reads it and von Neumann's as the Prague thesis ran it; it is a parameter.
    """

    name = "bishop"
    title = "Bishop et al. 2002"
    citation = (
        "Bishop, S. R., Momiji, H., Carretero-González, R. & Warren, A. (2002). Modelling desert dune fields "
        "based on discrete dynamics. Discrete Dynamics in Nature and Society 7(1), 7-17."
    )
    Parameters = BishopParameters
    follows_relief = True
