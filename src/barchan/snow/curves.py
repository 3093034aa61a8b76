"""The closures of snow as curves: what age, temperature, wind and load make of it."""

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.grains import GRAVITY
from barchan.aeolian.snow.bonding import LOOSEST_BONDS
from barchan.aeolian.snow.density import PACKING
from barchan.model import Curve
from barchan.snow.conditions import Conditions
from barchan.snow.parameters import SnowParameters

AGES = np.geomspace(LOOSEST_BONDS, 240.0, 60)
"""Ages (h at -10 °C) of curves."""

TEMPERATURES = np.linspace(-40.0, 0.0, 41)
"""Temperatures (°C) of curves."""

WINDS = np.linspace(0.0, 25.0, 51)
"""Winds (m/s at 10 m) of curves."""

COLD, COOL, MILD = -20.0, -10.0, -3.0
"""Temperatures (°C) of the curves of a panel."""

FALLEN, DRIFT = 100.0, 350.0
"""Densities (kg/m³) of fallen snow and of drift in curves."""

LOADS = 10.0, 50.0
"""Masses (kg/m²) above a layer that packs."""

DAYS = np.linspace(0.0, 30.0, 61)
"""Days for which layers pack."""

_PARTS = 20
"""Parts of the time from one point of a packing curve to the next."""

_DAY = 86_400.0

THRESHOLD_SOURCE = "Schmidt 1980; Li & Pomeroy 1997; Lehning et al. 2000; van Herwijnen & Miller 2013"
_FRESH_SOURCES = {
    "hedstrom_pomeroy": "Hedstrom & Pomeroy 1998",
    "clm5": "van Kampenhout et al. 2017",
    "pahaut": "Pahaut 1976",
}
_PACKING_SOURCES = {"vionnet": "Vionnet et al. 2012", "anderson": "Anderson 1976"}
_FLUX_SOURCES = {"sorensen": "Sørensen 2004; Vionnet et al. 2014", "pomeroy_gray": "Pomeroy & Gray 1990"}


def snow_curves(parameters: SnowParameters) -> list[Curve]:
    """The closures of snow under its parameters, in the order in which snow meets them."""
    return [
        *_thresholds_by_age(parameters),
        *_thresholds_by_temperature(parameters),
        _bonding(parameters),
        *_fresh(parameters),
        _drift(parameters),
        *_packing(parameters),
        *_flux(parameters),
    ]


def _curve(title: str, x: NDArray, y: NDArray, titles: tuple[str, str], source: str, log_x: bool) -> Curve:
    return Curve(title, tuple(x.tolist()), tuple(y.tolist()), *titles, source=source, log_x=log_x)


def _withstood(parameters: SnowParameters, density: float, hours: NDArray, temperature: float) -> NDArray:
    """Winds (m/s at 10 m) that snow of a density withstands, by its age (h at -10 °C)."""
    now = Conditions(parameters, 0.0, temperature)
    ustar = np.sqrt(now.threshold(np.full(hours.shape, density), hours) / parameters.air_density)
    return parameters.drift.speed_of(ustar)


def _thresholds_by_age(parameters: SnowParameters) -> list[Curve]:
    titles = "age of the bonds (h at -10 °C)", "threshold wind at 10 m (m/s)"
    kinds = (("fallen", FALLEN), ("drift", DRIFT))
    return [
        _curve(
            f"{name}, {density:g} kg/m³, at {temperature:g} °C",
            AGES,
            _withstood(parameters, density, AGES, temperature),
            titles,
            THRESHOLD_SOURCE,
            True,
        )
        for name, density in kinds
        for temperature in (COLD, COOL)
    ]


def _thresholds_by_temperature(parameters: SnowParameters) -> list[Curve]:
    titles = "temperature (°C)", "threshold wind at 10 m (m/s)"
    return [
        _curve(
            f"fallen, {FALLEN:g} kg/m³, bonds of {age:g} h at -10 °C",
            TEMPERATURES,
            np.array([_withstood(parameters, FALLEN, np.array([age]), t)[0] for t in TEMPERATURES]),
            titles,
            THRESHOLD_SOURCE,
            False,
        )
        for age in (1.0, 24.0)
    ]


def _bonding(parameters: SnowParameters) -> Curve:
    rates = np.array([Conditions(parameters, 0.0, t).rate for t in TEMPERATURES])
    titles = "temperature (°C)", "speed of bonding over that at -10 °C"
    energy = parameters.bonding.activation_energy / 1000.0
    return _curve(f"{energy:g} kJ/mol", TEMPERATURES, rates, titles, "Arrhenius; Bahaloo et al. 2022", False)


def _fresh(parameters: SnowParameters) -> list[Curve]:
    """The chosen density of fresh snow, in a calm and under a wind where that matters."""
    titles = "temperature (°C)", "density of fresh snow (kg/m³)"
    law = parameters.snowfall
    found = []
    for wind in (0.0, 8.0):
        values = np.array([law.fresh_density(t, wind) for t in TEMPERATURES])
        source = _FRESH_SOURCES[law.density_law] if law.density is None else "stated"
        found.append(_curve(f"in a wind of {wind:g} m/s", TEMPERATURES, values, titles, source, False))
    return found if found[0].y != found[1].y else [found[0]]


def _drift(parameters: SnowParameters) -> Curve:
    winds = WINDS[1:]
    values = np.array([parameters.drift.laid_density(wind) for wind in winds])
    source = "Groot Zwaaftink et al. 2013" if parameters.drift.density is None else "stated"
    titles = "wind at 10 m (m/s)", "density of drift laid down (kg/m³)"
    return _curve("drift", winds, values, titles, source, False)


def _packing(parameters: SnowParameters) -> list[Curve]:
    law = parameters.packing.law
    if law == "none":
        return []
    titles = "time (days)", "density of a layer (kg/m³)"
    return [
        _curve(
            f"under {load:g} kg/m² at {temperature:g} °C",
            DAYS,
            _packed(law, load, temperature),
            titles,
            _PACKING_SOURCES[law],
            False,
        )
        for load in LOADS
        for temperature in (COOL, MILD)
    ]


def _packed(law: str, load: float, temperature: float) -> NDArray[np.float64]:
    """Densities (kg/m³) on ``DAYS`` of snow fallen at ``FALLEN`` kg/m³ under a load (kg/m²)."""
    viscosity, settling = PACKING[law]
    density = np.array([FALLEN])
    found = [FALLEN]
    seconds = (DAYS[1] - DAYS[0]) * _DAY / _PARTS
    for _ in DAYS[1:]:
        for _part in range(_PARTS):
            rate = load * GRAVITY / viscosity(density, temperature) + settling(density, temperature)
            density = density * np.exp(rate * seconds)
        found.append(float(density[0]))
    return np.array(found)


def _flux(parameters: SnowParameters) -> list[Curve]:
    titles = "wind at 10 m (m/s)", "saturated flux (kg/m/s)"
    source = _FLUX_SOURCES[parameters.drift.flux]
    return [
        _curve(
            f"fresh drift at {temperature:g} °C",
            WINDS[1:],
            np.array([Conditions(parameters, wind, temperature).flux for wind in WINDS[1:].tolist()]),
            titles,
            source,
            False,
        )
        for temperature in (COLD, COOL)
    ]
