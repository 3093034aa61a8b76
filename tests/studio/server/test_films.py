"""Films of pictures that come one by one: read back, refused, given up."""

import io

import pytest
from PIL import Image

from barchan.errors import BarchanError
from barchan.studio.server import films
from barchan.studio.server.films import Films
from barchan.studio.server.workspace import Workspace
from tests.false_images import false_png


def picture(shade, size=(32, 24), kind="PNG"):
    file = io.BytesIO()
    Image.new("RGB", size, (shade, shade, shade)).save(file, kind)
    return file.getvalue()


@pytest.fixture
def made(tmp_path):
    return Films(Workspace(tmp_path))


def test_a_film_shows_its_pictures_in_their_order_at_its_rate(made, tmp_path):
    """Grey of 0, 60, 120, 180, 240 at 10 a second: 100 ms each."""
    number = made.begin("dunes.webp", 10.0)
    assert [made.film(number).add(picture(shade)) for shade in range(0, 241, 60)] == [1, 2, 3, 4, 5]
    assert made.finish(number) == f"{number}/dunes.webp"
    with Image.open(tmp_path / "studio-exports" / number / "dunes.webp") as film:
        assert film.n_frames == 5
        for at, shade in enumerate(range(0, 241, 60)):
            film.seek(at)
            assert film.convert("RGB").getpixel((16, 12))[0] == pytest.approx(shade, abs=4)
            assert film.info["duration"] == 100


def test_of_a_film_that_is_given_up_nothing_is_left(made, tmp_path):
    number = made.begin("dunes.webp", 10.0)
    for shade in range(10):
        made.film(number).add(picture(shade))
    made.give_up()
    assert list((tmp_path / "studio-exports").iterdir()) == []
    with pytest.raises(BarchanError, match="no film"):
        made.film(number)


def test_another_film_takes_the_place_of_one_that_was_not_finished(made, tmp_path):
    first = made.begin("first.webp", 10.0)
    made.film(first).add(picture(0))
    second = made.begin("second.webp", 10.0)
    made.film(second).add(picture(0))
    made.finish(second)
    assert [path.name for path in (tmp_path / "studio-exports").rglob("*.*")] == ["second.webp"]


@pytest.mark.parametrize("data", [b"", b"no picture", picture(0)[:50], picture(0, kind="GIF")])
def test_what_is_no_picture_is_refused_and_the_film_goes_on(made, data):
    number = made.begin("dunes.webp", 10.0)
    with pytest.raises(BarchanError, match="no picture"):
        made.film(number).add(data)
    assert made.film(number).add(picture(9)) == 1
    made.give_up()


def test_pictures_of_several_sizes_make_no_film(made):
    number = made.begin("dunes.webp", 10.0)
    made.film(number).add(picture(0))
    with pytest.raises(BarchanError, match="33 × 24 pixels in a film of 32 × 24"):
        made.film(number).add(picture(0, (33, 24)))
    made.give_up()


def test_a_picture_of_too_many_pixels_is_refused_before_it_is_unpacked(made, monkeypatch):
    monkeypatch.setattr(films, "MOST_PIXELS", 32 * 24 - 1)
    number = made.begin("dunes.webp", 10.0)
    with pytest.raises(BarchanError, match="allowed"):
        made.film(number).add(picture(0))
    made.give_up()


def test_a_picture_that_claims_a_huge_size_is_refused_in_our_words(made):
    number = made.begin("dunes.webp", 10.0)
    with pytest.raises(BarchanError, match="more than 178956970 pixels; allowed: as many as 4096 × 4096"):
        made.film(number).add(false_png(20_000, 20_000))
    made.give_up()


@pytest.mark.parametrize(
    ("name", "rate"), [("dunes.exe", 10.0), ("../dunes.webp", 10.0), ("dunes.webp", 0.0), ("dunes.webp", 1e9)]
)
def test_other_names_and_rates_are_refused(made, name, rate):
    with pytest.raises(BarchanError, match=r"allowed|a film is"):
        made.begin(name, rate)


def test_a_film_that_cannot_be_written_says_so(made, monkeypatch):
    def broken(path, pictures, rate):
        raise OSError("no room on the disk")

    monkeypatch.setattr("barchan.figures.film.encode", broken)
    number = made.begin("dunes.webp", 10.0)
    made.film(number)._thread.join()
    with pytest.raises(BarchanError, match="no room on the disk"):
        made.film(number).add(picture(0))
    made.give_up()


def test_a_film_without_pictures_is_refused(made):
    with pytest.raises(BarchanError, match="without pictures"):
        made.finish(made.begin("dunes.webp", 10.0))
    made.give_up()
