"""Published results as data: set-ups as changed presets, and what was reported of them."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from importlib.resources import files
from typing import Any

from barchan.ensembles.axes import Axis
from barchan.ensembles.plan import Plan, plan_of_scenarios
from barchan.errors import BarchanError
from barchan.scenario import Scenario, load_scenario, nearest

CASE = "case.name"
"""The axis along which the cases of a set lie."""


@dataclass(frozen=True)
class Case:
    """A preset and the values that it takes instead of its own, by dotted key."""

    preset: str
    values: Mapping[str, Any] = field(default_factory=dict)

    def scenario(self) -> Scenario:
        """Its complete scenario."""
        return load_scenario(self.preset, [(key, json.dumps(value)) for key, value in self.values.items()])


@dataclass(frozen=True)
class Claim:
    """Something reported of a result; without a case it is for the eye alone.

    What is stated decides how it is judged: a ``value`` of a measure in one published run; a measure greater
    than another one, or than in another case; two measures that differ by no more than ``within``, or than a
    ``share``; a class of landform among ``forms`` (``none``: outside them); the ``step`` at which runs end.
    """

    words: str
    case: str = ""
    measure: str = ""
    value: float | None = None
    rounding: float = 0.0
    """Half of the last digit of the value."""
    than_case: str = ""
    than_measure: str = ""
    within: float | None = None
    share: float | None = None
    forms: Sequence[str] = ()
    none: bool = False
    step: int | None = None


@dataclass(frozen=True)
class Experiment:
    """A figure or section of the source: its cases, and what was reported."""

    name: str
    figure: str
    title: str
    reported: str
    cases: Sequence[str]
    claims: Sequence[Claim]
    steps: Sequence[int] = ()
    """Steps that pictures show; the last one where there are none."""
    brief: bool = False
    """Whether the last frames side by side are all its pictures."""


@dataclass(frozen=True)
class PublishedSet:
    """All experiments of a source."""

    name: str
    title: str
    source: str
    cases: Mapping[str, Case]
    experiments: Sequence[Experiment]


def set_names() -> list[str]:
    """The names of all sets."""
    return sorted(
        path.name.removesuffix(".json") for path in _folder().iterdir() if path.name.endswith(".json")
    )


def load_set(name: str) -> PublishedSet:
    """The set of that name; raises BarchanError where there is none."""
    if name not in set_names():
        known = ", ".join(set_names())
        raise BarchanError(f"--preset-set {name}: no such set; allowed: {known}{nearest(name, set_names())}")
    data = json.loads((_folder() / f"{name}.json").read_text("utf-8"))
    cases = {case: Case(**content) for case, content in data["cases"].items()}
    experiments = [
        Experiment(**{**one, "claims": [Claim(**claim) for claim in one["claims"]]})
        for one in data["experiments"]
    ]
    return PublishedSet(name, data["title"], data["source"], cases, experiments)


def plan_of(chosen: PublishedSet, seeds: int, first_seed: int = 1) -> Plan:
    """The plan of an ensemble of all cases, each with the same seeds."""
    scenarios = [((name,), case.scenario()) for name, case in chosen.cases.items()]
    axis = Axis(CASE, tuple(chosen.cases))
    return plan_of_scenarios(chosen.title, (axis,), scenarios, seeds, first_seed)


def _folder() -> Any:
    return files("barchan.comparison.published")
