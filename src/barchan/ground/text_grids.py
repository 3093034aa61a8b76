"""Elevation models as text: ESRI ASCII grids (.asc) and lists of points on a grid (.xyz)."""

import re
import warnings
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from barchan.ground.raster import Hints, Raster, UnreadableError, placed
from barchan.ground.reference import reference_of, stated
from barchan.missing import marked
from barchan.words import counted

NEEDED = ("ncols", "nrows")
KNOWN = (*NEEDED, "xllcorner", "yllcorner", "xllcenter", "yllcenter", "cellsize", "dx", "dy", "nodata_value")

OFF_GRID = 0.02
"""Largest part of a cell by which a point may lie beside the grid."""

SPARSEST = 20
"""Cells for each point that a grid of points may have."""

_WORD = re.compile(r"\s*([A-Za-z_]+)\s+(\S+)\s*$")


def read_ascii_grid(path: Path, hints: Hints) -> Raster:
    """An ESRI ASCII grid, north first; its reference system stands in a .prj file beside it, if anywhere.

    Source: Esri, ArcGIS documentation, "Esri ASCII raster format". Raises UnreadableError where the heading
    or the number of values is wrong.
    """
    head, body = _split(path)
    if absent := [key for key in NEEDED if key not in head]:
        raise UnreadableError(f"has no {' and no '.join(absent)} in its heading; known: {', '.join(KNOWN)}")
    rows, columns = int(head["nrows"]), int(head["ncols"])
    width, height = (head.get(key, head.get("cellsize", 0.0)) for key in ("dx", "dy"))
    if not (rows > 0 and columns > 0 and width > 0 and height > 0):
        raise UnreadableError("has a heading without ncols, nrows and cellsize above zero")
    values = _numbers(body)
    if values.size != rows * columns:
        raise UnreadableError(
            f"has {values.size} values; allowed: {rows} rows of {columns}, as its heading says"
        )
    values = values.reshape(rows, columns)
    if "nodata_value" in head:
        values[marked(values, [head["nodata_value"]])] = np.nan
    west = head.get("xllcorner", head.get("xllcenter", width / 2) - width / 2)
    south = head.get("yllcorner", head.get("yllcenter", height / 2) - height / 2)
    beside = path.with_suffix(".prj")
    own = reference_of(beside.read_text("utf-8", "replace")) if beside.is_file() else None
    transform = (width, 0.0, west, 0.0, -height, south + rows * height)
    return Raster(*placed(values, transform, stated(own, hints)))


def read_points(path: Path, hints: Hints) -> Raster:
    """A list of points x, y, z on a grid, in any order; cells without a point have no height."""
    points = _points(path)
    (column, west, width), (row, south, height) = (_steps(points[:, at], "xy"[at]) for at in (0, 1))
    rows, columns = int(row.max()) + 1, int(column.max()) + 1
    if rows * columns > SPARSEST * len(points):
        raise UnreadableError(
            f"has {len(points)} points on {rows} × {columns} cells of {width:g} × {height:g}: no grid; "
            "allowed: one point a cell, as a gridded model has, not those of a survey or a laser scan"
        )
    values = np.full((rows, columns), np.nan)
    values[row, column] = points[:, 2]
    repeated = len(points) - len(np.unique(row * columns + column))
    if repeated:
        more = counted(repeated, "point")
        raise UnreadableError(f"has {more} in cells that have one already; allowed: one a cell")
    transform = (width, 0.0, west, 0.0, height, south)
    return Raster(*placed(values, transform, stated(None, hints)))


def _split(path: Path) -> tuple[dict[str, float], str]:
    """The heading of an ASCII grid, keys in lower case, and the rest of its text."""
    try:
        text = path.read_text("utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        raise UnreadableError(f"cannot be read as an ASCII grid: {error}") from None
    head: dict[str, float] = {}
    at = 0
    while match := _WORD.match(text[at : text.find("\n", at) % (len(text) + 1)]):
        key = match[1].lower()
        if key not in KNOWN:
            raise UnreadableError(f"has the unknown key {match[1]} in its heading; known: {', '.join(KNOWN)}")
        head[key] = float(_numbers(match[2])[0])
        at = text.find("\n", at) + 1
        if not at:
            break
    return head, text[at:]


def _numbers(text: str) -> NDArray[np.float64]:
    if "," in text:
        text = text.replace(",", ".")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            return np.fromstring(text, sep=" ")
    except (DeprecationWarning, ValueError):
        raise UnreadableError("cannot be read as an ASCII grid: it holds words that are no numbers") from None


def _points(path: Path) -> NDArray[np.float64]:
    import pandas as pd

    try:
        with path.open(encoding="utf-8-sig") as file:
            first = file.readline()
        mark = ";" if ";" in first else "," if "," in first else r"\s+"
        heading = not re.match(r"\s*[-+.\d]", first)
        decimal = "," if mark == ";" else "."
        table = pd.read_csv(path, sep=mark, header=0 if heading else None, comment="#", decimal=decimal)
        points = table.to_numpy(np.float64)
    except (OSError, ValueError) as error:
        raise UnreadableError(f"cannot be read as points x, y, z: {error}") from None
    if points.shape[1] != 3 or len(points) < 4:
        raise UnreadableError(
            f"has {len(points)} rows of {points.shape[1]} columns; allowed: x, y, z of a grid"
        )
    if not np.isfinite(points[:, :2]).all():
        raise UnreadableError("has points without x or y")
    return points


def _steps(places: NDArray[np.float64], name: str) -> tuple[NDArray[np.int64], float, float]:
    """The number of each point's column (or row), the outer edge of the first, and their spacing."""
    first, last = float(places.min()), float(places.max())
    gaps = np.diff(np.unique(places))
    gaps = gaps[gaps > 1e-9 * max(abs(first), abs(last))]
    if not gaps.size:
        raise UnreadableError(f"has points at a single {name}; allowed: a grid")
    count = round((last - first) / float(np.median(gaps)))
    step = (last - first) / count
    number = np.rint((places - first) / step)
    if np.abs((places - first) / step - number).max() > OFF_GRID:
        raise UnreadableError(f"has points whose {name} are not evenly spaced by {step:g}; allowed: a grid")
    return number.astype(np.int64), first - step / 2, step
