"""Colour maps as the page takes them; ``python -m barchan.studio.colours`` writes the table of them.

The table is shipped, so that the server's first page needs neither matplotlib nor scipy.
"""

import json
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from barchan.models import models

if TYPE_CHECKING:
    from matplotlib.colors import Colormap

COLOURS = 64
"""Colours of a map that are sent."""

TABLE = Path(__file__).with_name("colours.json")

Colours = dict[str, list[list[int]]]
"""Red, green and blue (0 to 255) from lowest to highest, by the name of the map."""


def colours() -> Colours:
    """Every colour map; those of models that others have added are drawn when they are asked for."""
    shipped: Colours = json.loads(TABLE.read_text("utf-8"))
    added = {layer.colours: layer for model in models().values() for layer in model.overlays}
    missing = {name: layer for name, layer in added.items() if name not in shipped}
    if missing:
        from barchan.figures.layers import layer_map

        shipped |= {name: _sampled(layer_map(layer)) for name, layer in missing.items()}
    return shipped


def drawn() -> Colours:
    """Every colour map as the figures have it."""
    from barchan.figures.fields import centred_map, choice_map
    from barchan.figures.layers import layer_map
    from barchan.figures.strata import strata_map
    from barchan.figures.style import colour_map

    maps = {
        "perceptual": colour_map("perceptual"),
        "grey": colour_map("grey"),
        "red-green": colour_map("red-green"),
        "centred": centred_map(),
        "choice": choice_map(),
        "strata": strata_map(),
        **{layer.colours: layer_map(layer) for model in models().values() for layer in model.overlays},
    }
    return {name: _sampled(found) for name, found in maps.items()}


def _sampled(colour_map: "Colormap") -> list[list[int]]:
    sampled = np.asarray(colour_map(np.linspace(0.0, 1.0, COLOURS)))[:, :3]
    numbers: list[list[int]] = np.rint(sampled * 255).astype(int).tolist()
    return numbers


if __name__ == "__main__":
    rows = (
        f"  {json.dumps(name)}: {json.dumps(found, separators=(',', ':'))}" for name, found in drawn().items()
    )
    TABLE.write_text("{\n" + ",\n".join(rows) + "\n}\n", "utf-8")
