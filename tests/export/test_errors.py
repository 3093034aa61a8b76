"""Whatever cannot be exported is answered with one clear error, and nothing half-written stays."""

import json
import resource
import shutil
import signal
import sys
from datetime import datetime
from importlib import util

import pytest

from barchan.archive import open_run
from barchan.archive import run as run_into
from barchan.errors import ArchiveError, BarchanError, ExportError
from barchan.export import FORMATS, export
from barchan.simulation import Simulation
from tests.tiny import tiny


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    folder = tmp_path_factory.mktemp("runs") / "dunes"
    run_into(Simulation(tiny()), folder)
    return folder


@pytest.mark.parametrize(
    ("name", "options", "said"),
    [
        ("dunes.xyz", {}, "no format is written to '.xyz'; there are:\n  .vtkhdf"),
        ("dunes", {}, "no suffix"),
        ("dunes.tif", {"format": "geotif"}, "did you mean 'geotiff'"),
        ("dunes.tif", {"fields": "shadw"}, "no field 'shadw'; this run has .*did you mean 'shadow'"),
        ("dunes.glb", {"fields": "slope"}, "glb holds no fields"),
        ("dunes.tif", {"step": 7}, "step 7 was not saved; near it are 0, 5, 10, 15 "),
        ("dunes.stl", {"flip": True}, "--flip: stl does not take it; of these options it takes --smooth"),
        ("dunes.stl", {"smoth": 1.0}, "smoth: no such option.*did you mean 'smooth'"),
        ("dunes.stl", {"smooth": -1.0}, "--smooth: is -1; allowed: 0 to 1000 cells"),
        ("dunes.png", {"limits": (3.0, 1.0)}, "--limits: is 3 1; allowed: the lowest below the highest"),
        ("dunes.asc", {"cells": (10, 10)}, "square ones; for instance --cells 9 6"),
        ("dunes.stl", {"cells": (1, 10)}, "two rows and columns"),
        ("nowhere/dunes.tif", {}, "there is no folder"),
        ("dunes.nc", {"epoch": datetime(2020, 1, 1)}, "no duration"),
    ],
)  # fmt: skip
def test_a_wish_that_cannot_be_met(run, tmp_path, name, options, said):
    with pytest.raises(ExportError, match=f"(?s){said}"):
        export(run, tmp_path / name, **options)
    assert list(tmp_path.iterdir()) == []


def test_a_folder_in_the_targets_place(run, tmp_path):
    (tmp_path / "dunes.nc").mkdir()
    with pytest.raises(ExportError, match=r"dunes\.nc: it is a folder"):
        export(run, tmp_path / "dunes.nc")


def test_a_missing_library_is_named_with_a_way_to_install_it(run, tmp_path, monkeypatch):
    found = util.find_spec
    monkeypatch.setattr(
        "barchan.export.formats.find_spec", lambda name: None if name == "rasterio" else found(name)
    )
    with pytest.raises(ExportError, match=r"python -m pip install rasterio; or write --format tiff32"):
        export(run, tmp_path / "dunes.tif")
    export(run, tmp_path / "dunes.tif", format="tiff32")


def test_where_there_is_no_run(tmp_path):
    with pytest.raises(ArchiveError, match="not a run"):
        export(tmp_path, tmp_path / "dunes.nc")


def test_a_run_of_a_newer_format(run, tmp_path):
    copy = tmp_path / "run"
    shutil.copytree(run, copy)
    scenario = json.loads((copy / "scenario.json").read_text())
    (copy / "scenario.json").write_text(json.dumps({**scenario, "barchan": 99}))
    with pytest.raises(BarchanError, match="newer Barchan"):
        export(copy, tmp_path / "dunes.nc")


def test_a_run_killed_before_its_first_frame(run, tmp_path):
    copy = tmp_path / "run"
    shutil.copytree(run, copy)
    shutil.rmtree(copy / "frames.zarr")
    with pytest.raises(ArchiveError, match="no frames were saved"):
        export(copy, tmp_path / "dunes.nc")


def test_export_changes_nothing_in_the_run(run, tmp_path):
    before = {path: path.read_bytes() for path in run.rglob("*") if path.is_file()}
    export(run, tmp_path / "dunes.nc", fields="all")
    assert {path: path.read_bytes() for path in run.rglob("*") if path.is_file()} == before


def test_a_frame_in_memory_is_exported_as_a_run_is(run, tmp_path):
    export(open_run(run).isel(step=-1), tmp_path / "frame.r32")
    export(run, tmp_path / "run.r32")
    assert (tmp_path / "frame.r32").read_bytes() == (tmp_path / "run.r32").read_bytes()


@pytest.fixture
def full_disk(monkeypatch):
    """No file may grow beyond 64 bytes; no bytecode is written, which would stay cut off."""
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    before, heeded = resource.getrlimit(resource.RLIMIT_FSIZE), signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (64, before[1]))
    yield
    resource.setrlimit(resource.RLIMIT_FSIZE, before)
    signal.signal(signal.SIGXFSZ, heeded)


OF_SAND = [one for one in FORMATS if one.name != "layers"]
"""Formats that hold something of sand, which keeps no layers."""


@pytest.mark.parametrize("one", OF_SAND, ids=lambda one: one.name)
def test_a_full_disk_leaves_nothing_half_written(run, tmp_path, full_disk, one):
    with pytest.raises(ExportError, match="cannot write") as told:
        export(run, tmp_path / f"dunes{one.suffixes[0]}", format=one.name)
    assert ".partial" not in str(told.value) or one.name == "exr"
    assert list(tmp_path.iterdir()) == []
