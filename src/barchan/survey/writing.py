"""Crest lines and dunes as files: GeoJSON in the coordinates of the surface, CSV."""

import json
import math
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from barchan.errors import SurveyError
from barchan.export.tables import heading, write_table
from barchan.measures.dune_shapes import DuneShape, outline
from barchan.measures.dunes import Dune
from barchan.replacing import replacing
from barchan.survey.height_field import HeightField
from barchan.survey.measuring import Survey

DIGITS = 3
"""Decimals of coordinates and properties: millimetres."""

COLUMNS = (
    ("x", "m"),
    ("y", "m"),
    ("area", "m²"),
    ("volume", "m³"),
    ("height", "m"),
    ("width", "m"),
    ("length", "m"),
    ("orientation", "degrees"),
    ("elongation", "-"),
    ("left_horn", "m"),
    ("right_horn", "m"),
    ("asymmetry", "-"),
    ("horn_direction", "degrees"),
    ("bay", "-"),
)
"""Properties of a dune, those of ``DuneShape`` but for its centre in coordinates, and their units."""


def write_crests(path: str | Path, survey: Survey) -> Path:
    """Write the crest lines with length (m), azimuth (degrees) and free ends, as GeoJSON; returns the file.

    Raises SurveyError where it cannot be written.
    """
    target = _target(path, (".geojson", ".json"))
    side = survey.cell_size
    features = [
        _feature(
            "LineString",
            _places(survey.field, line.rows, line.columns),
            {"length": line.length * side, "azimuth": line.azimuth, "ends": line.ends},
        )
        for line in survey.crests
    ]
    return _write_geojson(target, survey.field, features)


def write_dunes(path: str | Path, survey: Survey) -> Path:
    """Write the dunes one by one, as CSV or, with their outlines, as GeoJSON; returns the file.

    Raises SurveyError where it cannot be written.
    """
    target = _target(path, (".csv", ".geojson", ".json"))
    if target.suffix.lower() != ".csv":
        features = [
            _feature(
                "Polygon",
                [_places(survey.field, *ring.T) for ring in outline(dune)],
                _properties(survey.field, dune, shape),
            )
            for dune, shape in survey.dunes
        ]
        return _write_geojson(target, survey.field, features)
    rows = [list(_properties(survey.field, *one).values()) for one in survey.dunes]
    with _reported(target), replacing(target) as partial:
        write_table(partial, [heading(name, unit) for name, unit in COLUMNS], rows)
    return target


def _properties(field: HeightField, _dune: Dune, shape: DuneShape) -> dict[str, float]:
    x, y = field.place(shape.row, shape.column)
    own = {name: float(getattr(shape, name)) for name, _ in COLUMNS[2:]}
    return {"x": float(x), "y": float(y), **own}


def _places(field: HeightField, rows: Any, columns: Any) -> list[list[float]]:
    x, y = field.place(rows, columns)
    return np.round(np.stack([x, y], axis=1), DIGITS).tolist()


def _feature(kind: str, coordinates: Any, properties: dict[str, float]) -> dict[str, Any]:
    told = {
        name: value if isinstance(value, int) else (_rounded(value) if math.isfinite(value) else None)
        for name, value in properties.items()
    }
    return {
        "type": "Feature",
        "geometry": {"type": kind, "coordinates": coordinates},
        "properties": told,
    }


def _rounded(value: float) -> float:
    """Six digits, or the decimals of coordinates where these are more."""
    return round(value, DIGITS) if abs(value) >= 1000 else float(f"{value:.6g}")


def _write_geojson(target: Path, field: HeightField, features: list[dict[str, Any]]) -> Path:
    """Write features with the reference system in the member ``crs``, as GDAL and QGIS read it."""
    data: dict[str, Any] = {"type": "FeatureCollection"}
    if field.grid.crs is not None:
        name = field.grid.crs if field.grid.crs.startswith("EPSG:") else field.grid.wkt
        urn = f"urn:ogc:def:crs:EPSG::{name[5:]}" if name and name.startswith("EPSG:") else name
        data["crs"] = {"type": "name", "properties": {"name": urn}}
    data["features"] = features
    with _reported(target), replacing(target) as partial:
        partial.write_text(json.dumps(data, allow_nan=False), "utf-8")
    return target


def _target(path: str | Path, suffixes: tuple[str, ...]) -> Path:
    target = Path(path)
    if target.suffix.lower() not in suffixes:
        raise SurveyError(
            f"{target}: written as {target.suffix or 'no suffix'}; allowed: {', '.join(suffixes)}"
        )
    return target


@contextmanager
def _reported(target: Path) -> Iterator[None]:
    """Turn a failure of the disk into an error that names the file."""
    try:
        yield
    except OSError as error:
        raise SurveyError(f"{target}: cannot be written: {error.strerror or error}") from None
