"""The small pictures of presets in the gallery: ``python -m barchan.studio.pictures [NAME …]`` draws them.

Each preset runs to its end, or for PATIENCE seconds at most; the maps are those of ``barchan show``.
"""

import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.colors import Normalize
from PIL import Image

from barchan.archive import dataset_of
from barchan.figures.maps import shaded, surface_range
from barchan.figures.style import SMOOTHING
from barchan.scenario import Scenario, load_scenario, preset_names
from barchan.simulation import Simulation

if TYPE_CHECKING:
    import xarray as xr

FOLDER = Path(__file__).parents[1] / "presets" / "pictures"
WIDTH, HEIGHT = 320, 200
SEED = 1
PATIENCE = 120.0
"""Seconds that a preset may run, at most."""


def last_frame(scenario: Scenario) -> "xr.Dataset":
    """The last frame of a scenario, or that after ``PATIENCE`` seconds."""
    simulation = Simulation(scenario)
    began = time.monotonic()
    while not simulation.done and time.monotonic() - began < PATIENCE:
        simulation.advance(min(20, scenario.run.steps - simulation.steps_done))
    return dataset_of(simulation, [simulation.frame()]).isel(step=0)


def picture(frame: "xr.Dataset", scenario: Scenario) -> Image.Image:
    """The map of a frame, cut to the gallery's format."""
    norm = Normalize(*surface_range(frame, scenario))
    colours = shaded(frame, scenario, norm=norm, smoothing=SMOOTHING)[::-1]
    image = Image.fromarray((colours * 255).round().astype(np.uint8))
    scale = max(WIDTH / image.width, HEIGHT / image.height)
    size = (max(WIDTH, round(image.width * scale)), max(HEIGHT, round(image.height * scale)))
    left, top = (size[0] - WIDTH) // 2, (size[1] - HEIGHT) // 2
    resized = image.resize(size, Image.Resampling.LANCZOS)
    return resized.crop((left, top, left + WIDTH, top + HEIGHT))


def draw(names: list[str]) -> None:
    """Draw the pictures of these presets, or of all."""
    FOLDER.mkdir(exist_ok=True)
    for name in names or preset_names():
        scenario = load_scenario(name, [("run.seed", str(SEED))])
        drawn = picture(last_frame(scenario), scenario)
        drawn.save(FOLDER / f"{name}.webp", quality=72, method=6)


if __name__ == "__main__":
    draw(sys.argv[1:])
