"""Any field of a frame by its name: kept in the frame, derived by the run's model, or plain for every bed.

Derived fields follow the parameters and the wind's speed in force when the frame was taken.
"""

import json
from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.bed import Bed
from barchan.errors import BarchanError
from barchan.measures.filters import gradient, sixfold_gradient
from barchan.models import Derived, Model, models
from barchan.scenario import Scenario, nearest
from barchan.simulation import Record, in_force
from barchan.udunits import cf_units
from barchan.wind.segment import Segment

if TYPE_CHECKING:
    import xarray as xr


def _slope(_model: Model, bed: Bed, _wind: Segment) -> NDArray[np.float64]:
    lattice = bed.lattice
    of = sixfold_gradient if lattice.hexagonal else gradient
    east, north = of(bed.elevation, lattice.cell_size, lattice.periodic)
    return np.degrees(np.arctan(np.hypot(east, north)))


PLAIN = (
    Derived("slope", "degrees", "slope of the surface", _slope, least=0.0),
    Derived("depth", "m", "depth of all layers on the ground", lambda _, bed, _wind: bed.depth, least=0.0),
)
"""Fields that can be derived from every bed, whatever its model."""


def scenario_at(frame: "xr.Dataset", scenario: Scenario) -> Scenario:
    """The scenario with the changes by events up to the time of the frame; see the attribute ``events``."""
    happened = json.loads(frame.attrs.get("events", "[]"))
    if not happened:
        return scenario
    return in_force(scenario, map(Record.from_data, happened), int(frame["step"]))


def field_names(frame: "xr.Dataset", scenario: Scenario) -> list[str]:
    """Names of the fields that ``field_of`` knows."""
    heights = (layer.height for layer in scenario.layers if layer.height)
    coded = {field.name for field in (*scenario.new_model().fields, *heights) if field.coded}
    kept = {str(name) for name, values in frame.data_vars.items() if values.dims == ("y", "x")}
    return sorted({*(kept - coded), *_derived(scenario)})


def field_of(frame: "xr.Dataset", scenario: Scenario, name: str) -> "xr.DataArray":
    """A field of one frame, with ``unit`` and ``long_name`` among its attributes.

    Where there is one, the attribute ``centre`` is the value that pictures show it evenly about and ``least``
    the one that it cannot lie below; ``sheltered`` is 1 where it is 0 on cells in shadow, ``of_layers`` 1
    where it has no value on bare ground; ``along_wind`` is 1 where it is the size of something
    that points where the wind blows. Raises BarchanError where there is no such field.
    """
    known = field_names(frame, scenario)
    if name not in known:
        raise BarchanError(f"no field '{name}'; this run has {', '.join(known)}{nearest(name, known)}")
    derived = _derived(scenario).get(name)
    return _kept(frame, scenario, name) if derived is None else _computed(frame, scenario, derived)


def _derived(scenario: Scenario) -> dict[str, Derived]:
    return {field.name: field for field in (*PLAIN, *scenario.new_model().derived)}


def _kept(frame: "xr.Dataset", scenario: Scenario, name: str) -> "xr.DataArray":
    own = {field.name: field.centre for field in models()[scenario.model.name].fields}
    counted = any(layer.name == name for layer in scenario.layers)
    return _described(frame[name], centre=own.get(name), least=0.0 if counted else None)


def _computed(frame: "xr.Dataset", scenario: Scenario, derived: Derived) -> "xr.DataArray":
    import xarray as xr

    model, bed, wind = as_modelled(frame, scenario)
    values = xr.DataArray(
        derived.compute(model, bed, wind), frame["elevation"].coords, ("y", "x"), derived.name
    )
    return _described(
        values.assign_attrs(cf_units(derived.unit), long_name=derived.meaning),
        centre=centre_of(model, derived, wind),
        least=derived.least,
        sheltered=int(derived.sheltered) or None,
        of_layers=int(derived.of_layers) or None,
        along_wind=int(derived.along_wind) or None,
    )


def centre_of(model: Model, derived: Derived, wind: Segment) -> float | None:
    """The value of a derived field on a flat and bare bed, where pictures show it evenly about that."""
    if not derived.centred:
        return None
    ground, nothing = np.zeros(model.lattice.shape), np.zeros(model.lattice.shape, np.int32)
    level = Bed(model.lattice, ground, *[nothing for _ in model.layers], layers=model.layers)
    for field in model.fields:
        level.add(field, np.zeros(model.lattice.shape, field.dtype))
    return float(derived.compute(model, level, wind).flat[0])


def bed_in(frame: "xr.Dataset", scenario: Scenario) -> Bed:
    """Ground and layers of a frame."""
    return Bed.from_fields(scenario.lattice, _Carried(frame), (), scenario.layers)


class _Carried(Mapping[str, NDArray]):
    """The fields of a frame, each of which is read when it is asked for."""

    def __init__(self, frame: "xr.Dataset") -> None:
        self._frame = frame

    def __getitem__(self, name: str) -> NDArray:
        return np.asarray(self._frame.data_vars[name].values)

    def __iter__(self) -> Iterator[str]:
        return map(str, self._frame.data_vars)

    def __len__(self) -> int:
        return len(self._frame.data_vars)


def as_modelled(frame: "xr.Dataset", scenario: Scenario) -> tuple[Model, Bed, Segment]:
    """The model, the bed and the wind of a frame, as they were when it was taken."""
    scenario = scenario_at(frame, scenario)
    model = scenario.new_model()
    bed = Bed.from_fields(scenario.lattice, _Carried(frame), model.fields, model.layers)
    return model, bed, wind_over(frame, scenario)


def _described(values: "xr.DataArray", **attributes: float | None) -> "xr.DataArray":
    return values.assign_attrs({name: value for name, value in attributes.items() if value is not None})


def wind_over(frame: "xr.Dataset", scenario: Scenario) -> Segment:
    """The wind over a frame; its direction is the frame's own, as events may have changed it."""
    segment = scenario.forcing().wind_of(max(int(frame["step"]) - 1, 0))
    return replace(segment, direction=float(frame["wind_direction"]))
