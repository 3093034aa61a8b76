"""Data that a page requests once: presets with their pictures, the schema, the colours, kinds of files."""

import tomllib
from functools import cache
from importlib.resources import files
from typing import Any

import numpy as np

from barchan.models import models
from barchan.scenario import Scenario, load_scenario, preset_names
from barchan.studio.server.workspace import HEIGHTS, RECORDS

COLOURS = 64
"""Colours of a map that are sent."""


@cache
def presets() -> list[dict[str, Any]]:
    """Every preset, by groups: name, group, title, source, what to look for, a question, model, size."""
    found = []
    for name, group in _grouped():
        scenario = load_scenario(name)
        found.append(
            {
                "name": name,
                "group": group,
                "start": name == showpiece(),
                "title": scenario.title,
                "citation": scenario.citation,
                "look_for": scenario.look_for,
                "question": scenario.question,
                "model": models()[scenario.model.name].title,
                "rows": scenario.lattice.rows,
                "columns": scenario.lattice.columns,
                "picture": thumbnail(name) is not None,
            }
        )
    return found


@cache
def groups() -> dict[str, list[str]]:
    """The names of presets by the title of their group; the first of each is where to start."""
    return {group["title"]: group["presets"] for group in _listing()["group"]}


def showpiece() -> str:
    """The preset that the studio opens with where none is named."""
    return str(_listing()["showpiece"])


@cache
def _listing() -> dict[str, Any]:
    return tomllib.loads(files("barchan.presets").joinpath("gallery.toml").read_text("utf-8"))


def _grouped() -> list[tuple[str, str]]:
    """Presets with their groups, in the gallery's order; those of no group at the end."""
    listed = [(name, title) for title, names in groups().items() for name in names]
    known = {name for name, _ in listed}
    return [*listed, *((name, "Other") for name in preset_names() if name not in known)]


def thumbnail(name: str) -> bytes | None:
    """The small picture of a preset; None where there is none."""
    if name not in preset_names():
        return None
    file = files("barchan.presets").joinpath("pictures", f"{name}.webp")
    return file.read_bytes() if file.is_file() else None


@cache
def schema() -> dict[str, Any]:
    """The JSON schema of scenarios, from which the panel is generated."""
    return Scenario.model_json_schema()


def files_taken() -> dict[str, tuple[str, ...]]:
    """Suffixes of the files that a page may upload, as ground and as a wind record."""
    return {"heights": HEIGHTS, "records": RECORDS}


@cache
def colours() -> dict[str, list[list[int]]]:
    """Colour maps by name: red, green and blue from lowest to highest."""
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
    places = np.linspace(0.0, 1.0, COLOURS)
    return {
        name: np.rint(np.asarray(colours(places))[:, :3] * 255).astype(int).tolist()
        for name, colours in maps.items()
    }
