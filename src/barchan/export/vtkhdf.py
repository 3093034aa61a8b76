"""VTKHDF: all frames in one file that ParaView opens with its times."""

from pathlib import Path
from typing import Any

import numpy as np

from barchan.export.numbers import plain
from barchan.export.source import Source

VERSION = (2, 0)
KIND = "ImageData"


def write(path: Path, source: Source) -> dict[str, Any]:
    """Write all frames as point data at the cells' centres, so that *Warp By Scalar* works at once.

    Arrays are (time, y, x): VTK's readers refuse (time, z, y, x) for an image one point thick.
    """
    import h5py

    grid = source.grid
    times = [source.seconds(step) for step in source.steps]
    clocked = None not in times
    with h5py.File(path, "w") as file:
        root = file.create_group("VTKHDF")
        root.attrs["Version"] = np.array(VERSION, "i8")
        root.attrs.create("Type", KIND.encode(), dtype=h5py.string_dtype("ascii", len(KIND)))
        root.attrs["WholeExtent"] = np.array([0, grid.columns - 1, 0, grid.rows - 1, 0, 0], "i8")
        root.attrs["Origin"] = np.array([grid.x[0], grid.y[0], 0.0])
        root.attrs["Spacing"] = np.array([grid.width, grid.height, 1.0])
        root.attrs["Direction"] = np.eye(3).ravel()
        data = root.create_group("PointData")
        if "elevation" in source.fields:
            data.attrs["Scalars"] = np.bytes_("elevation")
        for place, (_, sheets) in enumerate(source.each()):
            for name, sheet in sheets.items():
                values = plain(sheet.values)
                if name not in data:
                    whole = (len(source.steps), *values.shape)
                    data.create_dataset(
                        name, whole, values.dtype, chunks=(1, *values.shape), compression=1, shuffle=True
                    )
                data[name][place] = values
        frames = root.create_group("Steps")
        frames.attrs["NSteps"] = np.int64(len(source.steps))
        frames["Values"] = np.array(times if clocked else source.steps, "f8")
        offsets = frames.create_group("PointDataOffsets")
        for name in source.fields:
            offsets[name] = np.arange(len(source.steps), dtype="i8")
    return {"time_unit": "s" if clocked else "steps"}
