"""The wind near the bed, slowed by the momentum that grains take from it."""

import math

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.flow_over_relief import Spectrum
from barchan.grains.ripple_parameters import RipplesParameters
from barchan.lattice import Lattice

RESPONSE = 0.05
"""Time (s) over which the wind near the bed adjusts to the grains: about a hop."""

LEAST_SHARE = 0.1
"""Share of the friction velocity that grains leave near the bed at least."""


class SlowedWind:
    """The stress that grains take from the wind: one for the field, or one for each cell."""

    def __init__(self, rules: RipplesParameters, lattice: Lattice) -> None:
        """Start with air that no grain has slowed."""
        self.rules, self.lattice = rules, lattice
        self.by_place = rules.near_bed == "slowed" and rules.sharing_width is not None
        self.stress = np.zeros(lattice.shape if self.by_place else ())
        """Stress (Pa) that grains take, as of late."""

    def feel(self, lost: NDArray[np.float64], seconds: float, direction: float) -> None:
        """Adjust to the speed (m/s) that impacts took in some seconds, by cell, under a wind.

        That comes from ``direction`` (degrees).
        """
        rules = self.rules
        thickness = rules.carried * self.lattice.thickness
        mass = rules.weight * rules.grain_density * (1.0 - rules.porosity) * thickness
        lost = self._shared(lost, direction) if self.by_place else np.asarray(lost.mean())
        self.stress += (mass * lost / seconds - self.stress) * -math.expm1(-seconds / RESPONSE)

    def friction(self, friction: float) -> NDArray[np.float64]:
        """Friction velocity (m/s) below the focus, of a wind with that ``friction`` velocity above."""
        if self.rules.near_bed == "threshold":
            return np.asarray(self.rules.impact_threshold())
        left = friction**2 - self.stress / self.rules.air_density
        return np.asarray(np.sqrt(np.maximum(left, (LEAST_SHARE * friction) ** 2)))

    def _shared(self, lost: NDArray[np.float64], direction: float) -> NDArray[np.float64]:
        """The wind carries what is lost along, and spreads it less to its sides."""
        along, across = self.rules.sharing_width or 0.0, self.rules.sharing_across
        return Spectrum(lost, self.lattice, direction).shared(along, across)
