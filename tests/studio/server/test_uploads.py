"""What the browser learns of an uploaded file."""

import json

import numpy as np
import pytest

from barchan.errors import BarchanError
from barchan.ground import fitting
from barchan.ground.raster import Hints
from barchan.ground.surface import FileGround
from barchan.studio.server.gallery import files_taken
from barchan.studio.server.queries import QUERIES
from barchan.studio.server.workspace import Workspace
from barchan.studio.worker.file_content import file_content, heights_in
from barchan.wind.recorded import Recorded

HEAD = "ncols 12\nnrows 3\nxllcorner 500000\nyllcorner 4000000\ncellsize 2.5\n"


@pytest.fixture
def dem(tmp_path):
    def write(name="dem.asc", hole="7"):
        rows = [" ".join(["5", hole, *["6"] * 10]) for _ in range(3)]
        (tmp_path / name).write_text(HEAD + "\n".join(rows))
        return tmp_path / name

    return write


def test_an_elevation_model_is_described_by_its_cells(dem):
    assert heights_in(dem()) == {"rows": 3, "columns": 12, "cell_size": 2.5, "codes": [], "coloured": False}


def test_undeclared_codes_for_missing_cells_are_named(dem):
    assert heights_in(dem(hole="-9999"))["codes"] == [-9999.0]


def test_an_array_has_no_cells_of_its_own(tmp_path):
    np.save(tmp_path / "a.npy", np.ones((4, 9)))
    held = heights_in(tmp_path / "a.npy")
    assert held == {"rows": 4, "columns": 9, "cell_size": None, "codes": [], "coloured": False}


def test_a_record_of_winds_holds_no_heights(tmp_path):
    xr = pytest.importorskip("xarray")
    time = np.arange(3) * np.timedelta64(1, "h") + np.datetime64("2020-01-01", "ns")
    wind = xr.Dataset({"u10": ("time", np.ones(3)), "v10": ("time", np.ones(3))}, {"time": time})
    wind.to_netcdf(tmp_path / "wind.nc")
    reanalysis = wind.expand_dims(latitude=[40.0, 40.25], longitude=[10.0, 10.25, 10.5])
    reanalysis.to_netcdf(tmp_path / "era5.nc")
    for name in ("wind.nc", "era5.nc", "wind.csv"):
        assert heights_in(tmp_path / name) is None


def test_text_grids_may_be_uploaded(tmp_path):
    workspace = Workspace(tmp_path)
    for name in ("dem.asc", "dem.xyz", "dem.hgt", "dem.nc"):
        assert workspace.keep(name, b"1").name == name
    with pytest.raises(BarchanError):
        workspace.keep("dem.py", b"1")


def test_checking_a_scenario_opens_no_file_beyond_the_folder(dem, tmp_path):
    ground = {"kind": "file", "path": str(dem("secret.asc"))}
    text = json.dumps({"barchan": 5, "lattice": "from ground", "ground": ground})
    answer = QUERIES["check"](Workspace(tmp_path / "folder"), {"command": "check", "text": text})
    assert answer["scenario"] is None
    (problem,) = answer["problems"]
    assert problem["key"] == "ground.path"
    assert "is outside the studio's folder" in problem["message"]


def test_every_kind_of_file_that_a_reader_knows_may_be_uploaded(tmp_path):
    taken = files_taken()
    assert {".csv", ".txt", ".dat", ".xlsx", ".smet", ".nc"} <= set(taken["records"])
    assert {".png", ".npy", ".tif", ".asc", ".hgt"} <= set(taken["heights"])
    workspace = Workspace(tmp_path)
    for suffix in (*taken["records"], *taken["heights"]):
        assert workspace.keep(f"file{suffix}", b"1").is_file()


def test_a_file_that_was_looked_into_is_not_read_a_second_time(dem, monkeypatch):
    file = dem()
    heights_in(file)
    monkeypatch.setattr(fitting, "read", lambda *_: pytest.fail("read twice"))
    ground = FileGround(kind="file", path=str(file))
    assert ground.raster().values.shape == (3, 12)


def test_a_file_that_was_changed_is_read_again(dem):
    assert heights_in(dem(hole="-9999"))["codes"] == [-9999.0]
    assert heights_in(dem(hole="8"))["codes"] == []


def test_numbers_that_are_kept_cannot_be_changed(dem):
    with pytest.raises(ValueError, match="read-only"):
        fitting.raster_in(dem(), Hints()).values[0, 0] = 1.0


def test_a_record_is_read_where_a_file_holds_no_heights(tmp_path, monkeypatch):
    read = []
    monkeypatch.setattr(Recorded, "series", lambda record: read.append(record.path))
    (tmp_path / "wind.csv").write_text("time,speed,direction\n")
    assert file_content(tmp_path / "wind.csv") == {"heights": None, "record": True}
    assert read == [str(tmp_path / "wind.csv")]


def test_a_file_that_holds_neither_heights_nor_winds_is_no_record(tmp_path):
    (tmp_path / "note.csv").write_text("a,b\n1,2\n")
    assert file_content(tmp_path / "note.csv") == {"heights": None, "record": False}
