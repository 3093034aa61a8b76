"""How much work grains in flight are expected to be, before any flies."""

from barchan.grains.parameters import GrainFlight
from barchan.grains.wind_feedback import Feedback
from barchan.lattice import Lattice

_LIFT = 1.4
"""Mean upward speed of lift-off over the friction velocity (Szabó 2019, eq. 3.2: 0.8 to 2)."""

_HOPS = 2.0
"""Hops of a trajectory from lift-off to rest, roughly."""

_ALONE = 40.0
"""Updates of grains that fly together in the time of one of a grain that flies alone."""


def work_of_step(rules: GrainFlight, lattice: Lattice, speed: float, share: float) -> float:
    """Grain updates in the ``share`` of a step in which a wind of ``speed`` (m/s at 10 m) blows.

    Those of grains that fly one after the other are counted as the others that would take as long.
    """
    ustar = rules.friction_velocity(speed)
    if rules.clock == "step":
        iterations = _HOPS * 2.0 * _LIFT * ustar / (rules.gravity * rules.time_step)
        return _ALONE * share * lattice.cells * max(iterations, 1.0)
    return share * rules.iterations_per_step * grains_per_cell(rules, lattice, ustar) * lattice.cells


def grains_per_cell(rules: GrainFlight, lattice: Lattice, ustar: float) -> float:
    """Simulated grains in the air over a cell, on the average, in a wind with a friction velocity (m/s).

    Where grains slow the wind, their mass per area is that of saturated saltation,
    ρ_a (u*² - u*t²) / g (Owen 1964), u*t being the impact threshold. Elsewhere every slot holds a grain
    above the threshold.
    """
    feedback = rules.part(Feedback)
    if feedback is None:
        return rules.max_grains_per_cell if ustar > rules.threshold() else 0.0
    excess = ustar**2 - rules.impact_threshold() ** 2
    load = rules.air_density * max(excess, 0.0) / rules.gravity
    height = rules.carried * lattice.thickness * feedback.momentum_weight
    return min(load / (rules.grain_density * (1.0 - rules.porosity) * height), rules.max_grains_per_cell)
