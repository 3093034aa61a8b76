"""Impacts of drift that break young bonds as fast as they grow, where the surface lies open to them."""

import numpy as np
from numpy.typing import NDArray

from barchan.kernels.snow.state import Pack, SnowRules

IMPACTS = -1
"""Number of the random sequences of impacts under the key of a moment, below those of its cells."""


def strike(pack: Pack, rules: SnowRules, quanta: float, key: int) -> None:
    """Let the loose snow at the top of all struck cells, in the mean ``quanta`` deep, bond from now on."""
    from barchan.kernels.snow.impacts import break_bonds

    break_bonds(pack, rules.tables, struck(pack, rules), float(quanta), rules.epoch, np.uint64(key))


def struck(pack: Pack, rules: SnowRules) -> NDArray[np.bool_]:
    """Cells that grains in the air strike with their full force.

    There the stress keeps drift going (it is not below the impact threshold of fresh drift), and nothing
    upwind shelters the cell. In calm hollows and behind slip faces grains come down spent, and snow bonds.
    """
    from barchan.kernels.slabs.shadow import shadow_zone

    slabs = rules.slabs
    sheltered = np.zeros(pack.top.size, np.bool_)
    shadow_zone(pack.surface, slabs.grid, slabs.axis, slabs.ray, slabs.box, sheltered)
    stress = np.float32(1.0) if rules.stress is None else rules.stress
    return (stress >= np.float32(rules.impact_threshold)) & ~sheltered
