"""The page of presets: a gallery by model, then each preset with its picture."""

from collections.abc import Callable
from html import escape
from importlib import resources
from itertools import groupby
from pathlib import Path
from typing import Any


def copy_pictures(folder: Path) -> None:
    """Bring the presets' pictures, which ship with the package, to where pages can show them."""
    folder.mkdir(parents=True, exist_ok=True)
    for picture in (resources.files("barchan.presets") / "pictures").iterdir():
        copy, data = folder / picture.name, picture.read_bytes()
        if not copy.is_file() or copy.read_bytes() != data:
            copy.write_bytes(data)


def presets_page() -> str:
    """Every preset: its picture, where it comes from, what to look for, how to run it."""
    from barchan.scenario import load_scenario, preset_names

    scenarios = {name: load_scenario(name) for name in preset_names()}
    parts = [
        "# Presets",
        "Scenarios that ship with Barchan; `barchan presets NAME` prints one as a file.",
    ]
    for model, names in groupby(
        sorted(scenarios, key=lambda n: (scenarios[n].model.name, n)), _model_of(scenarios)
    ):
        cards = "\n".join(_card(name, scenarios[name].title) for name in names)
        parts += [
            f"**Model** [`{model}`](models/{model}.md)",
            f'```{{raw}} html\n<div class="gallery">\n{cards}\n</div>\n```',
        ]
    parts += [_preset(name, scenario) for name, scenario in scenarios.items()]
    return "\n\n".join(parts) + "\n"


def _model_of(scenarios: dict[str, Any]) -> Callable[[str], str]:
    return lambda name: str(scenarios[name].model.name)


def _card(name: str, title: str) -> str:
    picture = f'<img src="../_static/presets/{name}.webp" alt="" width="320" height="200" loading="lazy">'
    return f'<a href="#preset-{name.replace(".", "-")}">{picture}<span>{escape(title)}</span></a>'


def _preset(name: str, scenario: Any) -> str:
    """One preset."""
    run = scenario.run
    facts = scenario.facts()
    field = f"{scenario.lattice.size_in_words}, {run.steps} steps"
    lines = [f"Source\n: {scenario.citation or '–'}", f"Look for\n: {scenario.look_for or '–'}"]
    lines += [f"Model\n: [`{scenario.model.name}`](models/{scenario.model.name}.md)", f"Size\n: {field}"]
    lines += [f"{fact.capitalize()}\n: {value}" for fact, value in facts.items()]
    picture = f"![{scenario.title}](../_static/presets/{name}.webp)"
    head = f"(preset-{name.replace('.', '-')})=\n## {name}: {scenario.title}"
    return "\n\n".join([head, picture, *lines, f"```sh\nbarchan run {name}\n```"])
