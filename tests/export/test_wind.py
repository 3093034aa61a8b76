"""The wind in files for ParaView, as VTK's own readers find it."""

import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy

import barchan
from barchan.archive import dataset_of
from barchan.export import export
from tests.export import readers
from tests.export.scenes import COLUMNS, ROWS, asymmetric, told_of
from tests.tiny import DATA

SNOW = {"name": "snow", "drift": {"friction": "log", "roughness": 0.5e-3}}
FROM_SOUTH_WEST = np.sqrt(0.5) * np.array([1.0, 1.0, 0.0])
"""Where a wind from 225° blows: to the north-east."""


def image_of(path, time=None):
    if path.suffix == ".vti":
        reader = readers.vtkXMLImageDataReader()
        reader.SetFileName(str(path))
        reader.Update()
        return reader.GetOutput()
    reader = readers.vtkHDFReader()
    reader.SetFileName(str(path))
    times = readers.vtk_times(reader)
    reader.UpdateTimeStep(times[-1] if time is None else time)
    return reader.GetOutput()


def whole(image, name):
    """Data of the whole field."""
    return vtk_to_numpy(image.GetFieldData().GetArray(name)).reshape(-1)


def at_points(image, name):
    return vtk_to_numpy(image.GetPointData().GetArray(name)).reshape(ROWS, COLUMNS, -1).squeeze()


@pytest.fixture(scope="module")
def bishop():
    """Frames of a model whose hops grow with height, under a wind from the south-west."""
    return told_of(asymmetric(), (225.0, 225.0, 225.0), wind__direction=225.0, model={"name": "bishop"})


@pytest.mark.parametrize("suffix", [".vtkhdf", ".vti"])
def test_the_wind_of_a_frame_points_where_it_blows(bishop, tmp_path, suffix):
    path = tmp_path / f"dunes{suffix}"
    export(bishop, path)
    image = image_of(path)
    np.testing.assert_allclose(whole(image, "wind"), FROM_SOUTH_WEST, atol=1e-12)
    assert whole(image, "wind_from") == [225.0]
    assert image.GetFieldData().GetArray("wind_friction_velocity") is None
    assert readers.car_of(path)["wind"]["unit"] == "1"


@pytest.mark.parametrize("suffix", [".vtkhdf", ".vti"])
def test_a_field_along_the_wind_is_written_as_a_vector_too(bishop, tmp_path, suffix):
    path = tmp_path / f"dunes{suffix}"
    export(bishop, path, fields="elevation,hop,shadow")
    image = image_of(path)
    hop, vector = at_points(image, "hop"), at_points(image, "hop_vector")
    assert hop.max() > hop.min() >= 0.0
    np.testing.assert_allclose(vector, hop[..., None] * FROM_SOUTH_WEST, rtol=1e-6)
    assert np.unravel_index(hop.argmax(), hop.shape) == (3, 4)
    assert image.GetPointData().GetArray("shadow_vector") is None


def test_each_frame_has_its_own_wind(tmp_path):
    run = told_of(asymmetric(), (270.0, 270.0, 180.0))
    export(run, tmp_path / "dunes.vtkhdf")
    export(run, tmp_path / "dunes.pvd")
    for step, towards in ((5.0, [1.0, 0.0, 0.0]), (10.0, [0.0, 1.0, 0.0])):
        frames = image_of(tmp_path / "dunes.vtkhdf", step)
        alone = image_of(tmp_path / "dunes_frames" / f"{int(step):02d}.vti")
        for image in (frames, alone):
            np.testing.assert_allclose(whole(image, "wind"), towards, atol=1e-12)


def test_snow_has_the_friction_velocity_over_its_relief(tmp_path):
    """On flat snow it is the same everywhere: 0.4 × 9 m/s / ln(10 m / 0.5 mm) by the law of the wall."""
    wind = {"kind": "steady", "direction": 270.0, "speed": 9.0, "unit": "m/s"}
    scenario = barchan.load(DATA, model=SNOW, sand={"kind": "flat", "mean": 50}, wind=wind)
    simulation = barchan.Simulation(scenario)
    run = dataset_of(simulation, [simulation.frame()])
    export(run, tmp_path / "snow.vti", fields="elevation,friction_velocity")
    image = image_of(tmp_path / "snow.vti")
    field = vtk_to_numpy(image.GetPointData().GetArray("friction_velocity"))
    np.testing.assert_allclose(whole(image, "wind"), [9.0, 0.0, 0.0], atol=1e-12)
    assert readers.car_of(tmp_path / "snow.vti")["wind"]["unit"] == "m/s"
    expected = 0.4 * 9.0 / np.log(10.0 / 0.5e-3)
    np.testing.assert_allclose(whole(image, "wind_friction_velocity"), expected, rtol=1e-6)
    np.testing.assert_allclose(field, expected, rtol=1e-6)
    vectors = vtk_to_numpy(image.GetPointData().GetArray("friction_velocity_vector"))
    np.testing.assert_allclose(vectors, np.outer(field, [1.0, 0.0, 0.0]), atol=1e-7)
