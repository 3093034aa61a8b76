"""The diagram of dune types is drawn from runs."""

import runpy
import sys
from pathlib import Path

import pytest
from PIL import Image

EXAMPLE = Path(__file__).parents[2] / "examples" / "dune_types.py"


def test_the_diagram_is_drawn(tmp_path, monkeypatch):
    picture = tmp_path / "diagram.png"
    options = ["--size", "16", "--steps", "10", "--turn", "2", "--dpi", "40"]
    monkeypatch.setattr(sys, "argv", [str(EXAMPLE), str(picture), *options])
    runpy.run_path(str(EXAMPLE), run_name="__main__")
    with Image.open(picture) as image:
        assert min(image.size) > 200


def test_its_winds_reach_from_steady_to_complex():
    example = runpy.run_path(str(EXAMPLE))
    steadiness = []
    for directions in example["WINDS"].values():
        scenario = example["scene"](5, directions, 16, 50 * len(directions), 25)
        steadiness.append(example["scenario_drift"](scenario).steadiness)
    assert steadiness == pytest.approx([1.0, 0.75**0.5, 0.5, 0.0], abs=1e-9)
