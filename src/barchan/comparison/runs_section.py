"""What ran for a report: the scenarios of its variants, their runs, and the command that makes it again."""

import base64
from collections.abc import Mapping, Sequence
from datetime import UTC, datetime
from pathlib import Path

from barchan.archive.file_names import paths_in
from barchan.comparison.page import Markup, paragraph, table, text
from barchan.comparison.variants import Variant, differing_keys, unlike_defaults
from barchan.comparison.words import seconds_text, value_text, without_folders
from barchan.scenario.definition import text_of
from barchan.scenario.paths import with_paths
from barchan.version import __version__

SCENARIOS = "scenarios"
"""The folder of the complete scenarios, beside a report."""


def scenarios_table(variants: Sequence[Variant], within: bool) -> str:
    """The keys in which variants differ; links to their complete scenarios, or ones that hold them."""
    differing = differing_keys(variants)
    rows = [[key, *("–" if v is None else value_text(v) for v in row)] for key, row in differing.items()]
    links = [_scenario_link(variant, within) for variant in variants]
    heads = ["key", *(variant.label for variant in variants)]
    told = "Everything else in the scenarios is the same." + _strange_values(variants)
    if within and any(paths_in(variant.scenario.data()) for variant in variants):
        told += " The complete scenarios name their files without folders: lay the files beside them."
    return table(heads, [*rows, ["complete scenario", *links]], wordy=True) + paragraph(told, "quiet")


def _scenario_link(variant: Variant, within: bool) -> Markup:
    """A link to the complete scenario of a variant: to the file beside the page, or with the text within."""
    name = f"{variant.name}.json"
    if not within:
        return Markup(f'<a href="{text(f"{SCENARIOS}/{name}")}">{text(name)}</a>')
    data = with_paths(variant.scenario.data(), lambda path: Path(path).name)
    content = base64.b64encode(text_of(data).encode()).decode("ascii")
    return Markup(
        f'<a download="{text(name)}" href="data:application/json;base64,{content}">{text(name)}</a>'
    )


def _strange_values(variants: Sequence[Variant]) -> str:
    """In words, which parameters the scenario gives a model that has other ones by itself."""
    parts = []
    for variant in variants:
        found = unlike_defaults(variant)
        if found:
            told = ", ".join(
                f"{key} {value_text(v)} (default {value_text(own)})" for key, (v, own) in found.items()
            )
            parts.append(f"{variant.label}: {told}")
    return f" Values that are not the model's own defaults: {'; '.join(parts)}." if parts else ""


def runs_table(variants: Sequence[Variant], unfinished: Mapping[str, str]) -> str:
    """A row for each finished run, and why others did not come to their end."""
    rows = [
        [
            v.label,
            seed,
            r.steps,
            r.reason,
            seconds_text(r.seconds),
            seconds_text(r.processor_seconds),
            r.version,
            r.host,
            Markup(f"<code>{r.bed[:12]}</code>"),
        ]
        for v in variants
        for seed, r in v.reports.items()
    ]
    heads = (
        "variant",
        "seed",
        "steps",
        "ended",
        "time (s)",
        "processor (s)",
        "Barchan",
        "machine",
        "last bed",
    )
    parts = [table(heads, rows)]
    changed = [f"{v.label}, seed {s}" for v in variants for s, r in v.reports.items() if r.differs_from]
    if changed:
        parts.append(
            paragraph(f"An earlier run of the same scenario had another result: {', '.join(changed)}.")
        )
    if unfinished:
        parts.append(paragraph("Runs that did not come to their end:"))
        reasons = [(run, without_folders(reason)) for run, reason in unfinished.items()]
        parts.append(table(("run", "reason"), reasons, wordy=True))
    return "".join(parts)


def made_by(command: str, seconds: float) -> str:
    """Version, date, how long it took (s), and the command that makes a report again, without folders."""
    when = datetime.now(UTC).strftime("%Y-%m-%d %H:%M UTC")
    told = f"Made with Barchan {__version__} on {when} in {seconds:.0f} s, pictures included"
    return (
        paragraph(f"{told}, by:") + f"<pre><code>{text(without_folders(command))}</code></pre>"
        if command
        else paragraph(f"{told}.")
    )
