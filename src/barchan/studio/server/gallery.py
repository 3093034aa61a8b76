"""Data that a page requests once: presets with their pictures, the schema, kinds of files."""

import threading
import tomllib
from collections.abc import Callable
from functools import cache, wraps
from importlib.resources import files
from typing import Any, TypeVar

from barchan.models import models
from barchan.scenario import Scenario, load_scenario, preset_names
from barchan.studio.server.workspace import HEIGHTS, RECORDS

Content = TypeVar("Content")


def _made_once(make: Callable[[], Content]) -> Callable[[], Content]:
    """A function whose result is made once; who asks meanwhile waits for it and makes no second one."""
    kept, making = cache(make), threading.Lock()

    @wraps(make)
    def content() -> Content:
        with making:
            return kept()

    return content


def prepare() -> None:
    """Make in a thread what every page asks for first, while the browser still starts."""
    threading.Thread(target=lambda: (presets(), schema()), daemon=True, name="barchan-gallery").start()


@_made_once
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


@cache
def landforms() -> dict[str, list[str]]:
    """The names of presets by landform: the groups, but dunes by their forms."""
    forms: dict[str, list[str]] = _listing()["landforms"]
    return {**forms, **{title: names for title, names in groups().items() if title != "Dunes"}}


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


@_made_once
def schema() -> dict[str, Any]:
    """The JSON schema of scenarios, from which the panel is generated."""
    return Scenario.model_json_schema()


def files_taken() -> dict[str, tuple[str, ...]]:
    """Suffixes of the files that a page may upload, as ground and as a wind record."""
    return {"heights": HEIGHTS, "records": RECORDS}


@cache
def formats() -> list[dict[str, Any]]:
    """The formats that a run can be written in, those whose libraries are installed, with their options."""
    from importlib.util import find_spec

    from barchan.export.formats import FORMATS

    return [
        {
            "name": one.name,
            "suffix": one.suffixes[0],
            "meaning": one.meaning,
            "series": one.series,
            "fields": one.fields,
            "options": [_option(name) for name in one.options],
        }
        for one in FORMATS
        if not one.needs or find_spec(one.needs[0]) is not None
    ]


def _option(name: str) -> dict[str, str]:
    """An option of ``barchan export`` as the page shows it: name, title, meaning, and kind of its values."""
    from barchan.export.options import WORDING, Options

    declared = str(Options.__dataclass_fields__[name].type)
    kinds = {"bool": "flag", "tuple": "pair", "datetime": "moment", "int": "whole", "str": "field"}
    kind = next((kind for begin, kind in kinds.items() if begin in declared), "number")
    return {"name": name, "kind": kind, "title": WORDING[name].title, "meaning": WORDING[name].meaning}
