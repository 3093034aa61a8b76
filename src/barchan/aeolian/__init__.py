"""The physics of wind over sand, once: wall law, thresholds, settling and drag, flux laws, flow over relief.

Nothing here knows of scenarios, lattice models or time steps: speeds, lengths and densities in, numbers out.
"""

from barchan.aeolian.saltation import Saltation

__all__ = ["Saltation"]
