"""Codes for missing heights that a file does not declare: asked about, never taken as ground."""

import numpy as np
import pytest

from barchan.errors import ScenarioError
from barchan.ground.sand import FileSand
from barchan.ground.surface import FileGround
from barchan.ground.voids import suspects
from barchan.lattice import Lattice
from barchan.streams import Stream

LATTICE = Lattice(rows=12, columns=16, cell_size=2.0)
STREAM = Stream(1, "ground")
SLOPE = 100.0 + 0.25 * np.arange(12.0)[:, None] + 0.125 * np.arange(16.0)
"""A plane, exact in single precision; a membrane over a hole in it is the plane itself."""


@pytest.fixture
def write(tmp_path):
    def save(heights, name="dem.npy"):
        np.save(tmp_path / name, heights)
        return str(tmp_path / name)

    return save


def elevation(path, **more):
    return FileGround(path=path, **more).elevation(LATTICE, STREAM)


def refused(path, **more):
    with pytest.raises(ScenarioError) as caught:
        elevation(path, **more)
    (problem,) = caught.value.problems
    return problem.message.partition(": ")[2]


def with_hole(value, kind="float32"):
    heights = SLOPE.astype(kind)
    heights[3:6, 4:8] = value
    return heights


CODES = [
    ("float32", -9999.0, "-9999"),
    ("int16", -32768, "-32768"),
    ("int16", 32767, "32767"),
    ("float32", -3.4028235e38, "-3.40282347e+38"),
    ("float32", 3.4028235e38, "3.40282347e+38"),
    ("float32", 1e20, "1.00000002e+20"),
    ("float64", 9.96921e36, "9.96921e+36"),
    ("float32", -9999.9, "-9999.90039"),
    ("int32", -2147483648, "-2.14748365e+09"),
]


@pytest.mark.parametrize(("kind", "value", "said"), CODES)
def test_a_hole_of_a_code_is_asked_about_with_the_key_that_answers(write, kind, value, said):
    path = write(with_hole(value, kind))
    message = refused(path)
    assert message.startswith(f"has 12 cells of {said}, which looks like a code for cells without a value")
    assert f"state missing [{said}] if it is one" in message
    assert refused(path, missing=float(said)).startswith("has 12 of 192 cells without a value")
    filled = elevation(path, missing=[float(said)], fill="interpolate")
    np.testing.assert_allclose(filled, SLOPE.astype(kind), atol=0.75 if kind.startswith("int") else 1e-9)


def test_a_collar_of_zero_around_a_plateau_is_asked_about(write):
    heights = SLOPE + np.random.default_rng(1).normal(0, 1.0, SLOPE.shape)
    heights[:2], heights[:, -3:] = 0.0, 0.0  # 2 rows of 16 and 3 of the other 10
    assert refused(write(heights)).startswith("has 62 cells of 0, which looks like a code")
    assert elevation(write(heights), missing=[]).min() == 0.0
    assert elevation(write(heights), missing=0, fill="interpolate").min() > 95.0


def test_a_single_spike_is_asked_about(write):
    heights = SLOPE.copy()
    heights[5, 5] = 1500.0
    assert refused(write(heights)).startswith("has a cell of 1500, which")


def test_two_codes_are_named_together(write):
    heights = with_hole(-9999.0)
    heights[8, 8] = -32768
    assert "has a cell of -32768 and 12 cells of -9999, which" in refused(write(heights))
    assert elevation(write(heights), missing=[-9999, -32768], fill="interpolate").min() == 100.0


def sea_cliff():
    """A sea at exactly zero below a cliff of 60 m that comes down to a beach."""
    land = np.full((12, 16), 60.0)
    land[:, :6] = 0.0
    land[-1, 6:9] = [0.5, 6.0, 30.0]
    return land


def tower():
    block = np.zeros((12, 16))
    block[4:8, 6:9] = 30.0
    return block


HONEST = {
    "a plane": SLOPE,
    "a sea with a cliff": sea_cliff(),
    "a tower 15 cells high": tower(),
    "level": np.zeros((12, 16)),
    "a deep basin": np.hypot(*np.mgrid[-6:6, -8:8]) * 300 - 9000,
    "an ocean trench": np.linspace(-10_900, -3_000, 192).reshape(12, 16),
    "rough": np.random.default_rng(4).normal(0, 50, (12, 16)),
}


@pytest.mark.parametrize("name", HONEST)
def test_honest_ground_is_not_doubted(write, name):
    np.testing.assert_array_equal(elevation(write(HONEST[name])), HONEST[name])


def test_black_and_white_of_an_image_are_heights(tmp_path):
    from PIL import Image

    pixels = np.zeros((12, 16), np.uint16)
    pixels[5, 5] = 65535
    Image.fromarray(pixels).save(tmp_path / "a.png")
    assert elevation(str(tmp_path / "a.png"), lowest=0.0, highest=900.0).max() == 900.0


def test_depths_of_sand_are_doubted_too(write):
    path = write(np.where(with_hole(-9999.0) < 0, -9999, 3))
    with pytest.raises(ScenarioError, match=r"sand\.path: .* has 12 cells of -9999, which looks like a code"):
        FileSand(path=path).slabs(LATTICE, SLOPE, STREAM)


def test_heights_are_judged_in_metres():
    """−20 000 cm are −200 m, a height; −20 000 km are none."""
    heights = np.full((4, 4), -20_000.0)
    assert suspects(heights, 0.01, 2.0) == []
    assert suspects(heights, 1000.0, 2.0) == [(-20_000.0, 16)]
