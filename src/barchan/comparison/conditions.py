"""What the variants of a report have in common, and how long a step of each lasts."""

from collections.abc import Sequence
from itertools import pairwise

from barchan.comparison.variants import Variant, differing_keys
from barchan.comparison.words import listed
from barchan.scenario.summary import field_size
from barchan.wind.clock import DAY, YEAR
from barchan.words import counted

CONDITIONS = {"ground": ("ground", "lattice", "sand"), "wind": ("wind",), "random numbers": ("run.seed",)}
"""What variants may have in common, and the beginnings of the keys that it depends on."""

ROUNDING = 1e-9
"""Shares by which durations differ that are equal but for rounding."""


def lead(variants: Sequence[Variant]) -> str:
    """How many variants there are, on which field, for how many steps, and what they have in common."""
    scenarios = [variant.scenario for variant in variants]
    fields = list(dict.fromkeys(map(field_size, scenarios)))
    steps = list(dict.fromkeys(scenario.run.steps for scenario in scenarios))
    lasting = counted(steps[0], "step") if len(steps) == 1 else f"{listed(list(map(str, steps)))} steps"
    common = shared_conditions(variants)
    return (
        f"{counted(len(variants), 'variant')}, {counted(len(variants[0].reports), 'seed')} each, on "
        f"{f'the same {fields[0]}' if len(fields) == 1 else f'fields of {listed(fields)}'}, {lasting}"
        f"{f', with the same {listed(common)}' if common else ''}."
    )


def shared_conditions(variants: Sequence[Variant]) -> list[str]:
    """Those of ``CONDITIONS`` that are the same for all variants."""
    keys = differing_keys(variants)
    return [
        name
        for name, groups in CONDITIONS.items()
        if not any(key == group or key.startswith(f"{group}.") for key in keys for group in groups)
    ]


def unequal_times(variants: Sequence[Variant]) -> str:
    """A warning where steps last differently, so that equal steps are not equal times; else empty."""
    lasting = [(variant.label, variant.scenario.step_seconds) for variant in variants]
    known = [(label, seconds) for label, seconds in lasting if seconds is not None]
    if all(abs(a - b) <= ROUNDING * a for (_, a), (_, b) in pairwise(known)):
        return ""
    (first, duration), *others = known
    told = [f"a step of “{first}” lasts {clock_time(duration)}"]
    told += [f"one of “{label}” {clock_time(seconds)}" for label, seconds in others]
    return (
        f"{'Both' if len(variants) == 2 else 'All'} runs are compared at equal steps, not at equal times: "
        f"{', '.join(told)}. Where the wind changes with time, they are under different winds."
    )


def clock_time(seconds: float) -> str:
    """A duration with days, hours and minutes, as the studio shows it."""
    days, rest = divmod(int(seconds), int(DAY))
    clock = f"{rest // 3600:02d}:{rest % 3600 // 60:02d}"
    if seconds < 120:
        return f"{seconds:.3g} s"
    if seconds < 7200:
        return f"{int(seconds) // 60} min {int(seconds) % 60:02d} s"
    if days < 1:
        return f"{clock} h"
    return f"{days} d {clock}" if days < 1000 else f"{seconds / YEAR:.1f} years"
