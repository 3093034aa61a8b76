"""The report on runs that exist already, as those of the studio: they are measured and drawn, not run."""

import math
import time
from collections.abc import Callable, Sequence
from concurrent.futures import Executor, Future
from pathlib import Path
from typing import Any

from barchan.archive import RunInfo, run_info
from barchan.comparison.drawing import chosen_steps, draw_together, draw_variants
from barchan.comparison.report import Contents, report_of
from barchan.comparison.statistics import differences
from barchan.comparison.variants import Variant, differing_keys, told_apart
from barchan.comparison.words import listed
from barchan.ensembles.axes import value_label
from barchan.ensembles.plan import Member
from barchan.ensembles.reports import MEMBERS, report_on
from barchan.errors import ArchiveError
from barchan.replacing import replacing
from barchan.words import spoken_name

Count = Callable[[int, int], None]
"""Takes how much is done, and of how much; what it raises ends the work."""

MOST_NAMED = 2
"""Differing values that a run is called by."""

MOST_LETTERS = 40
"""Of a value that a run is called by."""


def members_home(folder: Path) -> Path:
    """Where ``compare_runs`` looks for the runs to compare: archives in a folder each."""
    return folder / MEMBERS


def compare_runs(
    runs: Sequence[Path], target: Path, count: Count = lambda _done, _of: None, made_by: str = ""
) -> Path:
    """Write the report that compares saved runs as one file, pictures and scenarios within; returns it.

    The runs lie in ``members_home`` of the report's folder; the first one is the reference. Measures are
    those of their frames. ``made_by`` is how the report can be made again. Raises ArchiveError where a run
    cannot be read or the report not be written.
    """
    began = time.monotonic()
    infos = [run_info(path) for path in runs]
    variants = [_variant(number, info) for number, info in enumerate(infos)]
    _name(variants)
    counter = _Counter(count, sum(info.frames for info in infos) + len(runs) + 1)
    for variant in variants:
        (member,) = variant.members
        report = report_on(variant.folder, member.id, variant.own_scenario, math.nan, math.nan, counter.add)
        variant.reports[member.seed] = report
    try:
        together = draw_together(variants, target.parent)
        counter.add()
        alone = draw_variants(variants, target.parent, chosen_steps(variants), _Here(counter))
        scenario = variants[0].own_scenario
        title = scenario.title.partition(", changed: ")[0] or "Comparison"
        contents = Contents(
            f"{title}: {listed([variant.label for variant in variants])}",
            _changes(variants, infos),
            made_by,
            time.monotonic() - began,
            variants,
            differences(variants),
            together,
            alone,
            {},
            alone=True,
        )
        with replacing(target) as partial:
            partial.write_text(report_of(contents), "utf-8")
    except OSError as error:
        raise ArchiveError(f"cannot write to {target}: {error.strerror or error}") from error
    return target


def _variant(number: int, info: RunInfo) -> Variant:
    """A saved run as a variant; its scenario ends where the run does."""
    run = info.scenario.run.model_copy(update={"steps": max(info.last_step, 1), "threads": None})
    scenario = info.scenario.model_copy(update={"run": run})
    name = info.path.name
    member = Member(name, number, (), 0, scenario.seed, scenario.data())
    return Variant(name, number, info.path.parents[1], [member])


def _name(variants: Sequence[Variant]) -> None:
    """Call variants by their models, or where these are the same by what differs."""
    names = [variant.members[0].scenario["model"]["name"] for variant in variants]
    if len(set(names)) == len(names):
        for variant, name in zip(variants, names, strict=True):
            variant.label = name
        return
    differing = list(differing_keys(variants).items())[:MOST_NAMED]
    for number, variant in enumerate(variants):
        told = [f"{_spoken_key(key)} {_short(values[number])}" for key, values in differing]
        variant.label = ", ".join(told) or f"run {variant.label.upper()}"
    told_apart(variants)


def _spoken_key(key: str) -> str:
    """The last part of a key in words; of a file what it is of."""
    return spoken_name(key.removesuffix(".path"))


def _short(value: object) -> str:
    text = f"{value:g}" if isinstance(value, float) else value_label(value)
    return text if len(text) <= MOST_LETTERS else f"{text[: MOST_LETTERS - 1]}…"


def _changes(variants: Sequence[Variant], infos: Sequence[RunInfo]) -> str:
    """How many changes were made while each ran; empty where none was."""
    found = [(variant.label, len(info.events)) for variant, info in zip(variants, infos, strict=True)]
    return "; ".join(
        f"{count} change{'s' * (count > 1)} while {label} ran" for label, count in found if count
    )


class _Counter:
    def __init__(self, count: Count, of: int) -> None:
        self._count, self._of, self._done = count, of, 0

    def add(self) -> None:
        self._done += 1
        self._count(min(self._done, self._of), self._of)


class _Here(Executor):
    """Does work at once, in the thread that hands it out."""

    def __init__(self, counter: _Counter) -> None:
        self._counter = counter

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> "Future[Any]":
        """The work, done."""
        future: Future[Any] = Future()
        future.set_result(fn(*args, **kwargs))
        self._counter.add()
        return future
