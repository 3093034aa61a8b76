"""Frames in a Zarr store: one chunk a frame, and the consolidated metadata last, as the commit."""

import json
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import zarr
from numpy.typing import NDArray
from zarr.core.sync import sync

from barchan.archive.coordinates import (
    GRID_MAPPING,
    STEP,
    axes,
    lattice_attributes,
    mapped,
    mapping_attributes,
    place_attributes,
)
from barchan.fields import FieldInfo
from barchan.scenario import Scenario
from barchan.scenario.migrations import current_field
from barchan.simulation import Frame
from barchan.udunits import cf_units


@dataclass(frozen=True)
class Counter:
    """A number that frames carry beside the fields."""

    name: str
    unit: str
    meaning: str
    of: Callable[[Frame], float]
    dtype: str = "int64"

    def attributes(self, slabs: str) -> dict[str, Any]:
        """Unit and meaning, in CF's words and in ours; ``slabs`` are the whole units of the bed."""
        return {**cf_units(self.unit.format(slabs)), "long_name": self.meaning.format(slabs)}


COUNTERS = (
    Counter("moved", "{}", "{} that the wind took since the start", lambda f: f.tally.moved),
    Counter("left", "{}", "{} that left the field since the start", lambda f: f.ledger.left),
    Counter("entered", "{}", "{} that entered the field since the start", lambda f: f.ledger.entered),
    Counter("fallen", "{}", "{} among these that fell as snow", lambda f: f.tally.fallen),
    Counter("airborne", "{}", "{} in the air", lambda f: f.ledger.airborne),
    Counter("capped", "{}", "{} put down because they never settled", lambda f: f.tally.capped),
    Counter(
        "travel_x",
        "cells",
        "distance all {} travelled eastwards on the wind",
        lambda f: f.tally.travel_x,
        "float64",
    ),
    Counter(
        "travel_y",
        "cells",
        "distance all {} travelled northwards on the wind",
        lambda f: f.tally.travel_y,
        "float64",
    ),
    Counter(
        "wind_direction",
        "degrees",
        "where the wind comes from, clockwise from north",
        lambda f: f.direction,
        "float64",
    ),
)
"""The numbers that frames carry beside the fields."""

_CHUNK = 1024


def field_attributes(field: FieldInfo) -> dict[str, Any]:
    """Unit and meaning of a field, in CF's words and in ours."""
    return {**cf_units(field.unit), "long_name": field.meaning}


def run_attributes(scenario: Scenario, text: str) -> dict[str, Any]:
    """What the data of a run of ``scenario`` say of themselves; ``text`` is the scenario as they hold it."""
    from barchan.version import __version__

    return {
        "Conventions": "CF-1.11",
        "title": scenario.title,
        "source": f"Barchan {__version__}",
        "references": scenario.citation,
        "scenario": text,
        **lattice_attributes(scenario.lattice),
        "slab_height": scenario.lattice.thickness,
        **place_attributes(scenario.ground.georeference()),
    }


def published(path: Path) -> bool:
    """Whether there is a store of frames that was ever committed; a kill may leave one half made."""
    try:
        root = json.loads((path / "zarr.json").read_text("utf-8"))
    except FileNotFoundError:
        return False
    return root.get("consolidated_metadata") is not None


class Frames:
    """The growing store of a run's frames."""

    def __init__(self, path: Path) -> None:
        """Open an existing store for writing."""
        self.path = path
        for unfinished in path.rglob("*.partial"):
            unfinished.unlink()
        self.group = zarr.open_group(path, mode="r+", use_consolidated=False)
        self._stored = {current_field(name): name for name in self.group.array_keys()}
        # Archives of earlier versions lack counters that came later.
        self._counters = [counter for counter in COUNTERS if counter.name in self._stored]

    @classmethod
    def create(cls, path: Path, scenario: Scenario, text: str, fields: dict[str, FieldInfo]) -> "Frames":
        """Make an empty store for a scenario's frames, which holds the scenario as ``text``."""
        group = zarr.open_group(path, mode="w", zarr_format=3, attributes=run_attributes(scenario, text))
        lattice, place = scenario.lattice, scenario.ground.georeference()
        beside = []
        for name, (dims, places, attributes) in axes(lattice, place).items():
            array = _make(group, name, places.shape, places.shape, "float64", dims)
            array.attrs.update(attributes)
            array[...] = places
            beside += [] if dims == (name,) else [name]
        if mapping := mapping_attributes(place):
            _make(group, GRID_MAPPING, (), (), "int64", ()).attrs.update(mapping)
            beside.append(GRID_MAPPING)
        if beside:
            group.attrs["coordinates"] = " ".join(beside)
        _make(group, "step", (0,), (_CHUNK,), "int64", ("step",)).attrs.update(STEP)
        for counter in COUNTERS:
            array = _make(group, counter.name, (0,), (_CHUNK,), counter.dtype, ("step",))
            array.attrs.update(counter.attributes(scenario.layers[-1].unit))
        for field in fields.values():
            if field.in_frames:
                shape, chunk = (0, *lattice.shape), (1, *lattice.shape)
                array = _make(group, field.name, shape, chunk, field.dtype, ("step", "y", "x"))
                array.attrs.update({**field_attributes(field), **mapped(place)})
        store = cls(path)
        store.commit()
        return store

    def append(self, frame: Frame) -> None:
        """Add a frame; readers see it when it is complete, never before."""
        count = self.count
        values: dict[str, Any] = {
            "step": frame.step,
            **{c.name: c.of(frame) for c in self._counters},
            **frame.fields,
        }
        for name, value in values.items():
            array = self._array(name)
            array.resize((count + 1, *array.shape[1:]))
            array[count] = value
        self.commit()

    def keep(self, count: int) -> None:
        """Drop all but the first ``count`` frames; readers who know of the others still find their chunks."""
        for name in ["step", *(c.name for c in self._counters), *self.fields]:
            array = self._array(name)
            sync(array.async_array.resize((count, *array.shape[1:]), delete_outside_chunks=False))
        self.commit()

    def commit(self) -> None:
        """Publish what was written: a reader sees only what the consolidated metadata know."""
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", message="Consolidated metadata")
            zarr.consolidate_metadata(self.path)

    def describe(self, scenario: Scenario, text: str) -> None:
        """Let the store say that it holds a run of ``scenario``, whose text is ``text``."""
        zarr.open_consolidated(self.path, mode="r+").attrs.update(run_attributes(scenario, text))

    @property
    def steps(self) -> NDArray[np.int64]:
        """Steps of the published frames."""
        group = zarr.open_group(self.path, mode="r")
        return np.asarray(group["step"][...])  # type: ignore[index]

    @property
    def count(self) -> int:
        """How many frames are published."""
        return len(self.steps)

    @property
    def fields(self) -> list[str]:
        """Names of the stored fields."""
        return [current_field(name) for name, array in self.group.arrays() if array.ndim == 3]

    def _array(self, name: str) -> zarr.Array:
        array = self.group[self._stored.get(name, name)]
        assert isinstance(array, zarr.Array)
        return array


def _make(
    group: zarr.Group,
    name: str,
    shape: tuple[int, ...],
    chunk: tuple[int, ...],
    dtype: str,
    dims: tuple[str, ...],
) -> zarr.Array:
    return group.create_array(
        name, shape=shape, chunks=chunk, dtype=dtype, dimension_names=dims, fill_value=0
    )
