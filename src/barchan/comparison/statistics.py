"""Measures of variants over seeds: spread, and differences paired by seed."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from barchan.analysis.declared_measures import MEASURES, PER_YEAR
from barchan.comparison.variants import Variant, shared_measures

TURNS = {"crest_azimuth": 180.0, "migration_direction": 360.0, "resultant_wind": 360.0}
"""Degrees after which a measured direction repeats itself."""

SAME = frozenset(measure.name for measure in (*MEASURES, *PER_YEAR) if measure.row)
"""Measures that are others in another unit; tested once they count once."""

CONFIDENCE = 0.95

SIGNIFICANT = 0.05
"""Probability, after Holm's correction, below which a difference is called one."""

LEAST = 2
"""Seeds that a test needs."""


@dataclass(frozen=True)
class Spread:
    """Mean and standard deviation over seeds; NaN where there is none."""

    mean: float
    deviation: float
    count: int
    """Seeds whose value may be quoted."""

    def __repr__(self) -> str:
        return f"<Spread {self.mean:.4g} ± {self.deviation:.2g} of {self.count}>"


@dataclass(frozen=True)
class Difference:
    """A variant's measure less the reference's, paired by seed."""

    measure: str
    variant: str
    reference: str
    mean: float
    low: float
    high: float
    """Ends of the 95 % confidence interval of the mean (Student's t)."""
    p: float
    """Two-sided probability of the paired t-test; NaN where there is no test."""
    count: int
    """Pairs."""
    adjusted: float = math.nan
    """The probability after Holm's correction for all tests of the table."""

    @property
    def significant(self) -> bool:
        """Whether the difference stands after correction."""
        return self.adjusted < SIGNIFICANT


def spread(values: Sequence[float], turn: float | None = None) -> Spread:
    """Mean and sample standard deviation; of directions that repeat after ``turn`` about their mean."""
    known = np.asarray([value for value in values if math.isfinite(value)], float)
    if not known.size:
        return Spread(math.nan, math.nan, 0)
    if turn is not None:
        middle = _mean_direction(known, turn)
        apart = _wrapped(known - middle, turn)
        mean = float((middle + apart.mean()) % turn)
        known = apart
    else:
        mean = float(known.mean())
    deviation = float(known.std(ddof=1)) if known.size > 1 else math.nan
    return Spread(mean, deviation, int(known.size))


def _mean_direction(angles: NDArray[np.float64], turn: float) -> float:
    around = np.exp(2j * np.pi * angles / turn).sum()
    return float(np.angle(around) / (2 * np.pi) * turn % turn)


def _wrapped(angles: NDArray[np.float64], turn: float) -> NDArray[np.float64]:
    return (angles + turn / 2) % turn - turn / 2


def paired_difference(
    measure: str, variant: str, reference: str, ours: Mapping[int, float], theirs: Mapping[int, float]
) -> Difference:
    """The difference of a measure between two variants, by values of each seed that both have."""
    from scipy import stats

    seeds = sorted(set(ours) & set(theirs))
    apart = np.array([ours[seed] - theirs[seed] for seed in seeds])
    if measure in TURNS:
        apart = _wrapped(apart, TURNS[measure])
    count = len(seeds)
    mean = float(apart.mean()) if count else math.nan
    if count < LEAST:
        return Difference(measure, variant, reference, mean, math.nan, math.nan, math.nan, count)
    error = float(apart.std(ddof=1)) / math.sqrt(count)
    if error <= 1e-12 * max(abs(mean), 1e-300):  # the same in each seed: t has no meaning
        return Difference(measure, variant, reference, mean, mean, mean, math.nan, count)
    reach = float(stats.t.ppf((1 + CONFIDENCE) / 2, count - 1)) * error
    p = float(2 * stats.t.sf(abs(mean / error), count - 1))
    return Difference(measure, variant, reference, mean, mean - reach, mean + reach, p, count)


def differences(variants: Sequence[Variant]) -> list[Difference]:
    """All measures of all variants against the first, with Holm's correction over all tests."""
    reference, *others = variants
    found = [
        paired_difference(name, other.label, reference.label, other.finals(name), reference.finals(name))
        for name in shared_measures(variants)
        if name not in SAME
        for other in others
    ]
    adjusted = holm([one.p for one in found])
    return [Difference(**{**vars(one), "adjusted": p}) for one, p in zip(found, adjusted, strict=True)]


def holm(probabilities: Sequence[float]) -> list[float]:
    """Probabilities after the correction of Holm (1979) for many tests; NaN stay, and count for nothing."""
    tested = sorted((p, k) for k, p in enumerate(probabilities) if math.isfinite(p))
    adjusted = [math.nan] * len(probabilities)
    least = 0.0
    for rank, (p, k) in enumerate(tested):
        least = max(least, min(1.0, (len(tested) - rank) * p))
        adjusted[k] = least
    return adjusted
