"""Frames as an xarray dataset, the same from memory as from disk."""

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np

from barchan.archive.coordinates import GRID_MAPPING, STEP, axes, mapped, mapping_attributes
from barchan.archive.frames import COUNTERS, field_attributes, run_attributes
from barchan.fields import GROUND, depth_of
from barchan.scenario import Scenario
from barchan.simulation import Frame, Simulation
from barchan.udunits import cf_units

if TYPE_CHECKING:
    import xarray as xr

TIME = {**cf_units("s"), "long_name": "time since the start"}
ELEVATION = {**cf_units("m"), "long_name": "elevation of the surface"}


def dataset_of(simulation: Simulation, frames: Iterable[Frame]) -> "xr.Dataset":
    """Frames of a simulation as a dataset; its attribute ``events`` holds what was changed (JSON)."""
    import json

    import xarray as xr

    frames = list(frames)
    lattice, scenario = simulation.lattice, simulation.scenario
    place = scenario.ground.georeference()
    coordinates: dict[str, Any] = {
        "step": ("step", np.array([f.step for f in frames], np.int64), STEP),
        **axes(lattice, place),
    }
    if mapping := mapping_attributes(place):
        coordinates[GRID_MAPPING] = ((), 0, mapping)
    slabs = simulation.bed.layers[-1].unit
    values = {
        c.name: ("step", np.array([c.of(f) for f in frames], c.dtype), c.attributes(slabs)) for c in COUNTERS
    }
    fields = {
        name: (
            ("step", "y", "x"),
            np.stack([f.fields[name] for f in frames]),
            {**field_attributes(info), **mapped(place)},
        )
        for name, info in simulation.bed.declared.items()
        if info.in_frames
    }
    dataset = xr.Dataset({**fields, **values}, coordinates, run_attributes(scenario, scenario.text()))
    dataset.attrs["events"] = json.dumps([record.data() for record in simulation.events])
    depth = depth_of(simulation.model.layers, dataset, lattice.thickness)
    dataset["elevation"] = dataset[GROUND.name] + depth
    dataset["elevation"].attrs.update({**ELEVATION, **mapped(place)})
    return with_time(dataset, scenario)


def with_time(dataset: "xr.Dataset", scenario: Scenario) -> "xr.Dataset":
    """Frames with their times, where the scenario's steps have a duration."""
    seconds = scenario.step_seconds
    return (
        dataset
        if seconds is None
        else dataset.assign_coords(time=("step", dataset["step"].values * seconds, TIME))
    )
