"""Images that others made."""

import io

import numpy as np
import pytest
from PIL import Image

from barchan.image_files import image_in

ORIENTATION = 0x0112
TURNED = 6
"""The camera was held on its side: the first row of pixels is the right edge of the picture."""


@pytest.mark.parametrize("kind", ["PNG", "JPEG"])
def test_a_photograph_stands_upright(kind):
    seen = np.zeros((16, 32), np.uint8)
    seen[:8, 16:] = 255  # white at the upper right
    stored = Image.fromarray(np.rot90(seen))
    exif = Image.Exif()
    exif[ORIENTATION] = TURNED
    file = io.BytesIO()
    stored.save(file, kind, exif=exif)
    file.seek(0)
    read = np.asarray(image_in(file, (kind,), 1000))
    assert read.shape == (16, 32)
    np.testing.assert_array_equal(read > 127, seen > 127)
