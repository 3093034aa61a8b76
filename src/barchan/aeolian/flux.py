"""Flux laws: how much sand a steady wind carries over a full bed, once the flux has grown to its limit.

Each law is a function of friction velocity and threshold (m/s, numbers or arrays) and of the sand; it gives
the mass per time and metre of width (kg/m/s) of a wind above the threshold. ``mass_flux`` is zero at and
below the threshold, whatever the law.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.grains import GRAVITY, Numbers
from barchan.aeolian.wall import KARMAN

Sorting = Literal["uniform", "dune", "poor"]
LawName = Literal[
    "bagnold", "bagnold_threshold", "kawamura", "lettau", "tsoar", "owen", "quadratic", "pahtz_duran"
]

REFERENCE_DIAMETER = 0.25e-3
"""The grain diameter (m) that Bagnold's and Lettau's coefficients are stated for."""

IMPACT_RATIO = 0.8
"""Impact threshold, at which saltation dies out, over the threshold that starts it (Bagnold 1941)."""

BAGNOLD: dict[str, float] = {"uniform": 1.5, "dune": 1.8, "poor": 2.8}
"""Bagnold's coefficient C by how well sorted the sand is: one size, as on dunes, of very many sizes."""


@dataclass(frozen=True)
class Sand:
    """The properties of sand and air that flux laws take."""

    diameter: float = REFERENCE_DIAMETER
    """Of the grains (m)."""
    grain_density: float = 2650.0
    """kg/m³."""
    air_density: float = 1.225
    """kg/m³."""
    sorting: Sorting = "dune"

    @property
    def coarseness(self) -> float:
        """√(d / D), D = 0.25 mm."""
        return float(np.sqrt(self.diameter / REFERENCE_DIAMETER))

    @property
    def buoyant(self) -> float:
        """(s - 1) g d (m²/s²), s the grains' density over the air's: u*² over it is the Shields number."""
        return (self.grain_density / self.air_density - 1.0) * GRAVITY * self.diameter


@dataclass(frozen=True)
class Law:
    """A flux law."""

    flux: Callable[[Numbers, float, Sand], Numbers]
    """Mass flux (kg/m/s) of friction velocity and threshold (m/s) and sand, above the threshold."""
    title: str
    formula: str
    source: str


def bagnold(u: Numbers, _threshold: float, sand: Sand) -> Numbers:
    """C √(d / D) (ρ / g) u*³, with C by sorting; without a threshold."""
    return BAGNOLD[sand.sorting] * sand.coarseness * _per_gravity(sand) * u**3


def bagnold_threshold(u: Numbers, threshold: float, sand: Sand) -> Numbers:
    """C √(d / D) (ρ / g) (u* - u_t)³, with C by sorting."""
    return bagnold(u - threshold, threshold, sand)


def kawamura(u: Numbers, threshold: float, sand: Sand) -> Numbers:
    """2.78 (ρ / g) (u* - u_t) (u* + u_t)²."""
    return 2.78 * _per_gravity(sand) * (u - threshold) * (u + threshold) ** 2


def lettau(u: Numbers, threshold: float, sand: Sand) -> Numbers:
    """6.7 √(d / D) (ρ / g) u*² (u* - u_t)."""
    return 6.7 * sand.coarseness * _per_gravity(sand) * u**2 * (u - threshold)


def tsoar(u: Numbers, threshold: float, sand: Sand) -> Numbers:
    """K u*² (u* - u_t), K = 6.7 (C / 1.8) √(d / D) (ρ / g).

    K is ours, for the sources only name what it depends on: Lettau's coefficient, for grain size and air
    density, times Bagnold's C for the sorting over that of dune sand.
    """
    return lettau(u, threshold, sand) * BAGNOLD[sand.sorting] / BAGNOLD["dune"]


def owen(u: Numbers, threshold: float, sand: Sand) -> Numbers:
    """5 (ρ / g) u_i (u*² - u_i²), u_i = 0.8 u_t the impact threshold."""
    impact = IMPACT_RATIO * threshold
    return 5.0 * _per_gravity(sand) * impact * (u**2 - impact**2)


def quadratic(u: Numbers, threshold: float, sand: Sand) -> Numbers:
    """ρ_grain Q 7.8 √Θ_i (Θ - Θ_i), Θ = u*² / ((s - 1) g d), Θ_i that of 0.8 u_t, Q = d √((s - 1) g d)."""
    excess, impact = _shields(u, threshold, sand)
    return _grain_flux(sand) * 7.8 * np.sqrt(impact) * excess


def pahtz_duran(u: Numbers, threshold: float, sand: Sand) -> Numbers:
    """ρ_grain Q (2 / (κ μ)) √Θ_i (Θ - Θ_i) (1 + (1.7 / μ) (Θ - Θ_i)), μ = 0.63, else as ``quadratic``."""
    friction = 0.63
    excess, impact = _shields(u, threshold, sand)
    collisions = 1.0 + 1.7 / friction * excess
    return _grain_flux(sand) * 2.0 / (KARMAN * friction) * np.sqrt(impact) * excess * collisions


def _per_gravity(sand: Sand) -> float:
    return sand.air_density / GRAVITY


def _grain_flux(sand: Sand) -> float:
    """Mass of grains (kg/m/s) that the characteristic flux d √((s - 1) g d) carries."""
    return sand.grain_density * sand.diameter * float(np.sqrt(sand.buoyant))


def _shields(u: Numbers, threshold: float, sand: Sand) -> tuple[Numbers, float]:
    """Shields number above the impact threshold, and that threshold."""
    impact = (IMPACT_RATIO * threshold) ** 2 / sand.buoyant
    return u**2 / sand.buoyant - impact, impact


LAWS: dict[str, Law] = {
    "bagnold": Law(bagnold, "Bagnold", "C √(d/D) (ρ/g) u*³", "Bagnold (1941), The physics of blown sand"),
    "bagnold_threshold": Law(
        bagnold_threshold,
        "Bagnold with threshold",
        "C √(d/D) (ρ/g) (u* - u_t)³",
        "the form that AeoLiS uses",
    ),
    "kawamura": Law(
        kawamura,
        "Kawamura",
        "2.78 (ρ/g) (u* - u_t) (u* + u_t)²",
        "Kawamura (1951), Rep. Inst. Sci. Technol. 5",
    ),
    "lettau": Law(
        lettau,
        "Lettau & Lettau",
        "6.7 √(d/D) (ρ/g) u*² (u* - u_t)",
        "Lettau & Lettau (1978), Exploring the world's driest climate",
    ),
    "tsoar": Law(tsoar, "after Tsoar", "K u*² (u* - u_t)", "Prague thesis, Eq. 2.1; K is ours"),
    "owen": Law(
        owen,
        "Owen, Ungar & Haff",
        "5 (ρ/g) u_i (u*² - u_i²)",
        "Owen (1964); Ungar & Haff (1987); coefficient of Kok et al. (2012)",
    ),
    "quadratic": Law(
        quadratic, "Durán et al.", "7.8 ρ_g Q √Θ_i (Θ - Θ_i)", "Durán et al. (2011), Aeolian Res. 3, 243"
    ),
    "pahtz_duran": Law(
        pahtz_duran,
        "Pähtz & Durán",
        "(2/κμ) ρ_g Q √Θ_i (Θ - Θ_i) (1 + (1.7/μ) (Θ - Θ_i))",
        "Pähtz & Durán (2020), Phys. Rev. Lett. 124, 168001",
    ),
}
"""Flux laws by name."""


def mass_flux(law: LawName, friction_velocity: Numbers, threshold: float, sand: Sand) -> NDArray[np.float64]:
    """Mass flux (kg/m/s) by a law; zero where the friction velocity does not exceed the threshold."""
    u = np.asarray(friction_velocity, np.float64)
    return np.where(u > threshold, LAWS[law].flux(np.maximum(u, threshold), threshold, sand), 0.0)
