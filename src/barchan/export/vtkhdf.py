"""VTKHDF: all frames in one file that ParaView opens with its times."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from barchan.export.source import Source
from barchan.export.wind import WindOver

if TYPE_CHECKING:
    import h5py

VERSION = (2, 0)
KIND = "ImageData"


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write all frames as point data at the cells' centres, so that *Warp By Scalar* works at once.

    Arrays are (time, y, x): VTK's readers refuse (time, z, y, x) for an image one point thick.
    """
    import h5py

    times = [source.seconds(step) for step in source.steps]
    clocked = None not in times
    with h5py.File(path, "w") as file:
        root = file.create_group("VTKHDF")
        _describe(root, source)
        data, whole = root.create_group("PointData"), root.create_group("FieldData")
        frames = root.create_group("Steps")
        frames.attrs["NSteps"] = np.int64(len(source.steps))
        frames["Values"] = np.array(times if clocked else source.steps, "f8")
        if "elevation" in source.fields:
            data.attrs["Scalars"] = np.bytes_("elevation")
        for place, (step, sheets) in enumerate(source.each()):
            wind = WindOver.of(source, step)
            for name, values in wind.over(sheets).items():
                _put(data, name, values, place, len(source.steps))
            for name, numbers in wind.arrays.items():
                _put(whole, name, numbers, place, len(source.steps))
        _place(frames.create_group("PointDataOffsets"), data)
        _place(frames.create_group("FieldDataOffsets"), whole)
        sizes = frames.create_group("FieldDataSizes")
        for name, numbers in whole.items():
            sizes[name] = np.array([[numbers.shape[1], 1]] * len(source.steps), "i8")
    return {"time_unit": "s" if clocked else "steps", **wind.facts}


def _describe(root: "h5py.Group", source: Source) -> None:
    import h5py

    grid = source.grid
    root.attrs["Version"] = np.array(VERSION, "i8")
    root.attrs.create("Type", KIND.encode(), dtype=h5py.string_dtype("ascii", len(KIND)))
    root.attrs["WholeExtent"] = np.array([0, grid.columns - 1, 0, grid.rows - 1, 0, 0], "i8")
    root.attrs["Origin"] = np.array([grid.x[0], grid.y[0], 0.0])
    root.attrs["Spacing"] = np.array([grid.width, grid.height, 1.0])
    root.attrs["Direction"] = np.eye(3).ravel()


def _put(group: "h5py.Group", name: str, values: NDArray, place: int, frames: int) -> None:
    """Put the values of a frame into its place in an array of all frames."""
    if name not in group:
        chunk = {"chunks": (1, *values.shape), "compression": 1, "shuffle": True} if values.ndim > 1 else {}
        group.create_dataset(name, (frames, *values.shape), values.dtype, **chunk)
    group[name][place] = values


def _place(offsets: "h5py.Group", data: "h5py.Group") -> None:
    """State where each frame begins in each array."""
    for name, values in data.items():
        offsets[name] = np.arange(len(values), dtype="i8")
