"""Data that a page requests once: presets with their pictures, the schema, kinds of files."""

from functools import cache
from importlib.resources import files
from typing import Any

from barchan.models import models
from barchan.scenario import Scenario, load_scenario, preset_names
from barchan.studio.server.workspace import HEIGHTS, RECORDS


@cache
def presets() -> list[dict[str, Any]]:
    """Every preset: name, title, source, what to look for, model, size."""
    found = []
    for name in preset_names():
        scenario = load_scenario(name)
        found.append(
            {
                "name": name,
                "title": scenario.title,
                "citation": scenario.citation,
                "look_for": scenario.look_for,
                "model": models()[scenario.model.name].title,
                "rows": scenario.lattice.rows,
                "columns": scenario.lattice.columns,
                "picture": thumbnail(name) is not None,
            }
        )
    return found


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
