"""The page of presets: a gallery by landform, then each preset with its picture."""

from typing import Any

PICTURES = "src/barchan/presets/pictures"
"""Where the package keeps the presets' pictures, seen from the top of the source."""


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
        cards = [_card(name, scenarios[name]) for name in names]
        parts += [f"**{landform}**", ":::{container} gallery", *cards, ":::"]
    parts += [_preset(name, scenario) for name, scenario in scenarios.items()]
    return "\n\n".join(parts) + "\n"


def _card(name: str, scenario: Any) -> str:
    picture = f"![](../../{PICTURES}/{name}.webp)"
    return f"[{picture} {scenario.title}, {_time(scenario)}](#preset-{name.replace('.', '-')})"


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
    picture = f"![{scenario.title}](../../{PICTURES}/{name}.webp)"
    head = f"(preset-{name.replace('.', '-')})=\n## {name}: {scenario.title}"
    return "\n\n".join([head, picture, *lines, f"```sh\nbarchan run {name}\n```"])
