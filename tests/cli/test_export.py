"""``barchan export``: frames of a run for other programs."""

import numpy as np
import pytest


def test_the_files_that_were_written_are_told(here, finished, barchan):
    result = barchan("export", finished, "dunes.r32")
    assert (result.code, result.err) == (0, "")
    assert result.out == "dunes.r32\ndunes.r32.json\n"
    assert (here / "dunes.r32").stat().st_size == 16 * 24 * 4


def test_steps_fields_and_changes_are_options(here, finished, barchan):
    words = [
        "--step",
        "5,20",
        "--fields",
        "elevation,slope",
        "--smooth",
        "1",
        "--cells",
        "48",
        "32",
        "--close",
    ]
    result = barchan("export", finished, "dunes.r32", *words)
    assert result.out.split() == [
        "dunes-elevation-05.r32",
        "dunes-slope-05.r32",
        "dunes-elevation-20.r32",
        "dunes-slope-20.r32",
        "dunes.r32.json",
    ]
    values = np.fromfile(here / "dunes-elevation-20.r32", "<f4").reshape(33, 49)
    np.testing.assert_array_equal(values[0], values[-1])


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["dunes.xyz"], "no format is written to '.xyz'"),
        (["dunes.nc", "--step", "soon"], "--step soon: allowed: a saved step"),
        (["dunes.nc", "--step", "7"], "step 7 was not saved; near it are"),
        (["dunes.nc", "--fields", "shadw"], "did you mean 'shadow'"),
        (["dunes.nc", "--flip"], "--flip: netcdf does not take it"),
    ],
    ids=["suffix", "step", "unsaved", "field", "option"],
)
def test_what_cannot_be_exported_is_a_clear_error(here, finished, barchan, words, said):
    result = barchan("export", finished, *words)
    assert (result.code, result.out) == (1, "")
    assert said in result.err
    assert sorted(path.name for path in here.iterdir()) == ["tiny", "tiny.json"]


@pytest.mark.parametrize("suffix", [".tif", ".nc", ".stl", ".TIFF"])
def test_no_picture_is_drawn_under_the_name_of_data(here, finished, barchan, suffix):
    result = barchan("show", finished, "--out", f"dunes{suffix}")
    assert result.code == 1
    assert f"barchan export RUN dunes{suffix}" in result.err
    assert not (here / f"dunes{suffix}").exists()
