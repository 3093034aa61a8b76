"""The report of a set of published results: what was reported, beside what comes out here."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from barchan.comparison.drawing import Picture
from barchan.comparison.page import Markup, Strong, figure, page, paragraph, points, section, table, text
from barchan.comparison.published.judging import Result, Verdict
from barchan.comparison.published.results import Experiment, PublishedSet
from barchan.comparison.runs_section import SCENARIOS, made_by, runs_table
from barchan.comparison.statistics import spread
from barchan.comparison.variants import Variant
from barchan.comparison.words import spread_text
from barchan.scenario.summary import field_size
from barchan.words import counted

METHOD = """
A reported number comes of one run whose random numbers are not known. It agrees where it lies in the
interval that one more run of ours would lie in with a chance of 95 % (Student's t with the mean and
deviation over seeds), widened by half of its last digit, and by another half where ours are whole numbers.

An order, such as one side steeper than the other, agrees where the paired t-test over seeds finds it (p <
0.05), differs where the test finds the opposite, and is undecided where it finds neither. Two measures
count as alike where the 95 % confidence interval of their difference lies within the tolerance given.

A landform is named by the rule on the page Measures of the documentation. It agrees where all seeds have
it, differs where none has, and is undecided otherwise.

Values that Barchan itself doubts, for instance the spacing of too few bedforms, are left out with their
seeds; 5.2 (2/3) is the mean of two seeds of three.

Where a set-up is not stated in the source, its title or the notes of the preset say what is assumed.
"""
"""How to read a report, in paragraphs."""


@dataclass(frozen=True)
class Section:
    """An experiment with its runs, its verdicts and its pictures."""

    experiment: Experiment
    cases: Sequence[Variant]
    verdicts: Sequence[Verdict]
    pictures: Sequence[Picture]


@dataclass(frozen=True)
class Contents:
    """All that a report tells."""

    chosen: PublishedSet
    sections: Sequence[Section]
    variants: Sequence[Variant]
    unfinished: Mapping[str, str]
    command: str
    seconds: float


def report_of(contents: Contents) -> str:
    """The report as HTML."""
    chosen = contents.chosen
    seeds = max(len(variant.reports) for variant in contents.variants)
    lead = (
        f"Set up again: {len(contents.sections)} figures and sections, "
        f"{counted(len(contents.variants), 'run')} of {counted(seeds, 'seed')} each. "
        f"Reported by: {chosen.source}."
    )
    parts = [
        f"<h1>{text(chosen.title)}</h1>",
        paragraph(lead, "lead"),
        paragraph(_counted([verdict for one in contents.sections for verdict in one.verdicts])),
        section("overview", "Overview", _overview(contents.sections)),
        *(_section(one) for one in contents.sections),
        section(
            "runs",
            "Runs",
            runs_table(contents.variants, contents.unfinished),
            made_by(contents.command, contents.seconds),
        ),
        section("method", "How to read this", points(METHOD)),
    ]
    return page(chosen.title, *parts)


def _counted(verdicts: Sequence[Verdict]) -> str:
    counts = {name: sum(v.result == name for v in verdicts) for name in ("agrees", "differs", "undecided")}
    eye = sum(v.result == "for the eye" for v in verdicts)
    return (
        f"Of {len(verdicts)} statements {counts['agrees']} agree with what comes out here, "
        f"{counts['differs']} differ, {counts['undecided']} are undecided, {eye} are for the eye."
    )


def _overview(sections: Sequence[Section]) -> str:
    rows = []
    for one in sections:
        link = Markup(f'<a href="#{one.experiment.name}">{text(one.experiment.title)}</a>')
        results = [verdict.result for verdict in one.verdicts]
        rows.append([one.experiment.figure, link, *(results.count(r) or "" for r in _RESULTS)])
    return table(("in the source", "experiment", *_RESULTS), rows, wordy=True)


_RESULTS: tuple[Result, ...] = ("agrees", "differs", "undecided", "for the eye")


def _section(one: Section) -> str:
    experiment = one.experiment
    verdicts = [
        [v.claim.words, v.found, Strong(v.result) if v.result == "differs" else v.result]
        for v in one.verdicts
    ]
    images = [figure(picture.path, picture.caption) for picture in one.pictures]
    parts = [
        paragraph(f"{experiment.figure}. {experiment.reported}"),
        table(("reported", "here", "verdict"), verdicts, wordy=True),
        f'<div class="row">{"".join(images)}</div>',
        _cases(one.cases),
    ]
    return section(experiment.name, experiment.title, *parts)


_MEASURES = (
    "highest_stack",
    "bare_fraction",
    "spacing",
    "bedform_height",
    "windward_slope",
    "lee_slope",
    "speed",
)
"""Measures in the table of an experiment's cases."""


def _cases(cases: Sequence[Variant]) -> str:
    rows = []
    for variant in cases:
        file = f"{SCENARIOS}/{variant.name}.json"
        link = Markup(f'<a href="{text(file)}">{text(variant.label)}</a>')
        size = f"{field_size(variant.scenario)}; {counted(variant.scenario.run.steps, 'step')}"
        rows.append([link, size, *(_final(variant, name) for name in _MEASURES)])
    report = next(iter(cases[0].reports.values()))
    heads = [f"{report.titles[name]} ({report.units[name]})" for name in _MEASURES]
    return table(("case", "field", *heads), rows, wordy=True)


def _final(variant: Variant, name: str) -> str:
    return spread_text(spread(list(variant.finals(name).values())), len(variant.reports))


def claims_rows(sections: Sequence[Section]) -> list[dict[str, str]]:
    """A row for each claim, for a table as CSV."""
    return [
        {
            "experiment": one.experiment.name,
            "figure": one.experiment.figure,
            "reported": verdict.claim.words,
            "here": verdict.found,
            "verdict": verdict.result,
        }
        for one in sections
        for verdict in one.verdicts
    ]
