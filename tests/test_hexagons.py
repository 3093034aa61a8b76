"""Hexagons beside the kernel: where their centres lie, what squares show of them, what files hold."""

import json

import numpy as np
import pytest

import barchan
from barchan.analysis.on_squares import on_squares
from barchan.bed import Bed
from barchan.ground.noise import hills
from barchan.lattice import Lattice
from barchan.measures.filters import sixfold_gradient
from barchan.measures.spacing import dominant_spacing
from barchan.simulation import Simulation
from barchan.squares import Squares, bedforms_of
from barchan.streams import Stream

HEX = Lattice(kind="hex", rows=20, columns=24, cell_size=2.0)
OPEN = HEX.model_copy(update={"boundary_x": "open", "boundary_y": "open"})


def test_six_centres_lie_at_the_distance_of_a_cell_and_cells_fill_the_field():
    x, y = HEX.centres
    away = np.hypot(x - x[9, 9], y - y[9, 9])
    assert np.sort(away.ravel())[:8] == pytest.approx([0.0, *[2.0] * 6, 2.0 * np.sqrt(3)])
    assert HEX.cells * HEX.cell_area == pytest.approx(HEX.width * HEX.height)


def test_squares_show_a_plane_as_it_is():
    x, y = OPEN.centres
    squares = Squares(OPEN)
    shown = squares.between(3.0 * x - 2.0 * y)
    height = OPEN.height / squares.lattice.rows
    at = np.arange(squares.lattice.rows) * height + height / 2
    expected = 3.0 * squares.lattice.x - 2.0 * at[:, None]
    np.testing.assert_allclose(shown[1:-1, 1:-1], expected[1:-1, 1:-1])


def test_squares_show_counts_of_the_nearest_hexagon():
    squares, numbers = Squares(HEX), np.arange(HEX.cells).reshape(HEX.shape)
    shown = squares.between(numbers)
    x, y = HEX.centres
    height = HEX.height / squares.lattice.rows
    for row, col in ((0, 0), (3, 5), (9, 11), (16, 23)):
        east = np.abs(x - squares.lattice.x[col])
        north = np.abs(y - (row + 0.5) * height)
        away = np.hypot(np.minimum(east, HEX.width - east), np.minimum(north, HEX.height - north))
        assert away.flat[shown[row, col]] == pytest.approx(away.min())


def test_the_mean_of_a_field_is_kept_on_squares():
    field = np.random.default_rng(1).random(HEX.shape)
    assert Squares(HEX).between(field).mean() == pytest.approx(field.mean(), abs=0.02)


def test_the_plane_through_six_neighbours_has_the_slopes_of_a_plane():
    x, y = OPEN.centres
    east, north = sixfold_gradient(0.3 * x + 0.1 * y, OPEN.cell_size, OPEN.periodic)
    np.testing.assert_allclose(east[1:-1, 1:-1], 0.3)
    np.testing.assert_allclose(north[1:-1, 1:-1], 0.1)


@pytest.mark.parametrize("along", [True, False])
def test_the_spacing_of_waves_on_hexagons_is_their_true_one(along):
    """Eight waves between joined edges, across or along the rows."""
    lattice = Lattice(kind="hex", rows=128, columns=112)
    x, y = lattice.centres
    place, length = (x, lattice.width) if along else (y, lattice.height)
    bed = Bed(lattice, 5.0 + np.sin(2 * np.pi * 8 * place / length), np.zeros(lattice.shape, np.int32))
    bed = Bed(lattice, np.zeros(lattice.shape), np.rint(bed.ground / lattice.thickness).astype(np.int32))
    spacing = dominant_spacing(bedforms_of(bed), 1.0, 270.0 if along else 180.0)
    assert spacing == pytest.approx(length / 8, rel=0.02)


def test_random_hills_are_the_same_hills_at_the_centres_of_shifted_rows():
    """Odd rows hold what Fourier's series of the same waves has half a cell farther east."""
    random_hex = hills(HEX, Stream(3, "ground"), 8.0)
    odd, beside = random_hex[1], (random_hex[0] + random_hex[2]) / 2
    between = (beside + np.roll(beside, -1)) / 2  # half a cell farther east than even rows' centres
    assert np.abs(odd - between).max() < 0.25 * np.abs(odd - np.roll(between, 3)).max()


def small(**changes):
    data = {
        "barchan": 5,
        "lattice": {"kind": "hex", "rows": 18, "columns": 16},
        "sand": {"kind": "dropped", "mean": 3.0},
        "model": {"name": "werner"},
        "run": {"steps": 2, "seed": 4, "save_every": 1},
    }
    return barchan.load(data, **changes)


@pytest.fixture(scope="module")
def frames():
    return barchan.simulate(small())


def test_frames_hold_hexagons_and_where_their_centres_lie(frames):
    assert frames.sizes["y"] == 18
    assert frames["centre_x"].dims == ("y", "x")
    assert frames["centre_x"].values[:2, 0].tolist() == [0.5, 1.0]
    assert (frames.attrs["lattice"], frames.attrs["shift_of_odd_rows"]) == ("hex", 0.5)
    assert frames.attrs["row_spacing"] == pytest.approx(np.sqrt(0.75))


def test_an_archive_of_hexagons_is_read_as_it_was_written(frames, tmp_path):
    barchan.run(Simulation(small()), tmp_path / "run")
    with barchan.open_run(tmp_path / "run") as run:
        for name in ("centre_x", "x", "y", "sand"):
            np.testing.assert_array_equal(run[name].values, frames[name].values)


def test_pictures_see_squares(frames):
    scenario = small()
    squared, shown = on_squares(frames.isel(step=-1), scenario)
    assert squared["elevation"].shape == shown.lattice.shape == (16, 16)
    assert on_squares(squared, shown)[0] is squared
    for view in (None, "shadow", "slope"):
        assert frames.barchan.plot(view).get_axes()[0].get_aspect() == 1.0


def test_exports_are_squares_and_say_that_they_were_hexagons(frames, tmp_path):
    frames.barchan.export(tmp_path / "dunes.nc", fields=["elevation", "shadow"])
    told = json.loads((tmp_path / "dunes.nc.json").read_text("utf-8"))
    assert told["frame"]["rows"] * told["frame"]["cell_height_m"] == pytest.approx(18 * np.sqrt(0.75))
    assert told["changes"]["brought_from_hexagons"]["rows"] == 18


@pytest.mark.parametrize("name", ["dunes.ply", "dunes.glb", "dunes.tif", "dunes.png"])
def test_meshes_and_maps_of_hexagons_have_their_squares(frames, tmp_path, name):
    if name.endswith("tif"):
        pytest.importorskip("rasterio")
    frames.barchan.export(tmp_path / name)
    told = json.loads((tmp_path / f"{name}.json").read_text("utf-8"))
    assert (told["frame"]["rows"], told["frame"]["columns"]) == (16, 16)


def test_text_grids_that_know_only_squares_refuse_those_over_hexagons(frames, tmp_path):
    with pytest.raises(barchan.BarchanError, match=r"no whole number of squares .* export \.tif or \.nc"):
        frames.barchan.export(tmp_path / "dunes.asc")


def test_the_volume_of_a_run_on_hexagons_is_that_of_its_slabs(frames):
    measured = frames.barchan.measures()
    slabs = frames["sand"].sum(("y", "x")).values
    np.testing.assert_allclose(measured["volume"].values, slabs / 3 * np.sqrt(0.75))
