"""Other programs' libraries that read what was written: eastings, northings, heights from the south."""

import json
import warnings
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import rasterio
import tifffile
import trimesh
import xarray as xr
from PIL import Image
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkIOHDF import vtkHDFReader
from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader
from vtkmodules.vtkIOXML import vtkXMLImageDataReader


def car_of(path: Path) -> dict:
    return json.loads(path.with_name(path.name + ".json").read_text("utf-8"))


def vtk_times(reader) -> list[float]:
    reader.UpdateInformation()
    return list(reader.GetOutputInformation(0).Get(Pipeline.TIME_STEPS()) or ())


def vtk_field(image, name: str) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    columns, rows, layers = image.GetDimensions()
    assert layers == 1
    (west, south, _), (width, height, _) = image.GetOrigin(), image.GetSpacing()
    values = vtk_to_numpy(image.GetPointData().GetArray(name)).reshape(rows, columns)
    return west + np.arange(columns) * width, south + np.arange(rows) * height, values


def vtkhdf(path: Path, time: float | None = None, name: str = "elevation"):
    reader = vtkHDFReader()
    reader.SetFileName(str(path))
    times = vtk_times(reader)
    reader.UpdateTimeStep(times[-1] if time is None else time)
    return vtk_field(reader.GetOutput(), name)


def vti(path: Path, name: str = "elevation"):
    reader = vtkXMLImageDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return vtk_field(reader.GetOutput(), name)


def pvd(path: Path):
    frames = ET.parse(path).getroot().findall("Collection/DataSet")
    assert [float(frame.get("timestep")) for frame in frames] == sorted(
        float(frame.get("timestep")) for frame in frames
    )
    return vti(path.parent / frames[-1].get("file"))


def netcdf(path: Path):
    with xr.open_dataset(path, engine="h5netcdf") as run:
        return run.x.values, run.y.values, run.elevation.isel({run.elevation.dims[0]: -1}).values


def netcdf_by_vtk(path: Path):
    reader = vtkNetCDFCFReader()
    reader.SetFileName(str(path))
    reader.SphericalCoordinatesOff()
    reader.UpdateMetaData()
    dimensions = reader.GetAllDimensions()
    reader.SetDimensions(
        next(d for d in map(dimensions.GetValue, range(dimensions.GetNumberOfValues())) if "y" in d)
    )
    reader.UpdateTimeStep(vtk_times(reader)[-1])
    return vtk_field(reader.GetOutput(), "elevation")


def gdal(path: Path | str, band: int = 1):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", rasterio.errors.NotGeoreferencedWarning)
        with rasterio.open(path) as file:
            rows, columns = file.shape
            x, _ = file.xy(np.zeros(columns), np.arange(columns))
            _, y = file.xy(np.arange(rows), np.zeros(rows))
            return np.array(x), np.array(y)[::-1], file.read(band)[::-1]


def netcdf_by_gdal(path: Path):
    name = f"netcdf:{path}:elevation"
    with rasterio.open(name) as file:
        frames = file.count
    return gdal(name, frames)


def _pictured(path: Path, values: np.ndarray):
    frame = car_of(path)["frame"]
    x = frame["west_edge_m"] + (np.arange(frame["columns"]) + 0.5) * frame["cell_width_m"]
    y = frame["south_edge_m"] + (np.arange(frame["rows"]) + 0.5) * frame["cell_height_m"]
    return x, y, values[::-1] if car_of(path).get("first_row", "north") == "north" else values


def _height(path: Path, numbers: np.ndarray) -> np.ndarray:
    told = car_of(path)["numbers"]["elevation"]
    values = told["lowest"] + numbers * told["per_unit"]
    return values if told["first_row"] == "north" else values[::-1]


def png16(path: Path):
    with Image.open(path) as picture:
        assert picture.mode in ("I;16", "I")
        return _pictured(path, _height(path, np.asarray(picture).astype(float)))


def _shape(path: Path) -> tuple[int, int]:
    frame = car_of(path)["frame"]
    return frame["rows"], frame["columns"]


def r16(path: Path):
    numbers = np.fromfile(path, "<u2").reshape(_shape(path)).astype(float)
    x, y, values = _pictured(path, _height(path, numbers))
    return x, y, values


def r32(path: Path):
    return _pictured(path, np.fromfile(path, "<f4").reshape(_shape(path)))


def tiff32(path: Path):
    return _pictured(path, tifffile.imread(path))


def exr(path: Path):
    import OpenEXR

    with OpenEXR.File(str(path)) as file:
        return _pictured(path, file.channels()["Y"].pixels.copy())


def _points(points: np.ndarray, east: int, north: np.ndarray, up: int):
    x, y = np.unique(points[:, east]), np.unique(north)
    at = np.searchsorted(y, north), np.searchsorted(x, points[:, east])
    heights = np.full((len(y), len(x)), np.nan)
    heights[at] = points[:, up]
    assert not np.isnan(heights).any()
    return x, y, heights


def normals_of(path: Path) -> np.ndarray:
    """The normals that a GLB file states, not those that follow from its triangles."""
    (mesh,) = trimesh.load(path, process=False).geometry.values()
    return mesh.vertex_normals


def y_up(path: Path):
    mesh = trimesh.load(path, force="mesh", process=False)
    assert (mesh.face_normals[:, 1] > 0).all()
    return _points(mesh.vertices, 0, -mesh.vertices[:, 2], 1)


def ply(path: Path):
    mesh = trimesh.load(path, force="mesh", process=False)
    assert (mesh.face_normals[:, 2] > 0).all()
    return _points(mesh.vertices, 0, mesh.vertices[:, 1], 2)


def stl(path: Path):
    """The upper side of the solid, its lowest point brought to zero."""
    mesh = trimesh.load(path)
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert mesh.volume > 0
    bottom = car_of(path)["mesh"]["bottom_below_lowest_m"]
    top = mesh.vertices[mesh.vertices[:, 2] > bottom / 2]
    x, y, heights = _points(top, 0, top[:, 1], 2)
    return x, y, heights - bottom
