"""Comparing: run all variants, test their measures, draw and write the report and its data."""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from barchan.comparison.drawing import SLOPES, chosen_steps, draw_together, draw_variants, slopes_of
from barchan.comparison.report import REPORT, Contents, report_of
from barchan.comparison.runs_section import SCENARIOS
from barchan.comparison.statistics import Difference, differences
from barchan.comparison.variants import Variant, variants_of
from barchan.comparison.words import listed
from barchan.ensembles.axes import Axis
from barchan.ensembles.plan import Plan
from barchan.ensembles.running import EnsembleOutcome, Told, run_ensemble
from barchan.ensembles.table import failures, series_table, write_tables
from barchan.ensembles.workers import Workers, processes
from barchan.errors import ArchiveError, BarchanError
from barchan.models import model_names
from barchan.replacing import replacing
from barchan.scenario import nearest

MODEL = "model.name"


@dataclass(frozen=True)
class Comparison:
    """What a comparison came to."""

    outcome: EnsembleOutcome
    report: Path | None
    """The report; None where it was broken off before."""


def axis_of_models(names: Sequence[str]) -> Axis:
    """The axis of the models to compare; raises BarchanError for a name that is no model's."""
    for name in names:
        if name not in model_names():
            known = ", ".join(model_names())
            raise BarchanError(f"--models: no model '{name}'; allowed: {known}{nearest(name, model_names())}")
    if len(set(names)) < len(names):
        raise BarchanError(f"--models {','.join(names)}: names a model twice")
    return Axis(MODEL, tuple(names))


def compare(
    plan: Plan,
    folder: Path,
    *,
    workers: Workers | None = None,
    steps: Sequence[int] = (),
    command: str = "",
    told: Told = lambda *_: None,
    stop: Callable[[], bool] = lambda: False,
) -> Comparison:
    """Run what is missing of a plan in a folder, and write ``report.html`` and the data beside it.

    Pictures show the saved ``steps``, or the middle and the last. Raises ArchiveError where the folder
    cannot be written, BarchanError where no run came to its end or a step was not saved.
    """
    began = time.monotonic()
    _check_steps(plan, steps)
    outcome = run_ensemble(plan, folder, workers, told=told, stop=stop)
    if stop():
        return Comparison(outcome, None)
    found = variants_of(plan, folder)
    tests = differences(found)
    try:
        _write_data(folder, found, tests)
        shown = chosen_steps(found, steps)
        with processes().open() as executor:
            pictures = executor.submit(draw_together, found, folder)
            alone = draw_variants(found, folder, shown, executor)
            together = pictures.result()
        contents = Contents(
            _title(plan, found),
            plan.title.partition(", changed: ")[2],
            command,
            time.monotonic() - began,
            found,
            tests,
            together,
            alone,
            {**dict.fromkeys(outcome.waiting, "stopped"), **failures(folder)},
        )
        with replacing(folder / REPORT) as partial:
            partial.write_text(report_of(contents), "utf-8")
    except OSError as error:
        raise ArchiveError(f"cannot write to {folder}: {error.strerror or error}") from error
    return Comparison(outcome, folder / REPORT)


def _check_steps(plan: Plan, steps: Sequence[int]) -> None:
    """Raise BarchanError for steps that no member will save."""
    runs = [member.scenario["run"] for member in plan.members]
    for step in steps:
        saved = (step == r["steps"] or (0 <= step < r["steps"] and step % r["save_every"] == 0) for r in runs)
        if not any(saved):
            every = runs[0]["save_every"]
            raise BarchanError(
                f"--step {step}: is not saved; allowed: multiples of {every}, and the last step"
            )


def _title(plan: Plan, variants: Sequence[Variant]) -> str:
    name = plan.title.partition(", changed: ")[0] or "Comparison"
    return f"{name}: {listed([variant.label for variant in variants])}"


def _write_data(folder: Path, variants: Sequence[Variant], tests: Sequence[Difference]) -> None:
    """Tables of measures, series, tests and slopes, and the complete scenario of each variant."""
    import pandas as pd

    write_tables(folder)
    rows = [(label, seed, *row) for label, seed, row in _slope_rows(variants)]
    middle = [f"{angle:g}" for angle in (SLOPES[1:] + SLOPES[:-1]) / 2]
    tables = {
        "series.csv": series_table(folder),
        "differences.csv": pd.DataFrame([{**vars(one), "significant": one.significant} for one in tests]),
        "slopes.csv": pd.DataFrame(rows, columns=["variant", "seed", *middle]),
    }
    for name, content in tables.items():
        with replacing(folder / name) as partial:
            content.to_csv(partial, index=False)
    write_scenarios(folder / SCENARIOS, variants)


def write_scenarios(folder: Path, variants: Sequence[Variant]) -> None:
    """Write the complete scenario of each variant into a folder."""
    folder.mkdir(exist_ok=True)
    for variant in variants:
        text = variant.scenario.model_copy(update={"title": variant.label}).text()
        (folder / f"{variant.name}.json").write_text(text, "utf-8")


def _slope_rows(variants: Sequence[Variant]) -> list[tuple[str, int, "np.ndarray"]]:
    shares = slopes_of(variants)
    return [
        (variant.label, seed, row)
        for variant in variants
        for seed, row in zip(variant.reports, shares[variant.label], strict=True)
    ]
