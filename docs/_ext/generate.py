"""Pages made from the code's own declarations while the documentation is built.

Models, keys, presets, measures, events and commands are declared once, in the code. These pages are
written into ``_generated``; what a page of prose includes is in ``_generated/parts``. They are kept in git,
so that links to them work where the source is read, and a test holds them against the code.
"""

import inspect
from collections.abc import Iterable, Iterator
from importlib import import_module
from itertools import groupby
from pathlib import Path
from typing import Any

from presets import presets_page
from references import linked, references_page
from sphinx.application import Sphinx

from barchan.parameters import Declaration, declarations


def setup(app: Sphinx) -> dict[str, Any]:
    """Make the pages before sources are read."""
    app.connect("builder-inited", generate)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def generate(app: Sphinx) -> None:
    """Write all pages; one whose text is unchanged is left alone, so that it is not built again."""
    folder = Path(app.srcdir) / "_generated"
    pages = dict(all_pages())
    for path in folder.rglob("*.md"):
        if str(path.relative_to(folder)) not in pages:
            path.unlink()
    for name, text in pages.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.is_file() or path.read_text("utf-8") != text:
            path.write_text(text, "utf-8")


def all_pages() -> Iterator[tuple[str, str]]:
    """Names and texts of all generated pages."""
    from barchan.models import models

    yield "models.md", models_page()
    for name, model in models().items():
        yield f"models/{name}.md", model_page(model)
    yield "keys.md", keys_page()
    yield "presets.md", presets_page()
    yield "references.md", references_page()
    yield "commands.md", commands_page()
    yield "parts/measures.md", measures_table()
    yield "parts/events.md", events_tables()
    yield "parts/streams.md", streams_table()
    yield "parts/laws.md", laws_table()
    yield "parts/saltation.md", group_table("barchan.aeolian.saltation", "Saltation")
    yield "parts/records.md", group_table("barchan.wind.records", "RecordFormat")


def table(header: tuple[str, ...], rows: Iterable[tuple[str, ...]], widths: str) -> str:
    """A table of short Markdown texts."""
    lines = ["```{list-table}", ":header-rows: 1", ":class: declared", f":widths: {widths}", ""]
    for first, *rest in [header, *rows]:
        lines += [f"* - {first}", *(f"  - {cell}" for cell in rest)]
    return "\n".join([*lines, "```", ""])


def code(text: object) -> str:
    """Text set as code."""
    return f"`{text}`" if str(text) else ""


def default_of(declaration: Declaration) -> str:
    """A default as the tables show it."""
    value = declaration.default
    if value is None:
        return "none" if "null" in declaration.bounds else "*required*"
    if isinstance(value, bool):
        return code(str(value).lower())
    return code(f"{value:g}" if isinstance(value, float) else value) or "–"


def parameter_table(declared: Iterable[Declaration]) -> str:
    """The table of some declared parameters."""
    rows = [
        (
            code(d.key),
            default_of(d),
            "–" if d.unit == "-" else d.unit,
            d.bounds.replace("'", "`"),
            d.meaning,
            d.source or "–",
            "yes" if d.live else "",
        )
        for d in declared
    ]
    header = ("Key", "Default", "Unit", "Allowed", "Meaning", "Source", "Live")
    return table(header, rows, "17 9 7 16 32 14 5")


def heading_of(declaration: Declaration) -> str:
    """The heading that a parameter stands under: its group, or that of the keys it is nested in."""
    return declaration.group or declaration.key.partition(".")[0]


def models_page() -> str:
    """The list of all models."""
    from barchan.models import models

    rows = [(f"[`{name}`](models/{name}.md)", m.title, m.citation) for name, m in models().items()]
    names = "\n".join(f"models/{name}" for name in models())
    return (
        "# Models\n\n"
        "One page a model, with all its parameters. `barchan.model_names()` gives the same list.\n\n"
        f"{table(('Name', 'Title', 'Citation'), rows, '15 20 65')}\n"
        f"```{{toctree}}\n:hidden:\n\n{names}\n```\n"
    )


def model_page(model: Any) -> str:
    """One model: what it is and every parameter it has."""
    from barchan.lattice import Lattice

    parts = [f"# {model.title}", f"Model `{model.name}`. {model.citation}", "```{eval-rst}"]
    parts += [inspect.getdoc(model) or "", "```", "## Parameters"]
    parts += ["Keys stand under `model` in a scenario. *Live* parameters may change during a run."]
    for group, declared in groupby(declarations(model.Parameters), heading_of):
        parts += [f"### {group.replace('_', ' ').capitalize()}", parameter_table(declared)]
    if model.fields or model.derived:
        parts += ["## Fields", "What `barchan show RUN --field NAME` draws, beside the fields of every run:"]
        parts += [fields_table(model)]
    if model.measures:
        parts += ["## Measures", "What tables and time series show, beside the measures of every run:"]
        parts += [own_measures_table(model)]
    facts = model(model.Parameters(), Lattice()).facts()
    if facts:
        parts += ["## What the defaults come to", "On a lattice with its defaults:"]
        parts += [f"* {name}: {fact}" for name, fact in facts.items()]
    return "\n\n".join(parts) + "\n"


def fields_table(model: Any) -> str:
    """The fields that frames of a model's runs carry for it, and those that it derives."""
    kept = [(f, "in frames") for f in model.fields if f.in_frames]
    fields = [*kept, *((f, "derived") for f in model.derived)]
    rows = [(code(f.name), "–" if f.unit == "1" else f.unit, f.meaning, kind) for f, kind in fields]
    return table(("Name", "Unit", "Meaning", "Kind"), rows, "20 15 50 15")


def own_measures_table(model: Any) -> str:
    """The measures that only this model gives."""
    rows = [(code(m.name), m.title, "–" if m.unit == "-" else m.unit) for m in model.measures]
    return table(("Name", "Meaning", "Unit"), rows, "30 50 20")


def keys_page() -> str:
    """Every key of a scenario, by group and variant."""
    from barchan.scenario.listing import all_keys

    parts = [
        "# All keys of a scenario",
        "`lattice.rows` is the key `rows` in the group `lattice`; `[]` stands for each item of a list.",
        "`barchan parameters` prints this list too.",
    ]
    for heading, keys in groupby(all_keys(), lambda key: key.heading):
        parts += [f"## {heading}", parameter_table(keys)]
    return "\n\n".join(parts) + "\n"


def commands_page() -> str:
    """The commands with their options."""
    from barchan.cli import app

    text: str = app().generate_docs(output_format="markdown", include_hidden=False)
    body = text[text.index("## barchan ") :]
    return f"# Commands\n\n{body}"


def measures_table() -> str:
    """The table of declared measures."""
    from barchan.analysis.declared_measures import MEASURES, PER_YEAR

    rows = [
        (code(m.name), m.title, "–" if m.unit == "-" else f"{m.unit} {m.reference}".strip(), code(m.row))
        for m in (*MEASURES, *PER_YEAR)
    ]
    return table(("Name", "What", "Unit", "In the row of"), rows, "25 35 25 15")


def streams_table() -> str:
    """The named streams of random numbers."""
    from barchan.streams import STREAMS

    return table(
        ("Stream", "Random numbers for"), ((code(name), use) for name, use in STREAMS.items()), "30 70"
    )


def laws_table() -> str:
    """The flux laws."""
    from barchan.aeolian.flux import LAWS

    rows = [(code(name), law.title, code(law.formula), linked(law.source)) for name, law in LAWS.items()]
    return table(("Name", "Law", "Mass flux", "Source"), rows, "18 17 30 35")


def group_table(module: str, name: str) -> str:
    """The parameters of a group that no scenario holds."""
    return linked(parameter_table(declarations(getattr(import_module(module), name))))


def events_tables() -> str:
    """What each kind of event holds."""
    from barchan.simulation import PlantStroke, RockStroke, SetParameter, SetWind, Stroke

    parts = []
    for event in (SetParameter, SetWind, Stroke, RockStroke, PlantStroke):
        own = (d for d in declarations(event) if not d.key.startswith("wind."))
        parts += [f"`barchan.{event.__name__}`: {inspect.getdoc(event)}", parameter_table(own)]
    return "\n\n".join(parts) + "\n"
