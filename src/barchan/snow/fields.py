"""Fields that show the snow of a bed: density, age, what wind it withstands, and how much of it is loose."""

from collections.abc import Callable, Iterator
from functools import partial

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Bed
from barchan.fields import HEIGHT_UNIT
from barchan.kernels.snow.state import ONE_QUANTUM, density_of, epoch_of, quanta_of
from barchan.model import Derived, Strata
from barchan.snow.conditions import EPOCH_SECONDS, Conditions, thickness_of
from barchan.snow.pack import EPOCH, HEIGHT, SNOW, TOP, buried_name
from barchan.snow.parameters import SnowParameters

Field = NDArray[np.float64]


def layers_of(bed: Bed) -> Iterator[NDArray[np.int64]]:
    """The packed layers of all cells, the uppermost first; 0 where a cell has no such layer."""
    yield bed.arrays[TOP]
    number = 1
    names = []
    while buried_name(number) in bed.arrays:
        names.append(buried_name(number))
        number += 1
    for name in reversed(names):
        yield bed.arrays[name]


def surface_density(bed: Bed) -> Field:
    """Density (kg/m³) of the uppermost layer; 0 on bare ground."""
    return _where_snow(bed, density_of(bed.arrays[TOP]))


def surface_age(bed: Bed) -> Field:
    """Age (h at -10 °C) of the bonds of the uppermost layer; 0 on bare ground."""
    return _where_snow(bed, age_of(bed, bed.arrays[TOP]))


def age_of(bed: Bed, words: NDArray[np.int64]) -> Field:
    """Age (h at -10 °C) of the bonds of packed layers of a bed."""
    epochs = bed.arrays[EPOCH].astype(np.int64) - epoch_of(words)
    return np.maximum(epochs, 0) * (EPOCH_SECONDS / 3600.0)


def threshold_wind(bed: Bed, now: Conditions) -> Field:
    """Wind (m/s at 10 m) above which the uppermost layer gives snow; 0 on bare ground."""
    stress = now.threshold(density_of(bed.arrays[TOP]), age_of(bed, bed.arrays[TOP]))
    ustar = np.sqrt(stress / now.parameters.air_density)
    return _where_snow(bed, now.parameters.drift.speed_of(ustar))


def loose_depth(bed: Bed, parameters: SnowParameters) -> Field:
    """Thickness (m) of the snow that has not bonded, down to the first bonded layer."""
    depth = np.zeros(bed.lattice.shape)
    above = np.ones(bed.lattice.shape, np.bool_)
    for words in layers_of(bed):
        held = words >= ONE_QUANTUM
        above &= ~(held & bonded(bed, words, parameters))
        depth += np.where(above & held, _thickness(words, parameters), 0.0)
    return depth


def mean_density(bed: Bed, quantum: float) -> Field:
    """Mass over thickness (kg/m³) of all snow on a cell; 0 on bare ground."""
    height = bed.arrays[HEIGHT] * HEIGHT_UNIT
    mass = bed.arrays[SNOW] * quantum
    return np.divide(mass, height, out=np.zeros(height.shape), where=height > 0.0)


def _thickness(words: NDArray[np.int64], parameters: SnowParameters) -> Field:
    """Thickness (m) of packed layers."""
    return thickness_of(words, parameters.quantum).astype(np.float64) * HEIGHT_UNIT


def _where_snow(bed: Bed, field: Field) -> Field:
    return np.where(bed.arrays[TOP] >= ONE_QUANTUM, field, 0.0)


def bonded(bed: Bed, words: NDArray[np.int64], parameters: SnowParameters) -> NDArray[np.bool_]:
    """Whether packed layers of a bed have bonded."""
    return (age_of(bed, words) >= parameters.bonding.loose_hours) & parameters.bonding.grows


def strata(
    parameters: SnowParameters, bed: Bed, value: Callable[[NDArray[np.int64]], NDArray]
) -> list[tuple[Field, NDArray]]:
    """Thickness (m) of all layers and a value of each, found from its packed words, the lowest first."""
    return [(_thickness(words, parameters), value(words)) for words in reversed(list(layers_of(bed)))]


STRATA = (
    Strata(
        "age",
        "age of the bonds",
        "h at -10 °C",
        lambda model, bed: strata(model.parameters, bed, partial(age_of, bed)),
        clock=EPOCH,
        tick=EPOCH_SECONDS / 3600.0,
    ),
    Strata("density", "density", "kg/m³", lambda model, bed: strata(model.parameters, bed, density_of)),
    Strata(
        "state",
        "state",
        "-",
        lambda model, bed: strata(
            model.parameters, bed, lambda words: bonded(bed, words, model.parameters).astype(np.float64)
        ),
        ("loose", "bonded"),
    ),
    Strata(
        "mass",
        "mass",
        "kg/m²",
        lambda model, bed: strata(
            model.parameters, bed, lambda words: quanta_of(words) * model.parameters.quantum
        ),
        drawn=False,
    ),
)
"""What sections and tables show of the layers of snow."""


DERIVED = (
    Derived(
        "density",
        "kg/m³",
        "density of the uppermost layer",
        lambda _model, bed, _wind: surface_density(bed),
        least=0.0,
        of_layers=True,
    ),
    Derived(
        "age",
        "h at -10 °C",
        "age of the bonds of the uppermost layer",
        lambda _model, bed, _wind: surface_age(bed),
        least=0.0,
        of_layers=True,
    ),
    Derived(
        "threshold_wind",
        "m/s",
        "wind at 10 m that the uppermost layer withstands",
        lambda model, bed, wind: threshold_wind(bed, model.conditions(wind)),
        least=0.0,
        of_layers=True,
    ),
    Derived(
        "loose_depth",
        "m",
        "thickness of the snow that has not bonded",
        lambda model, bed, _wind: loose_depth(bed, model.parameters),
        least=0.0,
    ),
    Derived(
        "mean_density",
        "kg/m³",
        "mass over thickness of all snow",
        lambda model, bed, _wind: mean_density(bed, model.parameters.quantum),
        least=0.0,
        of_layers=True,
    ),
    Derived(
        "stress",
        "1",
        "shear stress over that on flat snow",
        lambda model, bed, wind: model.stress(bed.elevation, wind.direction),
        centred=True,
        along_wind=True,
        least=0.0,
    ),
    Derived(
        "friction_velocity",
        "m/s",
        "friction velocity of the wind over the snow",
        lambda model, bed, wind: (
            model.friction_velocity(wind)
            * np.sqrt(np.maximum(model.stress(bed.elevation, wind.direction), 0.0))
        ),
        along_wind=True,
        least=0.0,
    ),
)
"""Fields of snow that are computed when someone looks."""
