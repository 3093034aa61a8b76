"""Wang & Hu's model: grains that fly, bounce and build ripples."""

from typing import ClassVar, Literal

from barchan.grains.bounce import Bounce
from barchan.grains.canopy import Canopy
from barchan.grains.closure import composed
from barchan.grains.entrainment import Entrainment
from barchan.grains.model import GrainModel
from barchan.grains.parameters import GrainFlight
from barchan.grains.shelter import Shelter
from barchan.parameters import parameter


class WangHuParameters(GrainFlight):
    """Parameters of Wang & Hu's model."""

    kind_key: ClassVar[str] = "name"

    name: Literal["wang_hu"] = parameter("wang_hu", unit="-", meaning="Wang & Hu's model.")


class WangHu(GrainModel):
    """Grains that the wind lifts anywhere and that bounce until they are slow.

    In each iteration every grain in the air flies for ``time_step``: gravity and drag change its velocity
    in a wind that follows the law of the wall over the surface below it. A grain below the surface

    * bounces: the part of its velocity across the surface is turned round and damped, and so is the part
      along it;
    * or stays, where it would be slower than ``stop_speed`` then, and raises the bed by a parcel.

    Slots without a grain draw a random cell. Where it holds sand and does not face downwind, a parcel is
    lifted with an upward speed of B times the friction velocity and a random, uniformly distributed angle,
    along the wind. Below the threshold none is. Every few iterations slopes above the angle of repose slide.

    With ``clock`` "step" grains fly one after the other from lift-off to rest, as in the Prague thesis.

    A parcel is one unit of the bed: a grain diameter high over a whole cell. Known deviations: Wang & Hu's
    papers were read in the words of Szabó 2019 and the Prague thesis only; both damping factors, the stopping
    speed, the time step and the filter's factors stand in neither.
    """

    name = "wang_hu"
    title = "Wang & Hu 2012"
    citation = (
        "Wang, N. and Hu, B.-G. (2012). Real-time simulation of aeolian sand movement and sand ripple "
        "evolution: a method based on the physics of blown sand. Journal of Computer Science and "
        "Technology 27(1), 135-146; after Szabó 2019 and the Prague thesis."
    )
    closures = (Entrainment, Bounce, Shelter, Canopy)
    Parameters = composed(WangHuParameters, closures)
