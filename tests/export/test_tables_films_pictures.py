"""Tables, films and pictures of a run."""

import csv

import av
import numpy as np
import pytest
from PIL import Image

from barchan.analysis.time_series import measure_series
from barchan.export import export
from barchan.export.writing import opened
from tests.export.scenes import CELL, COLUMNS, SLAB, asymmetric, slabs


@pytest.fixture(scope="module")
def run():
    return asymmetric()


def table(path):
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def test_a_section_along_a_west_wind_is_a_row_of_the_field(run, tmp_path):
    export(run, tmp_path / "section.csv", format="section", fields=["elevation", "sand"])
    rows = table(tmp_path / "section.csv")
    assert list(rows[0]) == ["distance (m)", "x (m)", "y (m)", "elevation (m)", "sand (slabs)"]
    np.testing.assert_allclose([float(row["x (m)"]) for row in rows], (np.arange(COLUMNS) + 0.5) * CELL)
    assert {float(row["y (m)"]) for row in rows} == {3.5 * CELL}
    np.testing.assert_allclose([float(row["elevation (m)"]) for row in rows], slabs(10)[3] * SLAB)
    assert [int(row["sand (slabs)"]) for row in rows] == slabs(10)[3].tolist()


def test_measures_are_a_row_a_frame_with_their_units(run, tmp_path):
    export(run, tmp_path / "measures.csv")
    rows = table(tmp_path / "measures.csv")
    assert [int(row["step"]) for row in rows] == [0, 5, 10]
    assert [float(row["highest_stack (slabs)"]) for row in rows] == [slabs(s).max() for s in (0, 5, 10)]
    series = measure_series(*opened(run))
    assert [float(row["volume (m³)"]) for row in rows] == series["volume"].values.tolist()


def test_a_film_shows_every_frame_north_up(run, tmp_path):
    export(run, tmp_path / "dunes.mp4", pixels=160, frames_per_second=5)
    with av.open(str(tmp_path / "dunes.mp4")) as film:
        assert film.streams.video[0].average_rate == 5
        frames = [frame.to_ndarray(format="rgb24") for frame in film.decode(video=0)]
    assert len(frames) == 3
    height, width, _ = frames[0].shape
    assert (height % 2, width) == (0, 160)
    light = frames[-1].astype(float).mean(axis=-1)
    below = light[height // 2 :, : width // 2]
    assert light.max() == below.max()  # higher sand is lighter, and the hump lies in the south-west


@pytest.mark.parametrize("suffix", [".webp", ".gif"])
def test_films_that_need_no_extra_show_every_frame_north_up(run, tmp_path, suffix):
    export(run, tmp_path / f"dunes{suffix}", pixels=160)
    with Image.open(tmp_path / f"dunes{suffix}") as film:
        assert film.n_frames == 3
        for frame in range(3):
            film.seek(frame)
            light = np.asarray(film.convert("L"), float)
            height, width = light.shape
            assert light.max() == light[height // 2 :, : width // 2].max()  # the hump, in the south-west


def test_a_picture_has_the_size_that_was_asked_for(run, tmp_path):
    export(run, tmp_path / "dunes.png", format="picture", size=(12.7, 10.16), dpi=100)
    with Image.open(tmp_path / "dunes.png") as picture:
        assert picture.size == (500, 400)
