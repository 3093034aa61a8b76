"""The report of a comparison: one page in HTML, pictures within, that prints as it is."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from barchan.comparison.conditions import CONDITIONS, lead, shared_conditions, unequal_times
from barchan.comparison.drawing import Picture
from barchan.comparison.page import Strong, figure, page, paragraph, points, section, table, text
from barchan.comparison.runs_section import made_by, runs_table, scenarios_table
from barchan.comparison.statistics import LEAST, TURNS, Difference, spread
from barchan.comparison.variants import Variant, shared_measures
from barchan.comparison.words import listed, named, number, probability, spread_text

REPORT = "report.html"

METHOD = """
Every variant starts from the same bed for the same seed, under the same wind, and its polls draw from the
same random numbers: what differs between variants of one seed comes of their rules and values alone.

Differences are those from {reference}, taken seed by seed, of directions by the shorter way.

Intervals and probabilities are those of the
two-sided paired t-test (Student), which supposes that differences scatter normally. Holm's correction (1979)
holds the chance of any false difference among all tests of the table at 5 %. With few seeds only large
differences stand; none found is no proof of none.

Values that Barchan itself doubts, for instance the spacing of bedforms of which there are too few on the
field, are left out, with the seeds they belong to.

The last bed is named by the beginning of the SHA-256 digest of its layers: the same scenario gives the same
digest on any machine.

Measures, with their definitions and limits, are described in Barchan's documentation, page Measures.
"""
"""How to read a report, in paragraphs."""


@dataclass(frozen=True)
class Contents:
    """All that a report tells."""

    title: str
    changed: str
    """Values of the scenario that all variants have otherwise than its source."""
    command: str
    """The command that makes it again."""
    seconds: float
    """How long the comparison took, drawing included."""
    variants: Sequence[Variant]
    differences: Sequence[Difference]
    together: Sequence[Picture]
    pictures: Mapping[str, Sequence[Picture]]
    """Pictures of each variant by its label."""
    unfinished: Mapping[str, str]
    """Runs that did not come to their end, and why."""
    alone: bool = False
    """Whether no files lie beside the page: scenarios are links that hold them."""


def report_of(contents: Contents) -> str:
    """The report as HTML."""
    reference, *others = contents.variants
    seeds = list(reference.reports)
    warning = unequal_times(contents.variants)
    changed = contents.changed and f"Changed from the scenario: {contents.changed}."
    links = ("overview", "measures", "differences", "time", "slopes", "maps", "variants", "runs", "method")
    parts = [
        f"<h1>{text(contents.title)}</h1>",
        paragraph(lead(contents.variants), "lead"),
        *([paragraph(warning, "warning")] if warning else []),
        *([paragraph(changed, "quiet")] if changed else []),
        paragraph(_finding(contents)),
        "<nav>" + "".join(f'<a href="#{name}">{name}</a>' for name in links) + "</nav>",
        section("overview", "Last frames", *_shown(contents, "overview")),
        section("measures", "Measures of the last frame", _measures(contents)),
        section("differences", f"Differences from {reference.label}", _differences(contents)),
        section("time", "Measures over time", *_shown(contents, "series"), _time_note(seeds)),
        section("slopes", "Slopes", *_shown(contents, "slopes")),
        section("maps", f"Surfaces less that of {reference.label}", _difference_maps(contents, others)),
        section("variants", "Variants one by one", *(_variant(contents, v) for v in contents.variants)),
        section(
            "runs",
            "Runs",
            scenarios_table(contents.variants, contents.alone),
            runs_table(contents.variants, contents.unfinished),
            made_by(contents.command, contents.seconds),
        ),
        section("method", "How to read this", points(_method(contents))),
    ]
    return page(contents.title, *parts)


def _method(contents: Contents) -> str:
    """How to read the report, without what is about tests or equal conditions where there are none."""
    paragraphs = METHOD.format(reference=contents.variants[0].label).strip().split("\n\n")
    if _of_one_seed(contents):
        paragraphs = [one for one in paragraphs if not one.startswith("Intervals")]
    if len(shared_conditions(contents.variants)) < len(CONDITIONS):
        paragraphs = [one for one in paragraphs if not one.startswith("Every variant")]
    return "\n\n".join(paragraphs)


def _finding(contents: Contents) -> str:
    """In a sentence, what differs."""
    reference, *others = contents.variants
    titles = {name: title for name, (title, _) in shared_measures(contents.variants).items()}
    told = []
    for other in others:
        names = dict.fromkeys(
            titles[d.measure] for d in contents.differences if d.variant == other.label and d.significant
        )
        tested = any(math.isfinite(d.p) for d in contents.differences if d.variant == other.label)
        if names:
            told.append(f"{other.label} differs from {reference.label} in {listed(list(names))}")
        elif tested:
            told.append(f"{other.label} differs from {reference.label} in no measure beyond chance")
    if not told and _of_one_seed(contents) and others:
        return "One seed each: differences are told below, how much of them is chance is not."
    if not told:
        needed = "at least two seeds (barchan compare --seeds) and a second variant"
        return f"No tests of difference: these need {needed}."
    return f"After correction for many tests, {'; '.join(told)}."


def _shown(contents: Contents, view: str) -> list[str]:
    return [figure(p.path, p.caption) for p in contents.together if p.view == view]


def _measures(contents: Contents) -> str:
    significant = {(d.measure, d.variant) for d in contents.differences if d.significant}
    rows = []
    for name, (title, unit) in shared_measures(contents.variants).items():
        row: list[object] = [named(title, unit)]
        for variant in contents.variants:
            found = spread(list(variant.finals(name).values()), TURNS.get(name))
            cell = spread_text(found, len(variant.reports))
            row.append(Strong(f"{cell} *") if (name, variant.label) in significant else cell)
        rows.append(row)
    note = "A dash where no value may be quoted."
    if not _of_one_seed(contents):
        note = (
            "Mean ± standard deviation over seeds; a dash where no value may be quoted, (1/3) where only one "
            f"seed of three has one. * differs from {contents.variants[0].label} (Holm, p < 0.05)."
        )
    return table(["measure", *(v.label for v in contents.variants)], rows) + paragraph(note, "quiet")


def _differences(contents: Contents) -> str:
    if _of_one_seed(contents):
        return _plain_differences(contents)
    shared = shared_measures(contents.variants)
    rows = []
    for one in contents.differences:
        if not one.count or not math.isfinite(one.p):
            continue
        difference = f"{number(one.mean)}"
        interval = f"{number(one.low)} to {number(one.high)}"
        rows.append(
            [
                named(*shared[one.measure]),
                one.variant,
                Strong(difference) if one.significant else difference,
                interval,
                one.count,
                probability(one.p),
                Strong(probability(one.adjusted)) if one.significant else probability(one.adjusted),
            ]
        )
    if not rows:
        return paragraph("No measure has values of two seeds that may be quoted in both variants.")
    heads = ("measure", "variant", "difference", "95 % interval", "pairs", "p", "p (Holm)")
    return table(heads, rows)


def _plain_differences(contents: Contents) -> str:
    """Values of one seed and how far they are apart, of directions by the shorter way."""
    reference, *others = contents.variants
    shared = shared_measures(contents.variants)
    rows = []
    for one in contents.differences:
        if not one.count:
            continue
        other = next(variant for variant in others if variant.label == one.variant)
        (base,), (own,) = (variant.finals(one.measure).values() for variant in (reference, other))
        share = math.nan if one.measure in TURNS or not base else 100.0 * one.mean / abs(base)
        values = (number(base), number(own), number(one.mean), number(share))
        rows.append([named(*shared[one.measure]), one.variant, *values])
    if not rows:
        return paragraph("No measure has a value that may be quoted in both variants.")
    heads = ("measure", "variant", f"value of {reference.label}", "value", "difference", "per cent")
    note = "One seed each: how much of a difference is chance is not told."
    return table(heads, rows) + paragraph(note, "quiet")


def _of_one_seed(contents: Contents) -> bool:
    """Whether no variant has more than one seed, so that nothing scatters and nothing is tested."""
    return all(len(variant.reports) < LEAST for variant in contents.variants)


def _time_note(seeds: Sequence[int]) -> str:
    told = "Lines are means over seeds, pale bands reach from the least to the greatest seed. "
    return paragraph(
        (told if len(seeds) > 1 else "") + "Values that may not be quoted are left out.", "quiet"
    )


def _difference_maps(contents: Contents, others: Sequence[Variant]) -> str:
    shown = _shown(contents, "difference")
    if not shown:
        reason = "Fields of unlike size have no difference." if others else "There is one variant only."
        return paragraph(reason)
    note = (
        "Red where the surface is higher, blue where it is lower, with the same seed. Bedforms that only "
        "stand elsewhere show as pairs of red and blue: surfaces drift apart although their measures agree."
    )
    return f'<div class="row">{"".join(shown)}</div>' + paragraph(note, "quiet")


def _variant(contents: Contents, variant: Variant) -> str:
    pictures = contents.pictures[variant.label]
    model = variant.scenario.new_model()
    parts = [f"<h3>{text(variant.label)}</h3>", paragraph(f"{model.title}. {model.citation}", "quiet")]
    for step in dict.fromkeys(p.step for p in pictures if p.step is not None):
        shown = [p for p in pictures if p.step == step]
        maps = [figure(p.path, p.caption) for p in shown if p.view != "section"]
        parts.append(f'<div class="row">{"".join(maps)}</div>')
        parts += [figure(p.path, p.caption) for p in shown if p.view == "section"]
    parts += [figure(p.path, p.caption) for p in pictures if p.step is None]
    return f'<div class="variant">{"".join(parts)}</div>'
