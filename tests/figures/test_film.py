"""Films hold every frame of a run, north up."""

import numpy as np
import pytest
from PIL import Image

from barchan.entry import simulate
from barchan.errors import BarchanError
from barchan.figures.film import film
from tests.tiny import COLUMNS, ROWS, tiny


@pytest.fixture(scope="module")
def dataset():
    """Frames of a run in which sand moves."""
    return simulate(tiny())


@pytest.mark.parametrize("name", ["film.webp", "film.gif"])
@pytest.mark.parametrize("follow", [False, True])
def test_a_film_has_every_frame_of_its_run(tmp_path, dataset, name, follow):
    film(dataset, tiny(), tmp_path / name, frames_per_second=10, pixels=48, follow=follow)
    with Image.open(tmp_path / name) as picture:
        assert picture.format == name.split(".")[1].upper()
        assert picture.n_frames == 5
        assert picture.size == (2 * COLUMNS, 2 * ROWS)
    assert [path.name for path in tmp_path.iterdir()] == [name]


@pytest.mark.parametrize("name", ["film.webp", "film.gif"])
def test_frames_last_as_long_as_asked(tmp_path, dataset, name):
    film(dataset, tiny(), tmp_path / name, frames_per_second=5, pixels=48)
    with Image.open(tmp_path / name) as picture:
        durations = []
        for number in range(5):
            picture.seek(number)
            picture.load()
            durations.append(picture.info["duration"])
    assert durations == [200] * 5


@pytest.mark.parametrize(
    ("rows", "columns", "corner"),
    [
        (slice(0, 5), slice(0, 8), (0.1, 0.9)),
        (slice(11, 16), slice(0, 8), (0.1, 0.1)),
        (slice(0, 5), slice(16, 24), (0.9, 0.9)),
        (slice(11, 16), slice(16, 24), (0.9, 0.1)),
    ],
    ids=["south-west", "north-west", "south-east", "north-east"],
)
def test_sand_appears_in_its_corner_of_the_picture(tmp_path, dataset, rows, columns, corner):
    painted = dataset.copy(deep=True)
    painted["sand"][...] = 0
    painted["sand"][:, rows, columns] = 5
    painted["elevation"][...] = painted["sand"] / 3
    film(painted, tiny(), tmp_path / "film.webp", pixels=240)
    with Image.open(tmp_path / "film.webp") as picture:
        colours = np.asarray(picture.convert("RGB"), float)
    right, down = corner
    height, width, _ = colours.shape
    greyness = {
        (x, y): np.ptp(colours[int(y * height), int(x * width)]) for x in (0.1, 0.9) for y in (0.1, 0.9)
    }
    assert max(greyness, key=greyness.get) == (right, down)
    assert sum(grey > 40 for grey in greyness.values()) == 1


def test_a_film_of_another_kind_is_refused_before_any_work(tmp_path, dataset):
    with pytest.raises(BarchanError, match=r"film\.avi: a film is \.webp or \.gif or \.mp4, not '\.avi'"):
        film(dataset, tiny(), tmp_path / "film.avi")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", ["film.WEBP", "film.Gif"])
def test_the_case_of_an_ending_makes_no_difference(tmp_path, dataset, name):
    film(dataset, tiny(), tmp_path / name, pixels=48)


def test_a_film_that_cannot_be_written_is_a_clear_error(tmp_path, dataset):
    with pytest.raises(BarchanError, match="cannot write"):
        film(dataset, tiny(), tmp_path / "nowhere" / "film.gif", pixels=48)


def test_progress_is_reported_of_every_frame(tmp_path, dataset):
    reported = []
    film(dataset, tiny(), tmp_path / "film.gif", pixels=48, progress=reported.append)
    assert reported == [1, 2, 3, 4, 5]


@pytest.mark.parametrize("name", ["film.webp", "film.gif"])
def test_a_run_of_one_frame_makes_a_film_of_one_frame(tmp_path, dataset, name):
    film(dataset.isel(step=slice(1)), tiny(), tmp_path / name, pixels=48)
    with Image.open(tmp_path / name) as picture:
        assert picture.n_frames == 1


def test_with_a_held_scale_one_height_has_one_colour_in_all_frames(tmp_path, dataset):
    """Level beds of 1, 2 and 3 slabs; with a scale of its own each frame would look the same."""
    levels = dataset.isel(step=slice(3)).copy(deep=True)
    for number in range(3):
        levels["sand"][number] = number + 1
    levels["elevation"][...] = levels["sand"] / 3

    def colours(follow):
        film(levels, tiny(), tmp_path / "film.webp", pixels=48, follow=follow)
        with Image.open(tmp_path / "film.webp") as picture:
            count = picture.n_frames
            return count, np.asarray(picture.convert("RGB"), float)[0, 0]

    assert colours(follow=False)[0] == 3
    assert colours(follow=True)[0] == 1
