"""Ripples are laid over a dune and drawn."""

import runpy
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

EXAMPLE = Path(__file__).parents[2] / "examples" / "ripples_on_dune.py"


def test_the_picture_is_drawn(tmp_path, monkeypatch, capsys):
    picture = tmp_path / "dune.png"
    options = ["--size", "32", "--steps", "20", "--ripple-steps", "20", "--dpi", "40"]
    monkeypatch.setattr(sys, "argv", [str(EXAMPLE), str(picture), *options])
    runpy.run_path(str(EXAMPLE), run_name="__main__")
    assert "times real ones" in capsys.readouterr().out
    with Image.open(picture) as image:
        assert image.width > 200


def test_its_ripples_are_scaled_to_their_cells_and_their_index():
    example = runpy.run_path(str(EXAMPLE))
    fine, coarse = (example["ripples"](16, 30, cell_size) for cell_size in (0.1, 0.2))
    assert coarse[1] == pytest.approx(2 * fine[1])
    for relief, spacing in (fine, coarse):
        assert spacing / (2 * np.sqrt(2) * relief.std()) == pytest.approx(example["RIPPLE_INDEX"])
