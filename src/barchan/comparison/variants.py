"""The variants of a comparison: a model and its varied values, with a run for each seed."""

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from barchan.archive import open_run
from barchan.archive.file_names import with_file_names
from barchan.ensembles.pictures import label_of
from barchan.ensembles.plan import Member, Plan
from barchan.ensembles.reports import Report, member_folder, read_report
from barchan.errors import BarchanError
from barchan.scenario import Scenario, load_scenario

if TYPE_CHECKING:
    import xarray as xr


WORDS = ("title", "citation", "look_for", "question")
"""Keys of a scenario that say something of it and change nothing of its run."""


MOST_LETTERS = 60
"""Of a variant's label in the name of a file."""

MOST_DRAWN = 90
"""Letters of a variant's label in figures; the page has all of it."""


@dataclass
class Variant:
    """One of the things compared."""

    label: str
    number: int
    folder: Path
    """Folder of the ensemble."""
    members: list[Member] = field(default_factory=list)
    reports: dict[int, Report] = field(default_factory=dict)
    """Reports of finished runs by seed."""

    @property
    def name(self) -> str:
        """Its label as part of the name of a file."""
        label = re.sub(r"[^0-9A-Za-z.]+", "-", self.label).strip("-")
        return f"{self.number + 1}-{label[:MOST_LETTERS].rstrip('-.')}"

    @property
    def drawn(self) -> str:
        """Its label in figures: one that is too long is cut, with its number before it."""
        if len(self.label) <= MOST_DRAWN:
            return self.label
        return f"{self.number + 1}: {self.label[: MOST_DRAWN - 4].rstrip(' ,')}…"

    @property
    def first_member(self) -> Member:
        """Its first finished run, which pictures show."""
        return next(member for member in self.members if member.seed in self.reports)

    def run_folder(self, member: Member) -> Path:
        """The folder of one of its runs."""
        return member_folder(self.folder, member.id)

    @property
    def scenario(self) -> Scenario:
        """The scenario of its first finished run, under its label."""
        return load_scenario(self.first_member.scenario).model_copy(update={"title": self.label})

    @property
    def own_scenario(self) -> Scenario:
        """The scenario of its first run, finished or not, under its own title."""
        return load_scenario(self.members[0].scenario)

    @property
    def title_of_model(self) -> str:
        """The model's full name."""
        return self.scenario.new_model().title

    def run(self, seed: int | None = None) -> "xr.Dataset":
        """The frames of its run with a seed, or of its first one."""
        chosen = [member for member in self.members if member.seed == seed] or [self.first_member]
        return open_run(self.run_folder(chosen[0]))

    def finals(self, measure: str) -> dict[int, float]:
        """A measure of the last frame by seed, where it may be quoted."""
        return {
            seed: report.last(measure)
            for seed, report in self.reports.items()
            if not report.is_doubtful(measure) and np.isfinite(report.last(measure))
        }


def variants_of(plan: Plan, folder: Path) -> list[Variant]:
    """The variants of a comparison that have finished runs, in order; raises BarchanError where none has."""
    found: dict[int, Variant] = {}
    for member in plan.members:
        label = label_of(plan, member) or member.scenario["model"]["name"]
        variant = found.setdefault(member.point, Variant(label, member.point, folder))
        variant.members.append(member)
        report = read_report(folder, member.id)
        if report is not None:
            variant.reports[member.seed] = report
    told_apart(list(found.values()))
    finished = [variant for variant in found.values() if variant.reports]
    if not finished:
        raise BarchanError(f"{folder}: no run of the comparison came to its end")
    return finished


def told_apart(variants: Sequence[Variant]) -> None:
    """Give labels that several variants have the number of each."""
    labels = [variant.label for variant in variants]
    for variant, label in zip(variants, labels, strict=True):
        if labels.count(label) > 1:
            variant.label = f"{label} ({variant.number + 1})"


def shared_measures(variants: Sequence[Variant]) -> dict[str, tuple[str, str]]:
    """Title and unit of each measure that all variants have, by name."""
    first, *others = [next(iter(variant.reports.values())) for variant in variants]
    return {
        name: (first.titles[name], unit)
        for name, unit in first.units.items()
        if all(name in other.units for other in others)
    }


def differing_keys(variants: Sequence[Variant]) -> dict[str, list[Any]]:
    """Keys of the scenarios whose values differ, with the value of each variant; None where it has none.

    Files stand by their names without folders; copies of one file do not differ.
    """
    unnamed = dict.fromkeys(WORDS, "")
    whole = with_file_names({**variant.own_scenario.data(), **unnamed} for variant in variants)
    flat = [_flat(data) for data in whole]
    keys = dict.fromkeys(key for values in flat for key in values)
    rows = {key: [values.get(key) for values in flat] for key in keys}
    return {key: row for key, row in rows.items() if any(value != row[0] for value in row)}


def unlike_defaults(variant: Variant) -> dict[str, tuple[Any, Any]]:
    """Parameters of a variant's model that are not the model's own defaults: value and default."""
    chosen = variant.scenario.model
    own = _flat(type(chosen)().model_dump(mode="json"))
    now = _flat(chosen.model_dump(mode="json"))
    return {key: (value, own.get(key)) for key, value in now.items() if value != own.get(key)}


def _flat(data: Any, prefix: str = "") -> dict[str, Any]:
    if not isinstance(data, dict):
        return {prefix: data}
    found: dict[str, Any] = {}
    for key, value in data.items():
        found |= _flat(value, f"{prefix}.{key}" if prefix else key)
    return found
