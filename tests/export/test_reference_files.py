"""Grids that cannot hold their reference system have it beside them, where GDAL finds it."""

import numpy as np
import rasterio
from rasterio.transform import Affine

from barchan.export import export
from tests.export.scenes import CELL, COLUMNS, ROWS, asymmetric


def test_an_ascii_grid_over_terrain_has_its_reference_system(tmp_path):
    path = tmp_path / "ground.tif"
    place = Affine(CELL, 0.0, 400_000.0, 0.0, -CELL, 3_500_000.0)
    with rasterio.open(
        path, "w", driver="GTiff", height=ROWS, width=COLUMNS, count=1, dtype="float32",
        crs="EPSG:32629", transform=place,
    ) as file:  # fmt: skip
        file.write(np.full((ROWS, COLUMNS), 100.0, "f4"), 1)
    run = asymmetric(ground={"kind": "file", "path": str(path)})
    files = export(run, tmp_path / "surface.asc")
    assert tmp_path / "surface.prj" in files
    with rasterio.open(tmp_path / "surface.asc") as grid:
        assert grid.crs.to_epsg() == 32629


def test_an_ascii_grid_of_no_place_on_earth_has_none_beside_it(tmp_path):
    export(asymmetric(), tmp_path / "surface.asc")
    assert not (tmp_path / "surface.prj").exists()
