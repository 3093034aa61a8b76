"""``barchan show``: pictures of a run."""

from typing import get_args

import pytest
from PIL import Image

from barchan.cli import show, views

VIEWS = {
    "map": "map-20.png",
    "contours": "contours-20.png",
    "oblique": "oblique-20.png",
    "profile": "profile-20.png",
    "space-time": "space-time.png",
    "series": "series.png",
}


def test_every_view_of_the_table_can_be_chosen():
    assert set(get_args(show.View)) == {view.name for view in views.VIEWS}


@pytest.mark.parametrize(("view", "name"), VIEWS.items(), ids=list(VIEWS))
def test_every_view_is_drawn_into_the_runs_folder_and_told(finished, barchan, view, name):
    result = barchan("show", finished, "--view", view)
    assert (result.code, result.err) == (0, "")
    assert result.out == f"{finished / name}\n"
    with Image.open(finished / name) as picture:
        assert min(picture.size) > 300


@pytest.mark.parametrize(("step", "nearest"), [(0, 0), (4, 5), (11, 10), (999, 20)])
def test_the_frame_nearest_to_a_step_is_drawn(finished, barchan, step, nearest):
    assert barchan("show", finished, "--step", step).out == f"{finished / f'map-{nearest}.png'}\n"


@pytest.mark.parametrize("view", ["map", "profile"])
def test_a_picture_of_a_field_is_named_after_it(finished, barchan, view):
    result = barchan("show", finished, "--view", view, "--field", "slope")
    assert (result.out, result.err) == (f"{finished / f'{view}-slope-20.png'}\n", "")


@pytest.mark.parametrize("ending", ["png", "pdf", "svg"])
def test_a_picture_is_of_the_kind_of_its_ending(here, finished, barchan, ending):
    assert barchan("show", finished, "--out", f"picture.{ending}").code == 0
    begins = {"png": b"\x89PNG", "pdf": b"%PDF", "svg": b"<?xml"}[ending]
    assert (here / f"picture.{ending}").read_bytes().startswith(begins)


@pytest.mark.parametrize(
    "words",
    [
        ["--colours", "grey"],
        ["--colours", "red-green", "--no-bare"],
        ["--limits", "0", "4.5"],
        ["--limits", "-1", "4.5"],
        ["--smoothing", "2"],
        ["--view", "contours", "--interval", "0.5"],
        ["--view", "contours", "--count", "3", "--smoothing", "0"],
        ["--view", "profile", "--at", "0"],
        ["--view", "space-time", "--at", "1", "--colours", "grey"],
        ["--view", "oblique", "--angle", "60", "--colours", "perceptual", "--no-bare"],
        ["--no-layers"],
        ["--field", "slope", "--limits", "0", "40", "--smoothing", "1"],
        ["--field", "sand", "--colours", "grey"],
        ["--field", "shadow", "--view", "profile", "--at", "0.5"],
    ],
    ids=" ".join,
)
def test_how_a_picture_is_drawn_can_be_chosen(here, finished, barchan, words):
    result = barchan("show", finished, "--out", "picture.png", *words)
    assert (result.code, result.err) == (0, "")
    assert (here / "picture.png").exists()


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--view", "profile", "--at", "2"], "--at"),
        (["--interval", "0"], "--interval"),
        (["--count", "0"], "--count"),
        (["--smoothing", "-1"], "--smoothing"),
        (["--limits", "3", "1"], "--limits"),
        (
            ["--field", "hop"],
            "no field 'hop'; this run has depth, elevation, flux, ground, sand, shadow, slope",
        ),
        (["--field", "slope", "--view", "series"], "--field slope"),
        (["--interval", "2"], "--interval: --view map does not take it; it takes --step, --colours"),
        (["--view", "profile", "--no-layers"], "--layers: --view profile does not take it"),
        (
            ["--view", "series", "--step", "3"],
            "--step: --view series does not take it; it takes --size, --dpi, --out",
        ),
        (["--field", "slope", "--bare"], "--bare: --view map with --field does not take it"),
        (["--angle", "30"], "--angle: --view map does not take it"),
        (["--view", "oblique", "--angle", "2"], "--angle"),
        (["--size", "1", "9"], "--size"),
        (["--out", "picture.txt"], "cannot write picture.txt"),
        (["--out", "nowhere/picture.png"], "cannot write nowhere/picture.png"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else "",
)
def test_what_cannot_be_drawn_is_a_clear_error(finished, barchan, words, said):
    result = barchan("show", finished, *words)
    assert result.code not in (0, 130)
    assert result.out == ""
    assert said in result.err
    assert "Traceback" not in result.err


def test_a_picture_is_as_large_as_asked(here, finished, barchan):
    """12.7 cm are 5 inches and 7.62 cm are 3: 500 and 300 dots."""
    words = ["--size", "12.7", "7.62", "--dpi", "100", "--out", "picture.png"]
    assert barchan("show", finished, *words).code == 0
    with Image.open(here / "picture.png") as picture:
        assert picture.size == (500, 300)
