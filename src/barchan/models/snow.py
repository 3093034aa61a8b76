"""Snow that drifts, bonds, packs and falls."""

from typing import Literal

from barchan.model import Curve
from barchan.parameters import parameter
from barchan.snow.curves import snow_curves
from barchan.snow.fields import DERIVED, STRATA
from barchan.snow.measures import MEASURES
from barchan.snow.model import SnowModel
from barchan.snow.parameters import SnowParameters


class SnowModelParameters(SnowParameters):
    """Parameters of the snow model."""

    name: Literal["snow"] = parameter("snow", unit="-", meaning="Snow that drifts, bonds, packs and falls.")


class Snow(SnowModel):
    """Snow as layers of unlike density and hardness, from which the wind takes quanta of mass.

    A cell holds a stack of layers; each keeps how many quanta it is of, its density, and when it came to
    rest. Bonds between its grains grow with time, faster when it is warm, so that the threshold stress is

        τ_t = τ_w + τ_b N(ρ) / N(100) t^n    (t in hours at -10 °C, n = 0.27).

    A polled cell outside the shadow zone gives a quantum with a chance in proportion to the excess of the
    shear stress over τ_t, much less where it is bonded. The quantum hops on where the stress is strong, rests
    where it is weak, may roll to a lower neighbour, and lies there as dense, loose drift. Fresh snow is
    light. Bonded snow is worn by drift where it stands out of the bed. All layers pack under their weight.

    Known deviations: there are no overhangs, no suspension, no sublimation, melt or radiation, and one
    temperature for all depths. The shear stress is that of linear theory, up to some 20 degrees; no vortices
    scour about obstacles.
    """

    name = "snow"
    title = "snow"
    citation = (
        "Our composition of published closures: Schmidt (1980), Li & Pomeroy (1997), Lehning et al. (2000), "
        "Sørensen (2004), Groot Zwaaftink et al. (2013), Fourrière et al. (2010)."
    )
    Parameters = SnowModelParameters
    derived = DERIVED
    strata = STRATA
    measures = MEASURES

    @classmethod
    def curves(cls, parameters: SnowModelParameters) -> list[Curve]:
        """The closures of snow."""
        return snow_curves(parameters)
