"""Running a set of published results again, and reporting on it."""

import time
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from pathlib import Path

from barchan.comparison.comparing import Comparison, write_scenarios
from barchan.comparison.drawing import FIGURES, Picture, chosen_steps, draw_overview, draw_variants
from barchan.comparison.published.judging import judge
from barchan.comparison.published.report import Contents, Section, claims_rows, report_of
from barchan.comparison.published.results import Experiment, PublishedSet, plan_of
from barchan.comparison.report import REPORT
from barchan.comparison.runs_section import SCENARIOS
from barchan.comparison.variants import Variant, variants_of
from barchan.ensembles.running import Told, run_ensemble
from barchan.ensembles.table import failures, series_table, write_tables
from barchan.ensembles.workers import Workers, processes
from barchan.errors import ArchiveError
from barchan.replacing import replacing

CLAIMS = "claims.csv"


def reproduce(
    chosen: PublishedSet,
    folder: Path,
    *,
    seeds: int,
    first_seed: int = 1,
    workers: Workers | None = None,
    command: str = "",
    told: Told = lambda *_: None,
    stop: Callable[[], bool] = lambda: False,
) -> Comparison:
    """Run what is missing of a set in a folder, and write ``report.html`` and the data beside it.

    Raises ArchiveError where the folder cannot be written, BarchanError where no run came to its end.
    """
    began = time.monotonic()
    plan = plan_of(chosen, seeds, first_seed)
    outcome = run_ensemble(plan, folder, workers, told=told, stop=stop)
    if stop():
        return Comparison(outcome, None)
    found = variants_of(plan, folder)
    try:
        with processes().open() as executor:
            sections = _sections(chosen, found, folder, executor)
        _write_data(folder, found, sections)
        unfinished = {**dict.fromkeys(outcome.waiting, "stopped"), **failures(folder)}
        took = time.monotonic() - began
        text = report_of(Contents(chosen, sections, found, unfinished, command, took))
        with replacing(folder / REPORT) as partial:
            partial.write_text(text, "utf-8")
    except OSError as error:
        raise ArchiveError(f"cannot write to {folder}: {error.strerror or error}") from error
    return Comparison(outcome, folder / REPORT)


def _sections(
    chosen: PublishedSet, found: Sequence[Variant], folder: Path, executor: Executor
) -> list[Section]:
    named = {variant.label: variant for variant in found}
    sections = []
    for experiment in chosen.experiments:
        cases = {name: named[name] for name in experiment.cases if name in named}
        if not cases:
            continue
        verdicts = [judge(claim, cases) for claim in experiment.claims]
        sections.append(
            Section(experiment, list(cases.values()), verdicts, _drawn(experiment, cases, folder, executor))
        )
    return sections


def _drawn(
    experiment: Experiment, cases: Mapping[str, Variant], folder: Path, executor: Executor
) -> list[Picture]:
    """Last frames of all seeds in one scale, and unless the experiment is brief each case by itself."""
    variants = list(cases.values())
    home = folder / FIGURES
    home.mkdir(parents=True, exist_ok=True)
    path = draw_overview(variants, home / f"{experiment.name}.png")
    overview = Picture(path, f"{experiment.title}: last frames of each seed", "overview")
    if experiment.brief:
        return [overview]
    steps = experiment.steps or chosen_steps(variants)[-1:]
    alone = draw_variants(variants, folder, steps, executor)
    return [overview, *(picture for pictures in alone.values() for picture in pictures)]


def _write_data(folder: Path, variants: Sequence[Variant], sections: Sequence[Section]) -> None:
    """Tables of measures, series and claims, and the complete scenario of each case."""
    import pandas as pd

    write_tables(folder)
    tables = {"series.csv": series_table(folder), CLAIMS: pd.DataFrame(claims_rows(sections))}
    for name, content in tables.items():
        with replacing(folder / name) as partial:
            content.to_csv(partial, index=False)
    write_scenarios(folder / SCENARIOS, variants)
