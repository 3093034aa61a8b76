"""Flow over relief: the wind over waves of the bed, by linear theory."""

from typing import ClassVar

from numpy.typing import NDArray

from barchan.aeolian.flow_over_relief import ReliefWind, wind_over_relief
from barchan.grains.closure import Closure, Setting
from barchan.parameters import parameter


class ReliefFlow(Closure):
    """The wind over waves of the bed."""

    key: ClassVar[str] = "relief_flow"

    streamline_height: float | None = parameter(
        0.01,
        unit="m",
        gt=0,
        le=10,
        meaning="Height of the streamlines that the air follows over waves, up, down and, with speedup, "
        "faster and slower; the wind blows level and uniformly where not given.",
        source="frictionless flow over waves (Lamb 1932); the height, that of the focus, is ours",
    )
    speedup: float = parameter(
        0.0,
        unit="-",
        ge=0,
        le=10,
        live=True,
        meaning="Factor on the speed that frictionless flow gains over crests, loses over troughs, and has "
        "to the side across oblique crests; 0: the wind is equally fast everywhere.",
        source="0: ours, for low ripples hardly form otherwise; 1: the same flow as the streamlines (Lamb "
        "1932); 2: near the bed of a turbulent one, whose shear stress is about 4 k h higher on waves of "
        "height h and wave number k (Fourrière et al. 2010)",
    )
    stress_in_phase: float | None = parameter(
        None,
        unit="-",
        ge=0,
        le=20,
        live=True,
        meaning="Excess of the wind's stress on the bed on crests of waves, and deficit in troughs, over "
        "their height times wave number (A); it helps pushed grains along. null: by the wavelength over the "
        "roughness length, some 4.4 for ripples; 0: the stress is the same there.",
        source="Fourrière et al. 2010",
    )
    stress_in_quadrature: float | None = parameter(
        None,
        unit="-",
        ge=0,
        le=20,
        live=True,
        meaning="Excess of that stress on faces that look upwind, over their slope (B); with it the stress "
        "is highest ahead of crests. null: by wavelength over roughness length, some 2.3 for ripples.",
        source="Fourrière et al. 2010",
    )

    def over(self, surface: NDArray, setting: Setting) -> ReliefWind:
        """The wind over the waves of a ``surface`` (m)."""
        stress = self.stress_in_phase, self.stress_in_quadrature
        lattice, direction = setting.lattice, setting.direction
        height, roughness = self.streamline_height, setting.rules.roughness_length
        return wind_over_relief(surface, lattice, direction, height, self.speedup, stress, roughness)
