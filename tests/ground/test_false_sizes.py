"""Files that declare more than they hold, or more than anyone needs, are refused before they are read."""

import io

import numpy as np
import pytest
from numpy.lib import format as layout

from barchan.ground.raster import UnreadableError
from barchan.ground.reading import read
from tests.false_images import false_jpeg, false_png


def test_an_array_whose_heading_promises_more_than_the_file_holds_is_refused(tmp_path):
    """Size: 10⁶ × 10⁶ numbers of 8 bytes are 8 · 10¹² bytes; the file has 800 after its heading."""
    content = io.BytesIO()
    layout.write_array_header_1_0(content, {"descr": "<f8", "fortran_order": False, "shape": (10**6, 10**6)})
    content.write(b"\0" * 800)
    (tmp_path / "lie.npy").write_bytes(content.getvalue())
    with pytest.raises(
        UnreadableError, match=r"1000000 × 1000000 numbers, 8,000,000,000,000 bytes.*holds 800"
    ):
        read(tmp_path / "lie.npy")


def test_an_array_is_read_as_it_was_written(tmp_path):
    values = np.asfortranarray(np.arange(12.0).reshape(3, 4))
    np.save(tmp_path / "a.npy", values)
    assert np.array_equal(read(tmp_path / "a.npy").values, values)


def test_an_image_of_too_many_pixels_is_refused_by_its_heading(tmp_path):
    from PIL import Image

    Image.new("L", (8193, 8192)).save(tmp_path / "many.png", compress_level=1)
    with pytest.raises(UnreadableError, match="8193 × 8192 pixels; allowed: as many as 8192 × 8192"):
        read(tmp_path / "many.png")


@pytest.mark.parametrize(("name", "made"), [("huge.png", false_png), ("huge.jpg", false_jpeg)])
@pytest.mark.parametrize("side", [12_000, 20_000])
@pytest.mark.filterwarnings("error")
def test_a_huge_image_is_refused_in_our_words(tmp_path, name, made, side):
    """12 000² is where Pillow warns by itself; 20 000² it refuses without its size."""
    (tmp_path / name).write_bytes(made(side, side))
    with pytest.raises(UnreadableError) as caught:
        read(tmp_path / name)
    size = f"{side} × {side}" if side < 13_000 else "more than 178956970"
    assert str(caught.value) == f"has {size} pixels; allowed: as many as 8192 × 8192"


@pytest.mark.parametrize(
    "content", [b"", b"no image", false_png(3, 3)[:20], false_png(3, 3), false_jpeg(3, 3)]
)
def test_a_damaged_image_is_refused_without_the_path_of_the_file(tmp_path, content):
    (tmp_path / "bad.png").write_bytes(content)
    with pytest.raises(UnreadableError, match="cannot be read as an image") as caught:
        read(tmp_path / "bad.png")
    assert str(tmp_path) not in str(caught.value)


def test_an_elevation_model_of_too_many_cells_is_refused_by_its_heading(tmp_path):
    rasterio = pytest.importorskip("rasterio")
    with rasterio.open(
        tmp_path / "many.tif",
        "w",
        driver="GTiff",
        width=20_000,
        height=20_000,
        count=1,
        dtype="uint8",
        crs="EPSG:32633",
        transform=rasterio.Affine(1, 0, 5e5, 0, -1, 4e6),
        SPARSE_OK=True,
    ):
        pass
    with pytest.raises(UnreadableError, match="20000 × 20000 cells"):
        read(tmp_path / "many.tif")
