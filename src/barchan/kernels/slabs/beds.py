"""What the graph of bands asks of a bed, which differs from one kind of bed to the next.

The compiler chooses by the types of the arguments: a kind of bed says for each function here what it does
(``numba.extending.overload``), in a file of its own. Functions handed over would be compiled again in each
process. Not with ``inline="always"``: of the heights that ``poll_bed`` returned in a loop the caller then
kept the first one (Numba 0.68).
"""

from numba import types
from numba.extending import overload

from barchan.kernels.bed.levels import measure_levels
from barchan.kernels.bed.state import Stacks
from barchan.kernels.slabs.poll import run_polls
from barchan.kernels.slabs.state import SlabRules


def poll_bed(bed, rules, work, band, count, redraw, target, peak, tally):
    """Run ``count`` prepared polls of a band; a height that no cell exceeds now, ``STRAYED`` or ``FULL``."""
    raise NotImplementedError("for compiled code only")


def measure_bed(bed):
    """Measure what polls of the next rounds go by."""
    raise NotImplementedError("for compiled code only")


def lattice_rules(rules):
    """The rules (``SlabRules``) that beds of every kind have: lattice, wind, interruption."""
    raise NotImplementedError("for compiled code only")


def is_a(kind, named_tuple):
    """Whether a compiler's type is that of a named tuple."""
    return isinstance(kind, types.NamedTuple) and kind.instance_class is named_tuple


@overload(poll_bed)
def _poll_slabs(bed, rules, work, band, count, redraw, target, peak, tally):
    if is_a(bed, Stacks):

        def poll(bed, rules, work, band, count, redraw, target, peak, tally):
            return run_polls(bed, rules, work, band, count, redraw, target, peak, tally)

        return poll
    return None


@overload(measure_bed)
def _measure_slabs(bed):
    if is_a(bed, Stacks):

        def measure(bed):
            measure_levels(bed.surface, bed.levels)

        return measure
    return None


@overload(lattice_rules)
def _rules_of_slabs(rules):
    if is_a(rules, SlabRules):

        def own(rules):
            return rules

        return own
    return None
