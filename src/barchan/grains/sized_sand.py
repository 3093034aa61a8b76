"""Sand of several sizes on the bed: parcels of each size class in the active layer and in the substrate."""

from itertools import accumulate
from typing import Any

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Bed
from barchan.fields import SAND, LayerInfo
from barchan.grains.sizes import SizeClass, mean_diameter
from barchan.kernels.bed.state import ActiveLayer
from barchan.model import Derived, ModelMeasure
from barchan.streams import Stream


class SizedSand:
    """Parcels of each size class in the active layer of every cell and in the substrate, as fields."""

    def __init__(self, classes: list[SizeClass], capacity: int) -> None:
        """Take the size classes, and the number of parcels that the active layer of a cell holds."""
        self.classes, self.capacity = classes, capacity
        self.diameters = np.array([one.diameter for one in classes])
        self.shares = np.array(list(accumulate(one.share for one in classes)))
        self.left = np.zeros(len(classes), np.int64)
        """Parcels of each class that left the field, less those that were painted in."""
        self.surface = [_field("surface", at, one, True) for at, one in enumerate(classes, start=1)]
        self.substrate = [_field("substrate", at, one, False) for at, one in enumerate(classes, start=1)]

    def initialise(self, bed: Bed, seed: int) -> None:
        """Give the sand of a bed its sizes, with the same shares in layer and substrate."""
        top = np.minimum(bed.sand, self.capacity)
        stream = Stream(seed, "sizes")
        for number, (fields, sand) in enumerate(((self.surface, top), (self.substrate, bed.sand - top))):
            part = (stream.draws(number, sand.size) >> np.uint64(11)).reshape(sand.shape) * 2.0**-53
            for field, parcels in zip(fields, split(sand, self.shares, part), strict=True):
                bed.add(field, parcels)

    def active_layer(self, bed: Bed) -> ActiveLayer:
        """The fields as kernels take them, copied, and brought up to date with sand that was painted."""
        from barchan.kernels.bed.active_layer import follow

        surface = np.stack([bed.arrays[field.name].reshape(-1) for field in self.surface])
        if self.substrate[0].name in bed.arrays:
            substrate = np.stack([bed.arrays[field.name].reshape(-1) for field in self.substrate])
        else:  # frames carry the active layer only
            rest = bed.sand.reshape(-1) - surface.sum(axis=0, dtype=np.int32)
            substrate = np.stack(split(rest, self.shares, np.full(rest.size, 0.5))).astype(np.int32)
        found = ActiveLayer(surface, substrate, self.capacity, np.zeros(1, np.uint64))
        reseed(found, bed.units)
        entered = np.zeros(len(self.classes), np.int64)
        follow(found, bed.sand.reshape(-1), self.shares, entered)
        self.left -= entered
        return found

    def store(self, bed: Bed, layer: ActiveLayer) -> None:
        """Put an active layer and its substrate back into the fields."""
        for fields, counts in ((self.surface, layer.surface), (self.substrate, layer.substrate)):
            for field, parcels in zip(fields, counts, strict=True):
                bed.arrays[field.name].reshape(-1)[...] = parcels

    def on_bed(self, bed: Bed) -> NDArray[np.int64]:
        """Parcels of each class on the bed."""
        pairs = zip(self.surface, self.substrate, strict=True)
        return np.array(
            [sum(int(bed.arrays[field.name].sum(dtype=np.int64)) for field in pair) for pair in pairs]
        )

    def surface_diameter(self, bed: Bed) -> NDArray[np.float64]:
        """Mean diameter (m) in the active layer; that of all sand where there is none."""
        counts = np.stack([bed.arrays[field.name] for field in self.surface]).astype(np.float64)
        total = counts.sum(axis=0)
        mean = np.tensordot(self.diameters, counts, 1) / np.maximum(total, 1.0)
        return np.where(total > 0, mean, mean_diameter(self.classes))


def reseed(layer: ActiveLayer, key: int) -> None:
    """Restart the random sequence of sizes under a key."""
    from barchan.kernels.bed import active_layer as kernel

    kernel.reseed(layer, np.uint64(key))


def split(
    sand: NDArray[np.int32], shares: NDArray[np.float64], part: NDArray[np.float64]
) -> list[NDArray[np.int64]]:
    """Whole parcels of each class in sand with running ``shares``, whose mean over ``part`` is exact.

    ``part`` is a number from 0 to below 1 for each cell.
    """
    sums = [np.floor(share * sand + part).astype(np.int64) for share in shares[:-1]]
    sums.append(sand.astype(np.int64))
    return [after - before for before, after in zip([np.zeros_like(sums[0]), *sums[:-1]], sums, strict=True)]


def surface_diameter(model: Any, bed: Bed) -> NDArray[np.float64]:
    """Mean diameter (m) of the grains at the surface of a model of grains."""
    if model.sized_sand is None:
        return np.full(bed.sand.shape, model.parameters.diameter)
    return np.asarray(model.sized_sand.surface_diameter(bed))


def coarse_crests(model: Any, bed: Bed) -> float:
    """Mean diameter at the surface of the upper third of the bed over that of the lower third."""
    low, high = np.quantile(bed.elevation, (1 / 3, 2 / 3))
    diameter = surface_diameter(model, bed)
    return float(diameter[bed.elevation >= high].mean() / diameter[bed.elevation <= low].mean())


SURFACE_DIAMETER = Derived(
    "surface_diameter",
    "m",
    "mean diameter of the grains at the surface",
    lambda model, bed, _: surface_diameter(model, bed),
    least=0.0,
)

COARSE_CRESTS = ModelMeasure(
    "coarse_crests",
    "grain diameter, crests over troughs",
    "-",
    lambda model, bed, _: coarse_crests(model, bed),
)


def _field(name: str, at: int, size: SizeClass, in_frames: bool) -> LayerInfo:
    where = "in the active layer" if in_frames else "below the active layer"
    grains = f"grains of {size.diameter * 1e3:.3g} mm"
    return LayerInfo(
        f"{name}_{at}",
        "int32",
        SAND.unit,
        f"parcels of {grains} {where}",
        in_frames,
        part_of=SAND.name,
        class_value=size.diameter,
        class_unit="m",
    )
