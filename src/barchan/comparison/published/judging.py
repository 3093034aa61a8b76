"""Whether what was reported of a published result holds of ours, over several seeds."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from barchan.comparison.published.results import Claim
from barchan.comparison.statistics import CONFIDENCE, LEAST, SIGNIFICANT, paired_difference
from barchan.comparison.variants import Variant
from barchan.survey.measuring import measure as survey
from barchan.words import counted

Result = Literal["agrees", "differs", "undecided", "for the eye"]


@dataclass(frozen=True)
class Verdict:
    """A claim, what we found, and whether both agree."""

    claim: Claim
    found: str
    result: Result


def judge(claim: Claim, cases: Mapping[str, Variant]) -> Verdict:
    """Compare a claim with the finished runs of its cases."""
    if not claim.case:
        return Verdict(claim, "see the pictures", "for the eye")
    missing = [name for name in (claim.case, claim.than_case) if name and name not in cases]
    if missing:
        return Verdict(claim, f"no run of {' and '.join(missing)} came to its end", "undecided")
    if claim.forms:
        return _form(claim, cases[claim.case])
    if claim.step is not None:
        return _end(claim, claim.step, cases[claim.case])
    if claim.value is not None:
        return _value(claim, claim.value, cases[claim.case])
    return _order(claim, cases)


def prediction(values: Sequence[float]) -> tuple[float, float]:
    """The interval in which one more value of the same normal distribution lies with a chance of 95 %.

    Student's t with the sample's mean and deviation; infinite where there are fewer than two values.
    """
    from scipy import stats

    if len(values) < LEAST:
        return -math.inf, math.inf
    reach = float(stats.t.ppf((1 + CONFIDENCE) / 2, len(values) - 1))
    reach *= float(np.std(values, ddof=1)) * math.sqrt(1 + 1 / len(values))
    return float(np.mean(values)) - reach, float(np.mean(values)) + reach


_HALF_A_SLAB = 0.5
"""Ours that are whole numbers differ by chance by one even where a few seeds give the same number."""


def _value(claim: Claim, value: float, variant: Variant) -> Verdict:
    ours = list(variant.finals(claim.measure).values())
    if len(ours) < LEAST:
        return Verdict(claim, "fewer than two seeds have a value that may be quoted", "undecided")
    low, high = prediction(ours)
    rounding = claim.rounding + _HALF_A_SLAB * all(one == round(one) for one in ours)
    inside = low - rounding <= value <= high + rounding
    found = f"{np.mean(ours):.4g} ± {np.std(ours, ddof=1):.2g}; one more run: {low:.4g} to {high:.4g}"
    return Verdict(claim, found, "agrees" if inside else "differs")


def _form(claim: Claim, variant: Variant) -> Verdict:
    found = [survey(variant.run_folder(one)).landform.name for one in _finished(variant)]
    fits = [(name in claim.forms) != claim.none for name in found]
    told = ", ".join(f"{name} in {found.count(name)}" for name in dict.fromkeys(found))
    result: Result = "agrees" if all(fits) else "undecided" if any(fits) else "differs"
    return Verdict(claim, f"{told} of {counted(len(found), 'seed')}", result)


def _finished(variant: Variant) -> list:
    return [member for member in variant.members if member.seed in variant.reports]


def _end(claim: Claim, step: int, variant: Variant) -> Verdict:
    ends = [report.steps for report in variant.reports.values()]
    found = ", ".join(f"{end}" for end in ends)
    same = [end == step for end in ends]
    result: Result = "agrees" if all(same) else "undecided" if any(same) else "differs"
    return Verdict(claim, f"the runs end at step {found}", result)


def _order(claim: Claim, cases: Mapping[str, Variant]) -> Verdict:
    """A measure against another one or another case, by the paired t-test over seeds."""
    measure, other = claim.measure, claim.than_measure or claim.measure
    ours = cases[claim.case].finals(measure)
    theirs = cases[claim.than_case or claim.case].finals(other)
    test = paired_difference(measure, claim.case, claim.than_case or claim.case, ours, theirs)
    if test.count < LEAST:
        return Verdict(claim, "fewer than two seeds have values that may be quoted", "undecided")
    found = f"{_mean(ours):.4g} against {_mean(theirs):.4g}, difference {test.low:.3g} to {test.high:.3g}"
    if claim.within is not None or claim.share is not None:
        allowed = claim.within if claim.within is not None else (claim.share or 0.0) * _mean(theirs)
        return Verdict(claim, found, _alike(test.low, test.high, allowed))
    decided = math.isnan(test.p) or test.p < SIGNIFICANT
    if not decided or test.mean == 0.0:
        return Verdict(claim, found, "undecided")
    return Verdict(claim, found, "agrees" if test.mean > 0 else "differs")


def _alike(low: float, high: float, allowed: float) -> Result:
    if -allowed <= low and high <= allowed:
        return "agrees"
    return "differs" if low > allowed or high < -allowed else "undecided"


def _mean(values: Mapping[int, float]) -> float:
    return float(np.mean(list(values.values())))
