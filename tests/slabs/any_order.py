"""A plan's bands in an order that chance makes, of those that the plan allows."""

from numba import njit

from barchan.kernels.slabs.bands import _NOTHING, _next_band, _run, _waits
from barchan.kernels.slabs.beds import lattice_rules


@njit
def run_in_any_order(bed, rules, work, schedule, plan, tally, random):
    """Run a plan on one thread, each time a band chosen at random of those that need not wait."""
    bands, last = plan.peaks.size, plan.rounds.shape[0]
    wrap = lattice_rules(rules).grid.wrap_across
    k = 0
    while True:
        band, number = _next_band(plan, wrap)
        if band == _NOTHING:
            return
        first = random[k % random.size] % bands
        for step in range(bands):
            other = (first + step) % bands
            begun = plan.done[other]
            if begun < min(last, plan.done[bands]) and not _waits(plan, other, begun, wrap):
                band, number = other, begun
                break
        plan.taken[band] += 1
        _run(bed, rules, work, schedule, plan, band, number, tally)
        plan.done[band] += 1
        k += 1
