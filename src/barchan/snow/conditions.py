"""Snow under one wind and weather: stresses, thresholds, and the tables that kernels read."""

import math
from dataclasses import dataclass
from functools import cached_property, lru_cache, partial

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.snow.bonding import LOOSEST_BONDS, bonding_rate, threshold_stress
from barchan.aeolian.snow.drift import IMPACT_STRESS
from barchan.aeolian.snow.thresholds import (
    BY_DENSITY,
    li_pomeroy_median,
    li_pomeroy_spread,
    normal_share,
)
from barchan.fields import HEIGHT_UNIT
from barchan.kernels.snow.state import (
    AGE_CLASSES,
    DENSITY_CLASSES,
    Creep,
    LayerTables,
    age_classes,
    density_of,
    quanta_of,
)
from barchan.snow.parameters import SnowParameters

EPOCH_SECONDS = 600.0
"""Duration (s at -10 °C) of an epoch of bonding."""

_KEPT = 4096
"""Winds whose fluxes are kept."""
_HOUR = 3600.0
_ABRADED = 0.09
"""Threshold stress (Pa) of the snow that the rate of abrasion is stated for."""
_NEVER = np.int32(2**30)
"""A step (µm) that no snow reaches."""
_SURE = 1e9
"""Chance for each unit of excess that gives whatever the excess is."""
_ANY_DENSITY = 1024


@dataclass(frozen=True)
class Conditions:
    """A wind (m/s at 10 m) and a temperature (°C), and what follows from them."""

    parameters: SnowParameters
    wind: float
    temperature: float

    @cached_property
    def stress(self) -> float:
        """Shear stress (Pa) on flat snow."""
        return self.parameters.air_density * self.parameters.drift.friction_velocity(self.wind) ** 2

    @cached_property
    def drift_density(self) -> float:
        """Density (kg/m³) of what the wind lays down."""
        return self.parameters.drift.laid_density(self.wind)

    def threshold(self, density: NDArray | float, hours: NDArray | float) -> NDArray[np.float64]:
        """Threshold stress (Pa) of snow at rest, by density (kg/m³) and age (h at -10 °C)."""
        parameters, bonding = self.parameters, self.parameters.bonding
        aged = hours if bonding.grows else np.full(np.shape(hours), LOOSEST_BONDS)
        law, air = parameters.threshold.law, parameters.air_density
        if law in BY_DENSITY:
            ustar = BY_DENSITY[law](density)
            return np.broadcast_to(air * ustar**2, np.broadcast_shapes(np.shape(density), np.shape(hours)))
        if law == "li_pomeroy":
            winds = li_pomeroy_median(self.temperature, aged)
            ustar = np.vectorize(parameters.drift.friction_velocity, otypes=[np.float64])(winds)
            return np.broadcast_to(air * ustar**2, np.broadcast_shapes(np.shape(density), np.shape(hours)))
        return threshold_stress(
            density,
            aged,
            self.temperature,
            air_density=air,
            weight=parameters.threshold.weight,
            exponent=bonding.exponent,
        )

    @cached_property
    def spread(self) -> float:
        """Standard deviation of the threshold wind over the wind on the flat; 0: the threshold is sharp."""
        if self.parameters.threshold.law != "li_pomeroy":
            return 0.0
        return li_pomeroy_spread(self.temperature) / max(self.wind, 1e-6)

    @cached_property
    def usual_excess(self) -> float:
        """What the wind on flat, fresh drift in motion exceeds its threshold by, as a poll measures it."""
        below = self.impact_threshold / max(self.stress, 1e-12)
        if self.spread > 0.0:
            return normal_share((1.0 - below**self.parameters.drift.stress_power) / self.spread)
        return max(1.0 - below, 1e-12)

    @cached_property
    def fresh_threshold(self) -> float:
        """Threshold stress (Pa) that starts fresh drift."""
        return float(self.threshold(self.drift_density, LOOSEST_BONDS))

    @cached_property
    def impact_threshold(self) -> float:
        """Stress (Pa) at which drift over fresh drift dies out."""
        return IMPACT_STRESS * self.fresh_threshold

    @cached_property
    def flux(self) -> float:
        """Saturated flux (kg/m/s) over fresh drift; 0 for a wind that cannot start the loosest snow."""
        air = self.parameters.air_density
        loosest = min(float(self.threshold(100.0, LOOSEST_BONDS)), self.fresh_threshold)
        if self.stress <= loosest:
            return 0.0
        ustar = math.sqrt(self.stress / air)
        return self.parameters.drift.mass_flux(ustar, math.sqrt(self.impact_threshold / air), air)

    @cached_property
    def supply(self) -> float:
        """Saturated flux over that at the temperature for which winds have their polls."""
        usual = Conditions(self.parameters, self.wind, self.parameters.temperature).flux
        return self.flux / usual if usual > 0.0 else 1.0

    def creep(self, cell_size: float) -> Creep | None:
        """How quanta that have landed roll on cells of a size (m); None: not at all.

        By impacts a quantum is pushed s times the slope along either axis, which is chosen at random. Quanta
        land at the rate Q p_s / (L m0), so that s Q p_s cell / (2 L) creep down a slope of one; this is
        ``gain`` Q for s = 2 gain L / (p_s cell).
        """
        rules = self.parameters.creep
        if rules.law == "impacts":
            pushes = 2.0 * rules.gain * self.parameters.hop / (self.parameters.p_s * cell_size)
            return Creep(True, np.int64(0), pushes * HEIGHT_UNIT / cell_size) if rules.gain > 0.0 else None
        excess = max(self.stress - self.impact_threshold, 1e-12)
        chance = min(rules.greatest, rules.strength * self.impact_threshold / excess)
        return Creep(False, np.int64(round(chance * 2**32)), 0.0) if rules.strength > 0.0 else None

    @cached_property
    def rate(self) -> float:
        """How fast bonds grow, over -10 °C."""
        cold = min(self.temperature, 0.0)
        return float(bonding_rate(cold, self.parameters.bonding.activation_energy))


class RelativeFlux:
    """Saturated fluxes of winds (m/s at 10 m) at the model's temperature, over the reference wind's.

    Those of the last winds are kept: one row of a record blows for many steps.
    """

    def __init__(self, parameters: SnowParameters) -> None:
        """Find the flux of the reference wind."""
        self._flux = lru_cache(_KEPT)(partial(_flux_of, parameters))
        self._reference = max(_flux_of(parameters, parameters.reference_wind), 1e-300)

    def __call__(self, winds: NDArray[np.float64]) -> NDArray[np.float64]:
        """The fluxes of ``winds``, in an array of their shape."""
        fluxes = np.array([self._flux(float(wind)) for wind in winds.flat])
        return fluxes.reshape(winds.shape) / self._reference


def _flux_of(parameters: SnowParameters, wind: float) -> float:
    return Conditions(parameters, wind, parameters.temperature).flux


def step_seconds(parameters: SnowParameters) -> float:
    """Duration of a step (s): flat, fresh drift gives what the reference wind carries at saturation.

    Infinite where the reference wind carries nothing.
    """
    flux = Conditions(parameters, parameters.reference_wind, parameters.temperature).flux
    moved = parameters.erosion_chance * parameters.hop * parameters.quantum / parameters.p_s
    return moved / flux if flux > 0.0 else math.inf


@lru_cache(maxsize=32)
def layer_tables(now: Conditions, drifting: bool, flux_share: float, cell_size: float) -> LayerTables:
    """What layers do under these conditions, by class of density and age.

    ``drifting``: whether grains in the air keep loose snow moving below its threshold; ``flux_share``: drift
    in the air over saturation.
    """
    parameters, stress = now.parameters, max(now.stress, 1e-12)
    bonding = parameters.bonding
    density, hours = _classes(now.drift_density)
    static = now.threshold(density, hours)
    bonded = np.broadcast_to((hours >= bonding.loose_hours) & bonding.grows, static.shape)
    threshold = np.where(drifting & ~bonded, IMPACT_STRESS * static, static)
    detached = np.where(bonded, (now.fresh_threshold / static) ** bonding.detachment, 1.0)
    excess = now.usual_excess
    hops = parameters.hop / cell_size / parameters.p_s
    wears = now.supply * parameters.abrasion.rate * _ABRADED / static * hops * flux_share
    yields = parameters.erosion_chance * now.supply * detached / excess
    return LayerTables(
        thickness=quantum_heights(parameters.quantum),
        age_class=_AGES,
        threshold=(threshold / stress).astype(np.float32).ravel(),
        yields=np.minimum(yields, _SURE).astype(np.float32).ravel(),
        wears=np.where(bonded, np.minimum(wears, _SURE), 0.0).astype(np.float32).ravel(),
        bonded=bonded.astype(np.uint8).ravel(),
        face_limit=_limits(now, density, bonded, cell_size).ravel(),
    )


def _limits(
    now: Conditions, density: NDArray[np.float64], bonded: NDArray[np.bool_], cell_size: float
) -> NDArray[np.int32]:
    """Largest steps (µm) to a face neighbour that stand: one quantum at least, however thick."""
    repose = now.parameters.repose
    wet = now.temperature > 0.0
    angle = np.where(density < repose.fallen_below, repose.fallen, repose.drift)
    angle = np.where(wet, repose.wet, angle)
    steps = np.floor(np.tan(np.radians(angle)) * cell_size / HEIGHT_UNIT + 1e-6)
    lightest = np.arange(DENSITY_CLASSES) * (_ANY_DENSITY // DENSITY_CLASSES)
    one_quantum = quantum_heights(now.parameters.quantum)[lightest][:, None]
    return np.where(bonded, _NEVER, np.clip(steps, one_quantum, _NEVER)).astype(np.int32)


_AGES = age_classes()


def _classes(drift: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Density (kg/m³, column) and age (h, row) in the middle of each class; that of ``drift`` is exact."""
    ages = np.arange(_AGES.size)
    means = np.bincount(_AGES, ages, AGE_CLASSES) / np.maximum(np.bincount(_AGES, minlength=AGE_CLASSES), 1)
    means[_AGES[-1] + 1 :] = ages[-1]
    width = _ANY_DENSITY / DENSITY_CLASSES
    density = (np.arange(DENSITY_CLASSES, dtype=np.float64) + 0.5) * width
    density[min(int(drift / width), DENSITY_CLASSES - 1)] = drift
    hours: NDArray[np.float64] = np.maximum(means * EPOCH_SECONDS / _HOUR, LOOSEST_BONDS)
    return density[:, None], hours[None, :]


def thickness_of(words: NDArray[np.int64], quantum: float) -> NDArray[np.int64]:
    """Thickness (µm) of packed layers of quanta of a mass (kg/m²)."""
    heights = quantum_heights(quantum)[density_of(words).astype(np.int64)]
    return np.asarray(quanta_of(words) * heights)


@lru_cache(maxsize=8)
def quantum_heights(quantum: float) -> NDArray[np.int32]:
    """Height (µm) of a quantum (kg/m²) by density in whole kg/m³."""
    density = np.maximum(np.arange(_ANY_DENSITY), 1)
    return np.maximum(np.rint(quantum / density / HEIGHT_UNIT), 1).clip(max=2**30).astype(np.int32)
