"""``barchan film``: an animated picture of a run."""

import pytest
from PIL import Image


def test_a_film_is_written_into_the_runs_folder_and_told(finished, barchan):
    result = barchan("film", finished, "--pixels", "48")
    assert (result.code, result.err) == (0, "")
    assert result.out == f"{finished / 'film.webp'}\n"
    with Image.open(finished / "film.webp") as film:
        assert film.n_frames == 5


def test_a_film_goes_where_it_is_asked_to(here, finished, barchan):
    words = [
        "--out",
        "dunes.gif",
        "--frames-per-second",
        "5",
        "--follow",
        "--colours",
        "grey",
        "--smoothing",
        "1",
        "--no-layers",
    ]
    assert barchan("film", finished, "--pixels", "48", *words).code == 0
    with Image.open(here / "dunes.gif") as film:
        assert (film.format, film.n_frames) == ("GIF", 5)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--out", "dunes.avi"], "a film is .webp or .gif or .mp4, not '.avi'"),
        (["--frames-per-second", "0"], "--frames-per-second"),
        (["--pixels", "0"], "--pixels"),
        (["--smoothing", "-1"], "--smoothing"),
    ],
    ids=["ending", "speed", "size", "smoothing"],
)
def test_what_cannot_be_filmed_is_a_clear_error(finished, barchan, words, said):
    result = barchan("film", finished, *words)
    assert result.code not in (0, 130)
    assert result.out == ""
    assert said in result.err
    assert "Traceback" not in result.err


def test_a_place_where_nothing_can_be_written_is_a_clear_error(finished, barchan):
    assert barchan("film", finished, "--out", "nowhere/dunes.gif", "--pixels", "48").code == 1
