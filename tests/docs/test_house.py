"""The picture of the rooms shows the contract of imports as it is."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "docs" / "_ext"))

from house import PICTURE, drawing


def test_the_picture_of_the_rooms_is_that_of_the_contract():
    assert PICTURE.read_text("utf-8") == drawing(), "run python docs/_ext/house.py"
