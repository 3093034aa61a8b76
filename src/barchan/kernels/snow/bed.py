"""What the graph of bands (``kernels.slabs.bands``) asks of a bed of snow."""

from numba.extending import overload

from barchan.kernels.slabs.beds import is_a, lattice_rules, measure_bed, poll_bed
from barchan.kernels.snow.poll import run_polls
from barchan.kernels.snow.state import Pack, SnowRules


@overload(poll_bed)
def _poll_snow(bed, rules, work, band, count, redraw, target, peak, tally):
    if is_a(bed, Pack):

        def poll(bed, rules, work, band, count, redraw, target, peak, tally):
            return run_polls(bed, rules, work, band, count, peak, tally)

        return poll
    return None


@overload(measure_bed)
def _measure_snow(bed):
    if is_a(bed, Pack):

        def measure(bed):
            pass

        return measure
    return None


@overload(lattice_rules)
def _rules_of_snow(rules):
    if is_a(rules, SnowRules):

        def shared(rules):
            return rules.slabs

        return shared
    return None
