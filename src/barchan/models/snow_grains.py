"""Snow grains: snow that the wind drives over its own deposits, which bond while they lie."""

from typing import ClassVar, Literal, TypeVar

from barchan.grains.bounce import Bounce
from barchan.grains.canopy import Canopy
from barchan.grains.closure import Closure, composed
from barchan.grains.creep import Creep
from barchan.grains.parameters import GrainFlight
from barchan.grains.relief_flow import ReliefFlow
from barchan.grains.sintering import Sintering
from barchan.grains.snow_model import SnowGrainModel
from barchan.grains.splash import Splash
from barchan.grains.wind_feedback import Feedback
from barchan.models.ripples import LeeShelter, RipplesParameters, SparseEntrainment
from barchan.parameters import parameter, redeclared

Part = TypeVar("Part", bound=Closure)


class SnowGrainsParameters(RipplesParameters):
    """Parameters of snow grains."""

    kind_key: ClassVar[str] = "name"

    name: Literal["snow_grains"] = parameter(  # type: ignore[assignment]
        "snow_grains", unit="-", meaning="Grains of snow in flight whose deposits bond."
    )
    grain_diameter: float = redeclared(
        GrainFlight, "grain_diameter", 0.2e-3, "Pomeroy & Gray 1990: drifting grains of 0.1 to 0.2 mm radius"
    )
    grain_density: float = redeclared(
        GrainFlight, "grain_density", 917.0, "ice: Filhol & Sturm 2015, in Szabó 2019, §4.2"
    )
    porosity: float = redeclared(GrainFlight, "porosity", 0.62, "ours: wind-blown snow of 350 kg/m³")
    air_density: float = redeclared(GrainFlight, "air_density", 1.30, "ours: air of -10 °C at 980 hPa")
    threshold_velocity: float | None = redeclared(
        GrainFlight, "threshold_velocity", 0.21, "Clifton et al. 2006: Bagnold's law with A = 0.18"
    )
    repose_angle: float = redeclared(GrainFlight, "repose_angle", 38.0, "ours: drift; rescal-snow 35 to 38")
    impacts: Literal["splash", "bounce"] = parameter(
        "splash",
        unit="-",
        group="bed",
        meaning="What grains do that hit the bed: rebound, throw others out and push them, as in ripples; or "
        "only bounce until they are slow, as in wang_hu, in a wind that nothing slows.",
        source="splash: Anderson 1987; bounce: Wang & Hu 2012, the picture of Szabó 2019",
    )

    def part(self, kind: type[Part]) -> Part | None:
        """The closure of a kind; of impacts only those that take part."""
        idle = (Splash, Creep, Feedback, ReliefFlow) if self.impacts == "bounce" else (Bounce,)
        return None if issubclass(kind, idle) else super().part(kind)


class SnowGrains(SnowGrainModel):
    """Grains of snow in flight, whose deposits bond by a timer (Filhol & Sturm 2015).

    Grains fly, splash and creep as in ``ripples``, light as ice. The snow of a cell is bonded, or loose in
    one of four ages. What comes to rest, also after a slide, is loose and of the youngest age. Each quarter
    of the bonding time all loose snow is a step older, and the oldest has bonded: every parcel that rests
    bonds after 0.75 to 1 bonding time. That time is 24 hours at -10 °C and follows the temperature by
    Arrhenius' law, or is stated. What leaves is of the youngest age that there is, bonded last.

    Bonded snow is another surface:

    * slopes of it do not slide, however steep;
    * the wind itself lifts it above ``bonded_threshold`` only;
    * an impact throws out or pushes bonded parcels with the probability ``hardness`` of that for loose ones;
    * grains rebound off it faster, for they lose no momentum to others.

    Below all snow lies hard ground as in ``ripples``.

    Known deviations: bonds do not grow stronger once they are there, so that snow of a day and of a month is
    as hard; parcels are bonded or not, no lumps break off; grains in the air do not wear down; a parcel that
    sublimates, melts or falls from the sky is not known. With ``impacts`` bounce grains throw nothing out, so
    that only the wind moves bonded snow.
    """

    name = "snow_grains"
    title = "Snow grains that bond"
    citation = (
        "Our composition, after Szabó 2019, ch. 4 and 6, and the timer of Filhol, S. and Sturm, M. (2015), "
        "J. Geophys. Res. Earth Surf. 120, 1645-1669; grains as in ripples."
    )
    closures = (
        SparseEntrainment,
        Splash,
        Bounce,
        Creep,
        Feedback,
        ReliefFlow,
        LeeShelter,
        Canopy,
        Sintering,
    )
    Parameters = composed(SnowGrainsParameters, closures)
