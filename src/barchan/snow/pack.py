"""The snow pack between the bed's fields and the arrays that kernels work on."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Bed
from barchan.fields import HEIGHT_UNIT, FieldInfo, LayerInfo
from barchan.kernels.core.state import SIMD_WIDTH
from barchan.kernels.snow.state import Pack, quanta_of
from barchan.lattice import Lattice
from barchan.slabs.arguments import SlabArguments, build
from barchan.slabs.parameters import ActingRules
from barchan.slabs.rules import Rules
from barchan.snow.parameters import SnowParameters
from barchan.wind.frame import WindFrame

SNOW, HEIGHT, TOP, STRESS, EPOCH = "snow", "snow_height", "snow_top", "snow_stress", "snow_epoch"
"""Names of the fields of snow on the bed."""


def layer_of(parameters: SnowParameters) -> LayerInfo:
    """The declaration of the snow on a cell."""
    meaning = f"quanta of snow, {parameters.quantum:g} kg/m² each"
    return LayerInfo(SNOW, "int32", "quanta", meaning, mass=parameters.quantum, height_field=HEIGHT)


def buried_name(number: int) -> str:
    """The name of the field of a buried layer, the deepest being 1."""
    return f"snow_layer_{number}"


def fields_of(parameters: SnowParameters) -> tuple[FieldInfo, ...]:
    """The declarations of the fields of snow."""
    packed = "quanta, epoch and density, in 20, 24 and 16 bits"
    return (
        FieldInfo(TOP, "int64", "-", f"uppermost layer of snow: {packed}", coded=True),
        FieldInfo(
            EPOCH, "int32", "600 s at -10 °C", "present epoch of bonding, the same everywhere", coded=True
        ),
        FieldInfo(
            STRESS,
            "float32",
            "1",
            "shear stress over that on flat snow, as the drift last felt it",
            centre=1.0,
        ),
        *(
            FieldInfo(
                buried_name(k + 1),
                "int64",
                "-",
                f"buried layer {k + 1} from the ground: {packed}",
                coded=True,
            )
            for k in range(parameters.layers)
        ),
    )


def entered(bed: Bed, parameters: SnowParameters, frame: WindFrame) -> tuple[Pack, NDArray[np.int32]]:
    """The pack of a bed in the wind's frame, and the ground (µm over its lowest) under it."""
    ground = frame.enter(np.rint((bed.ground - bed.ground.min()) / HEIGHT_UNIT).astype(np.int32))
    ground = np.ascontiguousarray(ground).ravel()
    buried = np.zeros((ground.size, parameters.layers), np.int64)
    for k in range(parameters.layers):
        buried[:, k] = frame.enter(bed.arrays[buried_name(k + 1)]).ravel()
    top, height = _flat(bed.arrays[TOP], frame), _flat(bed.arrays[HEIGHT], frame)
    buffer = np.zeros(SIMD_WIDTH + ground.size, np.int32)
    buffer[SIMD_WIDTH:] = ground + height
    count = (buried != 0).sum(axis=1).astype(np.uint8)
    counted = quanta_of(top) + quanta_of(buried).sum(axis=1)
    return Pack(buffer[SIMD_WIDTH:], counted.astype(np.int32), top, buried, count), ground


@dataclass
class Field:
    """The pack in a wind's frame, and what it takes to write it back."""

    pack: Pack
    ground: NDArray[np.int32]
    frame: WindFrame
    arguments: SlabArguments


ACTING = ActingRules("centre", "wind")
"""Of the rules that slabs have several of those that snow has, whatever the winds."""


def field_of(bed: Bed, parameters: SnowParameters, lattice: Lattice, frame: WindFrame) -> Field:
    """The pack of a bed in the wind's frame, with the rules that it shares with slabs."""
    pack, ground = entered(bed, parameters, frame)
    fine = lattice.model_copy(update={"slab_aspect": None, "slab_height": HEIGHT_UNIT})
    hop = parameters.hop / lattice.cell_size
    arguments = build(parameters.as_slabs(lattice), Rules(), fine, frame, hop, True, ACTING)
    return Field(pack, ground, frame, arguments)


def leave(bed: Bed, pack: Pack, ground: NDArray[np.int32], frame: WindFrame, epoch: int) -> None:
    """Write the pack and the present epoch back to the bed."""
    bed.arrays[EPOCH][...] = epoch
    shape = frame.enter(bed.ground).shape
    beyond = np.arange(pack.buried.shape[1]) >= pack.buried_count[:, None]
    pack.buried[beyond] = 0
    bed.arrays[SNOW][...] = frame.leave(pack.quanta.reshape(shape))
    bed.arrays[TOP][...] = frame.leave(pack.top.reshape(shape))
    bed.arrays[HEIGHT][...] = frame.leave((pack.surface - ground).reshape(shape))
    for k in range(pack.buried.shape[1]):
        layer = np.ascontiguousarray(pack.buried[:, k])
        bed.arrays[buried_name(k + 1)][...] = frame.leave(layer.reshape(shape))


def _flat(field: NDArray, frame: WindFrame) -> NDArray:
    return np.ascontiguousarray(frame.enter(field)).ravel().copy()
