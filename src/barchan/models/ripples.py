"""Ripples: grains in a wind that they slow themselves, that shelter behind crests, and that splash."""

from typing import ClassVar, Literal

from barchan.grains.canopy import Canopy
from barchan.grains.closure import composed
from barchan.grains.creep import Creep
from barchan.grains.entrainment import Entrainment
from barchan.grains.model import GrainModel
from barchan.grains.parameters import GrainFlight
from barchan.grains.relief_flow import ReliefFlow
from barchan.grains.shelter import Shelter
from barchan.grains.sized_sand import COARSE_CRESTS, SURFACE_DIAMETER
from barchan.grains.sizes import Sizes
from barchan.grains.splash import Splash
from barchan.grains.wind_feedback import Feedback
from barchan.parameters import parameter, redeclared


class RipplesParameters(GrainFlight):
    """Parameters of the ripple model."""

    kind_key: ClassVar[str] = "name"

    name: Literal["ripples"] = parameter("ripples", unit="-", meaning="The ripple model.")
    drag: Literal["constant", "reynolds"] = redeclared(GrainFlight, "drag", "reynolds", "Cheng 1997")
    footprint: Literal["stack", "patch"] = redeclared(
        GrainFlight, "footprint", "patch", "ours: whole parcels roughen the bed until ripples turn back"
    )
    repose_angle: float = redeclared(
        GrainFlight, "repose_angle", 34.0, "Szabó 2019, §3.4: loose sand 34 to 35"
    )
    time_step: float = redeclared(GrainFlight, "time_step", 5e-4, "ours: for cells of 5 mm")
    max_grains_per_cell: float = redeclared(
        GrainFlight, "max_grains_per_cell", 4.0, "ours: more than the wind carries"
    )


class LeeShelter(Shelter):
    """Calm air behind crests, at the angle of shadow zones."""

    angle: float | None = redeclared(
        Shelter, "angle", 15.0, "Werner 1995; Prague thesis, §3.2: the shadow zone"
    )


class SparseEntrainment(Entrainment):
    """Grains that the wind itself lifts, few beside the splash."""

    probability: float = redeclared(
        Entrainment, "probability", 1e-3, "ours: enough to start, little beside the splash"
    )


class Ripples(GrainModel):
    """Sand ripples by splash: impacts throw grains out, which hop a little downwind.

    Grains fly as in ``wang_hu``, with drag that depends on the Reynolds number. Its closures:

    * near the bed, below the focus, the wind is slowed by the momentum that grains take from it;
    * over waves the air rises and falls along the streamlines of ``streamline_height``; with
      ``speedup`` it is faster over crests too, and turns across oblique ones;
    * its stress on the bed is higher on crests and on faces that look upwind, by factors that follow from the
      wavelength over the roughness length (Fourrière et al. 2010);
    * behind crests the wind blows above a line that falls at the shelter's ``angle``;
    * a grain that hits the bed rebounds with a probability that grows with its speed, or stays;
    * it throws others out, the more and the faster the faster it was;
    * the rest of its momentum pushes grains along the bed, until friction and slope stop them; the wind
      helps, and where its stress is that of the impact threshold it keeps them going.

    So the number of grains in the air finds its own balance, where each impact replaces one. The wind itself
    lifts hardly a grain, enough to start. Sand moves where grains fall, on the faces that look upwind, and
    makes short ways downwind from there: the instability of Anderson (1987). Crests that reach into wind
    beyond the impact threshold lose the sand that comes: there ripples saturate.

    Sand of several ``sizes`` keeps in each cell the parcels of each size in an active layer (Hirano 1971) and
    in the substrate below it. An impact of size i at speed v throws out (a v / √(g D)) (d_i / d_s) f_s grains
    of size s, D being the mean diameter and f_s the share of s in the layer (Kok & Renno 2009), hence (d_s /
    d_i)² times their share in parcels, for a parcel holds the fewer grains the coarser they are. Their speed
    is that of ejecta in sand of one size, times (d_i / d_s)² where they are coarser: no size takes more than
    its share of the momentum. Sizes whose impact threshold is above the wind's friction velocity are not
    thrown out, they only creep.

    Known deviations: a simulated grain stands for many, which rebound and are thrown out together, so it
    roughens the bed the more the thicker its sand is; the wind over waves is that of one height for all
    heights; ``max_grains_per_cell`` bounds the number in the air; grains do not collide in the air; rebounds
    do not depend on size.
    """

    name = "ripples"
    title = "Ripples with splash"
    citation = (
        "After Anderson, R. S. (1987), Sedimentology 34, 943-956; Anderson, R. S. and Haff, P. K. (1991), "
        "Acta Mechanica Suppl. 1, 21-51; Kok, J. F. and Renno, N. O. (2009), J. Geophys. Res. 114, D17204."
    )
    closures = (SparseEntrainment, Splash, Creep, Feedback, ReliefFlow, LeeShelter, Sizes, Canopy)
    Parameters = composed(RipplesParameters, closures)
    derived = (*GrainModel.derived, SURFACE_DIAMETER)
    measures = (COARSE_CRESTS,)
