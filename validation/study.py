"""Shared by the studies: runs over several seeds, and rows that compare them with published values."""

import itertools
import statistics
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from multiprocessing import get_context
from typing import Any

import numpy as np

import barchan
from barchan.analysis.time_series import last_measures

SEEDS = tuple(range(1, 6))


@dataclass(frozen=True)
class Row:
    """One line of a study's table."""

    what: str
    published: str
    found: str
    verdict: str = ""


Values = Sequence[float]


def over_seeds(
    measure: Callable[..., dict[str, float]], cases: Iterable[tuple[Any, ...]], seeds: Sequence[int] = SEEDS
) -> list[dict[str, list[float]]]:
    """For each case the measures of every seed, by name: ``measure(*case, seed)`` in processes of its own."""
    cases = list(cases)
    calls = [(*case, seed) for case, seed in itertools.product(cases, seeds)]
    with ProcessPoolExecutor(mp_context=get_context("spawn")) as pool:
        results = list(pool.map(measure, *zip(*calls, strict=True)))
    groups = [results[at : at + len(seeds)] for at in range(0, len(results), len(seeds))]
    return [{name: [result[name] for result in group] for name in group[0]} for group in groups]


def measures_after(scenario: str, changes: dict[str, Any], seed: int) -> dict[str, float]:
    """The measures of the last frame of a preset's run with some values changed (``a__b`` for a.b)."""
    asked = barchan.load(scenario, run__seed=seed, **changes)
    return last_measures(barchan.simulate(asked), asked)


def spread(values: Values, digits: int = 3) -> str:
    """Mean and standard deviation of several runs."""
    if not np.isfinite(values).all():
        return "not defined in every run"
    mean, deviation = np.mean(values), np.std(values, ddof=1)
    rounded = float(f"{mean:.{digits}g}")  # 100, not 1e+02
    return f"{rounded:g} ± {deviation:.2g}"


def number(what: str, published: float, values: Values, unit: str = "", note: str = "one run") -> Row:
    """A published number beside ours; it agrees when it lies within two standard deviations of our runs."""
    mean, deviation = statistics.fmean(values), statistics.stdev(values)
    agrees = abs(published - mean) <= 2 * deviation
    return Row(
        what,
        f"{published:g} {unit} ({note})".replace("  ", " "),
        f"{spread(values)} {unit}".strip(),
        "agrees" if agrees else f"differs by {(mean - published) / published:+.0%}",
    )


def order(what: str, published: str, larger: Values, smaller: Values, unit: str = "") -> Row:
    """A published order of two sets of runs with the same seeds; each seed votes."""
    votes = sum(a > b for a, b in zip(larger, smaller, strict=True))
    found = f"{spread(larger)} against {spread(smaller)} {unit}".strip()
    return Row(what, published, found, f"{votes} of {len(larger)} seeds")


def table(rows: Iterable[Row]) -> str:
    """The rows as a Markdown table."""
    lines = ["| what | published | found | comes out |", "|---|---|---|---|"]
    lines += [f"| {row.what} | {row.published} | {row.found} | {row.verdict} |" for row in rows]
    return "\n".join(lines)
