"""Werner's model: slabs of sand that the wind takes, carries and drops."""

from typing import Literal

from barchan.parameters import parameter, redeclared
from barchan.slabs.model import SlabModel
from barchan.slabs.parameters import SlabParameters


class WernerParameters(SlabParameters):
    """Parameters of Werner's model: slab transport with the defaults of 1995."""

    name: Literal["werner"] = parameter("werner", unit="-", meaning="Werner's model.")
    lee_erosion: bool = redeclared(SlabParameters, "lee_erosion", True, "Werner 1995")
    repose_angle: float = redeclared(SlabParameters, "repose_angle", 30.0, "Werner 1995")
    repose_test: Literal["before", "after"] = redeclared(
        SlabParameters, "repose_test", "before", "Prague thesis, Alg. 4 and 5"
    )


class Werner(SlabModel):
    """Dunes from slabs that hop: the first and simplest model of a dune field.

    Each step polls as many cells as the field has. A polled cell that holds sand gives its topmost slab to
    the wind, which carries it ``hop_length`` cells at a time. Where it lands it settles

    * always, in the shadow zone: where a line falling at ``shadow_angle`` from anything upwind passes
      above the surface;
    * with probability ``p_s`` on sand and ``p_ns`` on bare ground;

    otherwise it hops on. Where taking or laying down the slab makes a slope steeper than the angle of
    repose, sand slides down the steepest way, slab by slab, until all slopes hold.

    Known deviations: the paper's neighbourhood and the order of equally steep neighbours are not stated;
    both are parameters. Whole slabs hold only some angles: with slabs of 1/3 cell, 30 degrees becomes
    33.7 (``repose_test`` "before") or 18.4 ("after").
    """

    name = "werner"
    title = "Werner 1995"
    citation = (
        "Werner, B. T. (1995). Eolian dunes: computer simulations and attractor interpretation. "
        "Geology 23(12), 1107-1110."
    )
    Parameters = WernerParameters
