"""Sand of several sizes: the classes of a scenario, and where on the bed the parcels of each lie."""

from itertools import accumulate, pairwise
from statistics import NormalDist
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pydantic_core import InitErrorDetails, PydanticCustomError

from barchan.bed import Bed
from barchan.fields import FieldInfo
from barchan.kernels.bed.state import Mixture
from barchan.parameters import Parameters, parameter
from barchan.streams import Stream

MOST = 4
"""Classes at most."""

FINEST, COARSEST = 0.05e-3, 5e-3
"""Diameters (m) of grains within which models of their flight hold."""

_ROUNDING = 1e-6
"""What the sum of shares may miss 1 by."""


class SizeClass(Parameters):
    """Grains of one size, and how much of the sand they are."""

    diameter: float = parameter(
        unit="m",
        ge=FINEST,
        le=COARSEST,
        meaning="Diameter of the grains.",
        source="seed 003, §2: grains of 0.05 to 2 mm move along the ground",
    )
    share: float = parameter(
        unit="-",
        gt=0,
        le=1,
        meaning="Share of the sand's volume; those of all classes sum to 1.",
        source="ours: as a sieve gives it",
    )


def mistakes(sizes: list[SizeClass]) -> list[InitErrorDetails]:
    """What is wrong with classes, one beside the other."""
    found = []
    for at in range(1, len(sizes)):
        before, here = sizes[at - 1].diameter, sizes[at].diameter
        if here <= before:
            text = f"is {here:g} m after {before:g} m; allowed: diameters that increase"
            found.append(_mistake(("sizes", at, "diameter"), text))
    total = sum(one.share for one in sizes)
    if sizes and abs(total - 1.0) > _ROUNDING:
        found.append(_mistake(("sizes",), f"have shares that sum to {total:g}; allowed: a sum of 1"))
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


def spread_mistakes(
    spread: float | None, classes: list[SizeClass], sizes: list[SizeClass]
) -> list[InitErrorDetails]:
    """What is wrong with a ``spread`` of diameters that comes to these ``classes``, and with stated sizes."""
    if spread is None:
        return []
    if sizes:
        return [_mistake(("size_spread",), f"is {spread:g}, and sizes are given too; leave one of them out")]
    finest, coarsest = classes[0].diameter, classes[-1].diameter
    if finest >= FINEST and coarsest <= COARSEST:
        return []
    text = f"is {spread:g}, which makes grains of {finest:.3g} to {coarsest:.3g} m about grain_diameter; "
    return [_mistake(("size_spread",), f"{text}allowed: {FINEST:g} to {COARSEST:g} m")]


def _mistake(place: tuple[str | int, ...], message: str) -> InitErrorDetails:
    error = PydanticCustomError("value_error", "{error}", {"error": message})
    return InitErrorDetails(type=error, loc=place, input=None)


class SortedSand:
    """The parcels of each size in the active layer of every cell and below it, as fields of the bed."""

    def __init__(self, sizes: list[SizeClass], layer: int) -> None:
        """Take the classes of a scenario and how many parcels the active layer holds."""
        self.sizes, self.full = sizes, layer
        self.diameters = np.array([one.diameter for one in sizes])
        self.shares = np.array(list(accumulate(one.share for one in sizes)))
        self.left = np.zeros(len(sizes), np.int64)
        """Parcels of each size that left the field, less those that were painted in."""
        self.layer = [_field("layer", at, one, True) for at, one in enumerate(sizes, start=1)]
        self.below = [_field("below", at, one, False) for at, one in enumerate(sizes, start=1)]

    def lay(self, bed: Bed, seed: int) -> None:
        """Give the sand of a bed its sizes, layer and below alike but for whole parcels."""
        top = np.minimum(bed.sand, self.full)
        stream = Stream(seed, "sizes")
        for number, (fields, sand) in enumerate(((self.layer, top), (self.below, bed.sand - top))):
            part = (stream.draws(number, sand.size) >> np.uint64(11)).reshape(sand.shape) * 2.0**-53
            for field, parcels in zip(fields, mixed(sand, self.shares, part), strict=True):
                bed.add(field, parcels)

    def mixture(self, bed: Bed) -> Any:
        """The fields as kernels take them, copied, and brought up to date with sand that was painted."""
        from barchan.kernels.bed.active_layer import follow

        layer = np.stack([bed.arrays[field.name].reshape(-1) for field in self.layer])
        if self.below[0].name in bed.arrays:
            below = np.stack([bed.arrays[field.name].reshape(-1) for field in self.below])
        else:  # a frame tells of the layer only
            rest = bed.sand.reshape(-1) - layer.sum(axis=0, dtype=np.int32)
            below = np.stack(mixed(rest, self.shares, np.full(rest.size, 0.5))).astype(np.int32)
        found = Mixture(layer, below, self.full, np.zeros(1, np.uint64))
        shuffle_anew(found, bed.units)
        entered = np.zeros(len(self.sizes), np.int64)
        follow(found, bed.sand.reshape(-1), self.shares, entered)
        self.left -= entered
        return found

    def store(self, bed: Bed, mixture: Any) -> None:
        """Put a mixture back into the fields."""
        for fields, counts in ((self.layer, mixture.layer), (self.below, mixture.deep)):
            for field, parcels in zip(fields, counts, strict=True):
                bed.arrays[field.name].reshape(-1)[...] = parcels

    def on_bed(self, bed: Bed) -> NDArray[np.int64]:
        """Parcels of each size on the bed."""
        return np.array(
            [
                sum(int(bed.arrays[field.name].sum(dtype=np.int64)) for field in pair)
                for pair in zip(self.layer, self.below, strict=True)
            ]
        )

    def surface(self, bed: Bed) -> NDArray[np.float64]:
        """Mean diameter (m) in the active layer; that of all sand where there is none."""
        counts = np.stack([bed.arrays[field.name] for field in self.layer]).astype(np.float64)
        total = counts.sum(axis=0)
        mean = np.tensordot(self.diameters, counts, 1) / np.maximum(total, 1.0)
        return np.where(total > 0, mean, mean_diameter(self.sizes))


def shuffle_anew(mixture: Any, key: int) -> None:
    """Start the draws of sizes anew under a key."""
    from barchan.kernels.bed import active_layer as kernel

    kernel.shuffle_anew(mixture, np.uint64(key))


def mixed(
    sand: NDArray[np.int32], shares: NDArray[np.float64], part: NDArray[np.float64]
) -> list[NDArray[np.int64]]:
    """Whole parcels of each size in sand with running ``shares``, whose mean over ``part`` is exact.

    ``part`` is a number from 0 to below 1 for each cell.
    """
    sums = [np.floor(share * sand + part).astype(np.int64) for share in shares[:-1]]
    sums.append(sand.astype(np.int64))
    return [after - before for before, after in zip([np.zeros_like(sums[0]), *sums[:-1]], sums, strict=True)]


def mean_diameter(sizes: list[SizeClass]) -> float:
    """Mean diameter (m), by volume."""
    return sum(one.share * one.diameter for one in sizes)


def _field(name: str, at: int, size: SizeClass, in_frames: bool) -> FieldInfo:
    where = "in the active layer" if in_frames else "below the active layer"
    grains = f"grains of {size.diameter * 1e3:.3g} mm"
    return FieldInfo(f"{name}_{at}", "int32", "slabs", f"parcels of {grains} {where}", in_frames)
