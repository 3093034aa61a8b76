"""Snow that bonds on the bed: its loose parcels by age, and the timer that moves them on."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Bed
from barchan.fields import SAND, LayerInfo
from barchan.grains.sintering import Sintering
from barchan.kernels.bed.state import AGES
from barchan.kernels.grains.state import Bonds
from barchan.model import Derived, Strata

_TICKS = 1e9
"""Parts of a second in which time is counted, as whole numbers: sums do not depend on how a run is cut."""

LOOSE = [
    LayerInfo(
        f"loose_{age}",
        "int32",
        SAND.unit,
        f"loose parcels that came to rest {age - 1} to {age} quarters of the bonding time ago",
        part_of=SAND.name,
        class_value=(age - 0.5) / AGES,
        class_unit="bonding time",
    )
    for age in range(1, AGES + 1)
]
"""The loose parcels by age, the youngest first."""

BONDED = LayerInfo(
    "bonded",
    "int32",
    SAND.unit,
    "parcels that have bonded",
    False,
    part_of=SAND.name,
    class_value=1.0,
    class_unit="bonding time",
)


class BondedSnow:
    """Loose and bonded parcels of every cell, as fields, and the time since the ages moved on."""

    def __init__(self, sintering: Sintering) -> None:
        """Start the timer."""
        self.sintering = sintering
        self.timer = 0
        """Time (ns, at a rate of 1) since the ages moved on."""

    def initialise(self, bed: Bed) -> None:
        """Add loose and bonded parcels to a bed: all of one kind."""
        none = np.zeros_like(bed.sand)
        for field in LOOSE:
            bed.add(field, none.copy())
        bed.add(BONDED, none.copy())
        first = BONDED if self.sintering.start_bonded else LOOSE[0]
        bed.arrays[first.name][...] = bed.sand

    def bonds(self, bed: Bed) -> Bonds:
        """The fields as kernels take them, copied, and brought up to date with snow that was painted.

        Frames carry no bonded parcels: those are the rest.
        """
        from barchan.kernels.bed.loose import follow

        closure, sand = self.sintering, bed.sand.reshape(-1)
        loose = np.stack([bed.arrays[field.name].reshape(-1) for field in LOOSE], axis=1)
        if BONDED.name in bed.arrays:
            follow(loose, bed.arrays[BONDED.name].reshape(-1), sand)
        return Bonds(loose, False, closure.hardness, closure.restitution)

    def store(self, bed: Bed, bonds: Bonds) -> None:
        """Put loose and bonded parcels back into the fields."""
        for age, field in enumerate(LOOSE):
            bed.arrays[field.name].reshape(-1)[...] = bonds.loose[:, age]
        if BONDED.name in bed.arrays:
            bed.arrays[BONDED.name].reshape(-1)[...] = bed.sand.reshape(-1) - bonds.loose.sum(axis=1)

    def pass_time(self, seconds: float, temperature: float | None, bonds: Bonds) -> None:
        """Let snow age for some seconds at a temperature (°C): each quarter of a bonding time ages move on.

        A step longer than a quarter moves them on several times.
        """
        closure = self.sintering
        self.timer += round(seconds * closure.rate(temperature) * _TICKS)
        quarter = round(closure.full_time / AGES * _TICKS)
        while self.timer >= quarter:
            self.timer -= quarter
            bonds.loose[:, 1:] = bonds.loose[:, :-1].copy()
            bonds.loose[:, 0] = 0

    def state(self) -> dict[str, Any]:
        """The timer."""
        return {"bond_timer": self.timer}

    def restore(self, state: dict[str, Any]) -> None:
        """Take up the timer."""
        self.timer = int(state["bond_timer"])


def loose_parcels(bed: Bed) -> NDArray[np.int64]:
    """Loose parcels of each cell; where nothing bonds all of them."""
    if LOOSE[0].name not in bed.arrays:
        return bed.sand.astype(np.int64)
    return np.sum([bed.arrays[field.name] for field in LOOSE], axis=0, dtype=np.int64)


def bonded_share(bed: Bed) -> NDArray[np.float64]:
    """Share of the snow of each cell that has bonded; 0 on bare ground."""
    return 1.0 - np.divide(loose_parcels(bed), bed.sand, out=np.ones(bed.sand.shape), where=bed.sand > 0)


def strata(bed: Bed) -> list[tuple[NDArray[np.float64], NDArray[np.float64]]]:
    """Thickness (m) and age (bonding times) of bonded and loose snow, the bonded and oldest first."""
    if LOOSE[0].name not in bed.arrays:
        return [_layer(bed, bed.sand, 0.0)]
    loose = [_layer(bed, bed.arrays[field.name], field.class_value or 0.0) for field in reversed(LOOSE)]
    return [_layer(bed, bed.sand - loose_parcels(bed), 1.0), *loose]


def _bonded(bed: Bed) -> list[tuple[NDArray[np.float64], NDArray[np.float64]]]:
    """Thickness (m) of bonded and loose snow, and 1 where it has bonded, else 0."""
    return [(thickness, (age >= 1.0).astype(np.float64)) for thickness, age in strata(bed)]


def _dense(model: Any, bed: Bed) -> list[tuple[NDArray[np.float64], NDArray[np.float64]]]:
    """Thickness (m) and density (kg/m³) of bonded and loose snow: that of the bed."""
    density = model.parameters.grain_density * (1.0 - model.parameters.porosity)
    return [(thickness, np.full(thickness.shape, density)) for thickness, _ in strata(bed)]


def _massive(model: Any, bed: Bed) -> list[tuple[NDArray[np.float64], NDArray[np.float64]]]:
    """Thickness (m) and mass (kg/m²) of bonded and loose snow."""
    return [(thickness, thickness * density) for thickness, density in _dense(model, bed)]


def _layer(bed: Bed, parcels: NDArray, age: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    return parcels * bed.lattice.thickness, np.full(parcels.shape, age)


DERIVED = (
    Derived(
        "bonded_share",
        "1",
        "share of the snow that has bonded",
        lambda _model, bed, _wind: bonded_share(bed),
        least=0.0,
    ),
    Derived(
        "loose_depth",
        "m",
        "thickness of the snow that has not bonded",
        lambda _model, bed, _wind: loose_parcels(bed) * bed.lattice.thickness,
        least=0.0,
    ),
)
"""Fields of snow that bonds, computed when someone looks."""

STRATA = (
    Strata("age", "age of the bonds", "bonding times", lambda _model, bed: strata(bed)),
    Strata("state", "state", "-", lambda _model, bed: _bonded(bed), ("loose", "bonded")),
    Strata("density", "density", "kg/m³", _dense, drawn=False),
    Strata("mass", "mass", "kg/m²", _massive, drawn=False),
)
"""The layers of snow that sections and tables show; bonds are of age 1."""
