"""Sintering: bonds that grow between grains of snow at rest."""

from typing import TYPE_CHECKING, ClassVar

from pydantic_core import InitErrorDetails

from barchan.aeolian.snow.bonding import REFERENCE_TEMPERATURE, activation_energy_parameter, bonding_rate
from barchan.grains.closure import Closure
from barchan.kernels.bed.state import AGES
from barchan.parameters import mistake, parameter

if TYPE_CHECKING:
    from barchan.grains.parameters import GrainFlight

DAY = 86_400.0
"""Time (s) in which snow at rest bonds at -10 °C (Filhol & Sturm 2015)."""


class Sintering(Closure):
    """Bonds that grow between grains at rest."""

    key: ClassVar[str] = "sintering"

    grows: bool = parameter(
        True,
        unit="-",
        meaning="Whether bonds grow; without, all snow stays loose.",
        source="Filhol & Sturm 2015",
    )
    bonding_time: float | None = parameter(
        None,
        unit="s",
        ge=0.01,
        le=1e8,
        scale="log",
        live=True,
        meaning="Time in which snow at rest bonds, at any temperature; by temperature, 24 hours at -10 °C, "
        "where not given.",
        source="Filhol & Sturm 2015: rarely more than 24 hours",
    )
    temperature: float = parameter(
        REFERENCE_TEMPERATURE,
        unit="°C",
        ge=-90,
        le=5,
        live=True,
        meaning="Temperature of the snow where the wind states none.",
        source="ours",
    )
    activation_energy: float = activation_energy_parameter()
    start_bonded: bool = parameter(
        False,
        unit="-",
        meaning="Whether the snow that lies at the start has bonded; else its timer starts with the run.",
        source="ours",
    )
    bonded_threshold: float = parameter(
        2.0,
        unit="-",
        ge=1,
        le=100,
        live=True,
        meaning="Friction velocity at which the wind itself lifts bonded grains, over that of loose ones.",
        source="ours",
    )
    hardness: float = parameter(
        0.05,
        unit="-",
        ge=0,
        le=1,
        live=True,
        meaning="Parcels that an impact sets in motion on bonded snow, over those on loose snow.",
        source="ours: the rate at which rescal-snow erodes sintered snow, over that of loose snow",
    )
    restitution: float = parameter(
        0.7,
        unit="-",
        ge=0,
        le=1,
        live=True,
        meaning="Speed after a rebound off bonded snow over the speed of impact.",
        source="ours: of loose snow 0.55, and the momentum that its ejecta take, 0.15",
    )

    def mistakes(self, rules: "GrainFlight") -> list[InitErrorDetails]:
        """A clock without time, beside which nothing can bond."""
        if self.grows and rules.clock == "step":
            text = (
                "steps of complete trajectories (clock 'step') have no duration, so no bonds grow; allowed: "
            )
            return [mistake((), text + "clock 'iteration', or grows false")]
        return []

    def rate(self, temperature: float | None = None) -> float:
        """Speed of bonding at a temperature (°C; None: the parameter), over that of ``full_time``."""
        if self.bonding_time is not None:
            return 1.0
        degrees = self.temperature if temperature is None else temperature
        return float(bonding_rate(degrees, self.activation_energy))

    @property
    def full_time(self) -> float:
        """Time (s) in which snow at rest bonds at a rate of 1."""
        return DAY if self.bonding_time is None else self.bonding_time

    def remarks(self, step_seconds: float) -> list[str]:
        """A bonding time that steps of some duration (s) cannot resolve."""
        time = self.full_time / self.rate()
        if not self.grows or time / AGES > step_seconds:
            return []
        locks = "snow locks at once" if time <= step_seconds else "ages cannot be told apart"
        least = AGES * step_seconds
        text = f"{time:g} s (sintering.bonding_time) beside steps of {step_seconds:g} s: {locks}"
        return [f"snow bonds in {text}; from {least:g} s on each age lasts a step"]
