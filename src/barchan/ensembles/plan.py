"""The plan of an ensemble: its members, each a complete scenario with a name made of it."""

import hashlib
import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Literal, get_args

from barchan.ensembles.axes import Axis, read_axes
from barchan.ensembles.design import Design, Point, points_of
from barchan.errors import ArchiveError, BarchanError, Problem, ScenarioError
from barchan.replacing import replacing
from barchan.scenario import Scenario, load_scenario
from barchan.scenario.definition import LARGEST_SEED
from barchan.scenario.listing import all_keys
from barchan.scenario.overrides import Override
from barchan.words import counted

PLAN = "ensemble.json"

PLAN_FORMAT = 1

Pairing = Literal["common", "independent"]

PAIRINGS: tuple[str, ...] = get_args(Pairing)

ID_DIGITS = 12
"""Hexadecimal digits of a member's name."""


@dataclass(frozen=True)
class Seeds:
    """The seeds of the realizations of each point."""

    count: int = 1
    first: int = 1
    """Seed of the first realization."""
    pairing: Pairing = "common"
    """``common``: every point has the same seeds, so that points differ in nothing else; ``independent``:
    no two members share one."""

    def of(self, point: int, realization: int) -> int:
        """The seed of a realization of the point of that number."""
        shift = point * self.count if self.pairing == "independent" else 0
        return self.first + shift + realization

    def check(self, points: int) -> None:
        """Raise BarchanError where there are none, or one would be too large."""
        if self.count < 1:
            raise BarchanError(f"--seeds {self.count}: allowed: 1 or more")
        if self.first < 0 or self.of(points - 1, self.count - 1) > LARGEST_SEED:
            raise BarchanError(f"--first-seed {self.first}: allowed: seeds from 0 to {LARGEST_SEED}")


@dataclass(frozen=True)
class Member:
    """One run of an ensemble."""

    id: str
    """The first digits of the digest of its complete scenario without the number of threads."""
    point: int
    values: Point
    """The value of each axis."""
    realization: int
    seed: int
    scenario: Mapping[str, Any]
    """The complete scenario as plain data."""

    @property
    def text(self) -> str:
        """Its complete scenario as JSON."""
        return json.dumps(self.scenario)


@dataclass(frozen=True)
class Plan:
    """All members of an ensemble, and what they were made of."""

    title: str
    axes: tuple[Axis, ...]
    design: Design
    seeds: Seeds
    members: tuple[Member, ...]

    @property
    def points(self) -> list[Point]:
        """The values of the axes at each point, in order."""
        return list({member.point: member.values for member in self.members}.values())

    def save(self, folder: Path) -> None:
        """Write the plan into the folder of the ensemble; raises ArchiveError where that fails.

        A folder that holds another plan is taken over: members that both have are kept.
        """
        try:
            folder.mkdir(parents=True, exist_ok=True)
            if not (folder / PLAN).is_file() and any(folder.iterdir()):
                raise ArchiveError(f"{folder} is not empty and holds no ensemble; choose another folder")
            with replacing(folder / PLAN) as partial:
                data = {"format": PLAN_FORMAT, **asdict(self)}
                partial.write_text(json.dumps(data, indent=1, ensure_ascii=False) + "\n", "utf-8")
        except FileExistsError:
            raise ArchiveError(f"{folder} is a file, not a folder") from None
        except OSError as error:
            raise ArchiveError(f"cannot write to {folder}: {error.strerror or error}") from error


def load_plan(folder: str | Path) -> Plan:
    """The plan in the folder of an ensemble; raises ArchiveError where there is none that can be read."""
    path = Path(folder) / PLAN
    try:
        data = json.loads(path.read_text("utf-8"))
    except FileNotFoundError:
        raise ArchiveError(f"{folder}: no ensemble (it has no {PLAN})") from None
    except (OSError, ValueError) as error:
        raise ArchiveError(f"{path} cannot be read: {error}") from None
    if not isinstance(data, dict) or data.get("format") != PLAN_FORMAT:
        found = data.get("format") if isinstance(data, dict) else None
        raise ArchiveError(f"{path} has format {found}; this version of Barchan reads {PLAN_FORMAT}")
    return Plan(
        data["title"],
        tuple(Axis(a["key"], tuple(a["values"]), a["spacing"]) for a in data["axes"]),
        data["design"],
        Seeds(**data["seeds"]),
        tuple(Member(**{**m, "values": tuple(m["values"])}) for m in data["members"]),
    )


def make_plan(
    source: str | Path | Mapping[str, Any],
    axes: Sequence[Axis] = (),
    *,
    design: Design = "grid",
    count: int | None = None,
    seeds: int = 1,
    first_seed: int | None = None,
    pairing: Pairing = "common",
    overrides: Sequence[Override] = (),
) -> Plan:
    """The plan of an ensemble over a preset, a file or plain data, all members checked.

    There are ``seeds`` realizations of each point, from ``first_seed`` on, without it from the scenario's own
    seed, or from 1. Raises ScenarioError with every value of any member that is not allowed, and BarchanError
    where axes and design do not fit.
    """
    base = load_scenario(source, overrides)
    first = next((seed for seed in (first_seed, base.run.seed) if seed is not None), 1)
    chosen = Seeds(seeds, first, pairing)
    points = points_of(axes, design, count, [_is_whole(axis.key) for axis in axes], first)
    chosen.check(len(points))
    members: list[Member] = []
    problems: list[Problem] = []
    for number, point in enumerate(points):
        given = [(axis.key, json.dumps(value)) for axis, value in zip(axes, point, strict=True)]
        try:
            scenario = load_scenario(source, [*overrides, *given])
        except ScenarioError as error:
            problems += error.problems
            continue
        members += [_member(scenario, number, point, k, chosen.of(number, k)) for k in range(seeds)]
    if problems:
        raise ScenarioError(list(dict.fromkeys(problems)), f"{counted(len(points), 'point')} of the ensemble")
    return Plan(base.title, tuple(axes), design, chosen, tuple(members))


def make_varied_plan(
    source: str | Path | Mapping[str, Any], vary: Sequence[str], axes: Sequence[Axis] = (), **design: Any
) -> Plan:
    """The plan over ``axes`` and those that texts such as ``model.hop_length=1,3,5`` state.

    ``design`` as in ``make_plan``. Raises ScenarioError with every text that is no axis and every value of
    the others that is not allowed, and BarchanError where axes and design do not fit.
    """
    stated, problems = read_axes(vary)
    try:
        plan = make_plan(source, [*axes, *stated], **design)
    except BarchanError as error:
        if not problems:
            raise
        problems += error.problems if isinstance(error, ScenarioError) else []
    if problems:
        raise ScenarioError(problems, "command line")
    return plan


def plan_of_scenarios(
    title: str, axes: Sequence[Axis], scenarios: Sequence[tuple[Point, Scenario]], seeds: int, first_seed: int
) -> Plan:
    """The plan of an ensemble whose points are scenarios of their own, each with the same seeds.

    Raises BarchanError where a seed is not allowed.
    """
    chosen = Seeds(seeds, first_seed)
    chosen.check(len(scenarios))
    members = [
        _member(scenario, number, point, k, chosen.of(number, k))
        for number, (point, scenario) in enumerate(scenarios)
        for k in range(seeds)
    ]
    return Plan(title, tuple(axes), "grid", chosen, tuple(members))


def _member(scenario: Scenario, number: int, point: Point, realization: int, seed: int) -> Member:
    run = scenario.run.model_copy(update={"seed": seed, "threads": None})
    data = scenario.model_copy(update={"run": run}).data()
    return Member(member_id(data), number, point, realization, seed, data)


def member_id(data: Mapping[str, Any]) -> str:
    """The name of the member with that complete scenario: the same for the same run."""
    counted = {**data, "run": {k: v for k, v in data["run"].items() if k != "threads"}}
    canonical = json.dumps(counted, sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(canonical.encode()).hexdigest()[:ID_DIGITS]


def _is_whole(key: str) -> bool:
    """Whether the values of a key must be whole numbers."""
    kinds = {known.type for known in all_keys() if known.key == key}
    return kinds == {"whole number"}
