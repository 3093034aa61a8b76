"""The page of presets: a gallery by landform, then each preset with its picture."""

from html import escape
from importlib import resources
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
    from barchan.studio.server.gallery import landforms

    scenarios = {name: load_scenario(name) for name in preset_names()}
    lead = (
        "Scenarios that ship with Barchan; `barchan presets NAME` prints one as a file. Times are what a run "
        "is expected to take on one core, compilation left out."
    )
    parts = ["# Presets", lead]
    for landform, names in landforms().items():
        cards = "\n".join(_card(name, scenarios[name]) for name in names)
        parts += [f"**{landform}**", f'```{{raw}} html\n<div class="gallery">\n{cards}\n</div>\n```']
    parts += [_preset(name, scenario) for name, scenario in scenarios.items()]
    return "\n\n".join(parts) + "\n"


def _card(name: str, scenario: Any) -> str:
    picture = f'<img src="../_static/presets/{name}.webp" alt="" width="320" height="200" loading="lazy">'
    words = f"<span>{escape(scenario.title)}<br><small>{_time(scenario)}</small></span>"
    return f'<a href="#preset-{name.replace(".", "-")}">{picture}{words}</a>'


def _time(scenario: Any) -> str:
    """The expected time of its run on one core, for people to read."""
    from barchan.scenario.cost import expected_seconds, spoken_estimate

    return spoken_estimate(expected_seconds(scenario))


def _preset(name: str, scenario: Any) -> str:
    """One preset."""
    run = scenario.run
    facts = scenario.facts()
    field = f"{scenario.lattice.size_in_words}, {run.steps} steps, {_time(scenario)} on one core"
    lines = [f"Source\n: {scenario.citation or '–'}", f"Look for\n: {scenario.look_for or '–'}"]
    lines += [f"Model\n: [`{scenario.model.name}`](models/{scenario.model.name}.md)", f"Size\n: {field}"]
    lines += [f"{fact.capitalize()}\n: {value}" for fact, value in facts.items()]
    picture = f"![{scenario.title}](../_static/presets/{name}.webp)"
    head = f"(preset-{name.replace('.', '-')})=\n## {name}: {scenario.title}"
    return "\n\n".join([head, picture, *lines, f"```sh\nbarchan run {name}\n```"])
