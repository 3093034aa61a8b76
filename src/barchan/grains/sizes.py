"""Sand of several sizes: the size classes of a scenario."""

from collections.abc import Sequence
from itertools import pairwise
from statistics import NormalDist
from typing import TYPE_CHECKING, ClassVar

from pydantic_core import InitErrorDetails

from barchan.grains.closure import Closure
from barchan.parameters import GIVEN, Parameters, mistake, parameter

if TYPE_CHECKING:
    from barchan.grains.parameters import GrainFlight

MOST = 4
"""Size classes at most."""

FINEST, COARSEST = 0.05e-3, 5e-3
"""Diameters (m) of grains within which models of their flight hold."""

_ROUNDING = 1e-6
"""Largest difference of the sum of shares from 1."""


class SizeClass(Parameters):
    """Grains of one size, and their share of the sand."""

    diameter: float = parameter(
        unit="m",
        ge=FINEST,
        le=COARSEST,
        meaning="Diameter of the grains.",
        source="Szabó 2019, §2: grains of 0.05 to 2 mm move along the ground",
    )
    share: float = parameter(
        unit="-",
        gt=0,
        le=1,
        meaning="Share of the sand's volume; the shares of all classes sum to 1.",
        source="ours: as a sieve gives it",
    )


class Sizes(Closure):
    """Sand of several sizes, in an active layer of each cell and below it."""

    key: ClassVar[str] = "sizes"

    classes: list[SizeClass] = parameter(
        list,
        unit="-",
        max_length=MOST,
        meaning="Sand of several sizes, finest first, instead of grain_diameter; none: sand of one size.",
        source="Prague thesis, §7.1",
    )
    spread: float | None = parameter(
        None,
        unit="-",
        gt=1,
        le=3,
        meaning="Geometric standard deviation of diameters that are distributed lognormally by volume about "
        "grain_diameter, their median, instead of classes; sand of one size where not given.",
        source="Folk & Ward 1957: well sorted sand 1.27 to 1.41",
    )
    spread_classes: int = parameter(
        3,
        unit="-",
        ge=2,
        le=MOST,
        acts_with={"spread": GIVEN},
        meaning="Number of classes of equal volume that such sand is split into.",
        source="ours",
    )
    active_layer: float = parameter(
        2.0,
        unit="grain diameters",
        gt=0,
        le=100,
        meaning="Thickness of the layer that impacts reach in sand of several sizes, in mean diameters.",
        source="Hirano 1971 for the layer; its thickness is ours: two layers of grains",
    )

    def of(self, median: float) -> list[SizeClass]:
        """The size classes, finest first, as stated or spread about a ``median`` diameter (m)."""
        return self.classes if self.spread is None else lognormal(median, self.spread, self.spread_classes)

    def mistakes(self, rules: "GrainFlight") -> list[InitErrorDetails]:
        """Mistakes in the classes, and in the spread."""
        found = _class_mistakes(self.classes)
        if self.spread is None:
            return found
        if self.classes:
            text = f"is {self.spread:g}, and classes are given too; leave one of them out"
            return [*found, mistake(("spread",), text)]
        finest, *_, coarsest = (one.diameter for one in self.of(rules.grain_diameter))
        if finest < FINEST or coarsest > COARSEST:
            text = f"is {self.spread:g}, which makes grains of {finest:.3g} to {coarsest:.3g} m about "
            text += f"grain_diameter; allowed: {FINEST:g} to {COARSEST:g} m"
            found.append(mistake(("spread",), text))
        return found


def _class_mistakes(classes: list[SizeClass]) -> list[InitErrorDetails]:
    """Mistakes in classes beside one another."""
    found = []
    for at in range(1, len(classes)):
        before, here = classes[at - 1].diameter, classes[at].diameter
        if here <= before:
            text = f"is {here:g} m after {before:g} m; allowed: diameters that increase"
            found.append(mistake(("classes", at, "diameter"), text))
    total = sum(one.share for one in classes)
    if classes and abs(total - 1.0) > _ROUNDING:
        found.append(mistake(("classes",), f"have shares that sum to {total:g}; allowed: a sum of 1"))
    return found


def lognormal(median: float, spread: float, count: int) -> list[SizeClass]:
    """Classes of equal volume of sand whose diameters (m) are spread lognormally by volume.

    ``spread`` is the geometric standard deviation. A class has the geometric mean of its part's diameters:
    over a part of a normal distribution the mean is the difference of the density at its ends over its share.
    """
    normal, share = NormalDist(), 1.0 / count
    ends = [0.0, *(normal.pdf(normal.inv_cdf(at * share)) for at in range(1, count)), 0.0]
    means = ((below - above) / share for below, above in pairwise(ends))
    return [SizeClass.model_construct(diameter=median * spread**mean, share=share) for mean in means]


def mean_diameter(sizes: Sequence[SizeClass]) -> float:
    """Mean diameter (m), by volume."""
    return sum(one.share * one.diameter for one in sizes)
