"""Designs: which combinations of the axes' values an ensemble has."""

from collections.abc import Sequence
from itertools import product
from typing import Any, Literal, get_args

import numpy as np

from barchan.ensembles.axes import Axis
from barchan.errors import BarchanError

Design = Literal["grid", "zip", "latin", "sobol"]

DESIGNS: tuple[str, ...] = get_args(Design)

DRAWN = ("latin", "sobol")
"""Designs whose points are drawn from intervals, with their number."""

Point = tuple[Any, ...]
"""A value for each axis."""

MOST_POINTS = 100_000


def points_of(
    axes: Sequence[Axis], design: Design, count: int | None = None, whole: Sequence[bool] = (), seed: int = 0
) -> list[Point]:
    """The points of a design, each a value for each axis; the single point () without axes.

    ``grid`` has every combination, ``zip`` the first values together, then the second, and so on; ``latin``
    and ``sobol`` spread ``count`` points evenly over the axes' intervals, drawn from ``seed``, rounded where
    ``whole`` says so (McKay et al. 1979; Sobol' 1967). Raises BarchanError where axes and design do not fit.
    """
    if design in DRAWN:
        return _drawn(axes, design, count, whole or [False] * len(axes), seed)
    if count is not None:
        raise BarchanError(f"--points {count}: the design {design} has as many points as its axes give")
    if design == "zip":
        lengths = {axis.key: len(axis.values) for axis in axes}
        if len(set(lengths.values())) > 1:
            told = ", ".join(f"{key} has {length}" for key, length in lengths.items())
            raise BarchanError(f"the design zip needs as many values on every axis; {told}")
        return list(zip(*(axis.values for axis in axes), strict=True)) if axes else [()]
    total = int(np.prod([float(len(axis.values)) for axis in axes]))
    if total > MOST_POINTS:
        raise BarchanError(f"the grid has {total:,} points; allowed: up to {MOST_POINTS:,}")
    return list(product(*(axis.values for axis in axes)))


def _drawn(
    axes: Sequence[Axis], design: str, count: int | None, whole: Sequence[bool], seed: int
) -> list[Point]:
    from scipy.stats import qmc

    if not axes or any(not axis.spacing for axis in axes):
        wrong = ", ".join(axis.key for axis in axes if not axis.spacing) or "no axis"
        raise BarchanError(
            f"the design {design} draws from intervals; allowed: KEY=lin(FROM,TO) or KEY=log(FROM,TO), "
            f"not {wrong}"
        )
    if count is None or not 1 <= count <= MOST_POINTS:
        raise BarchanError(f"the design {design} needs --points NUMBER, from 1 to {MOST_POINTS:,}")
    if design == "latin":
        shares = qmc.LatinHypercube(len(axes), rng=np.random.default_rng(seed)).random(count)
    else:
        power = max(int(np.ceil(np.log2(count))), 0)
        shares = qmc.Sobol(len(axes), rng=np.random.default_rng(seed)).random_base2(power)[:count]
    return [
        tuple(
            round(axis.at(share)) if rounded else float(f"{axis.at(share):.9g}")
            for axis, rounded, share in zip(axes, whole, row, strict=True)
        )
        for row in shares
    ]
