"""The pictures of an ensemble: which runs stand where, and what is drawn over the varied keys."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from barchan.archive import open_run
from barchan.archive.file_names import file_names, paths_in
from barchan.ensembles.axes import Axis, value_label
from barchan.ensembles.plan import Member, Plan
from barchan.ensembles.reports import State, member_folder, state_of
from barchan.ensembles.table import measure_table, short_names
from barchan.figures.ensembles import MOST_PANELS, Panel, phase_diagram, small_multiples
from barchan.scenario import load_scenario
from barchan.scenario.paths import with_paths

SMALL = "small-multiples.png"

ACROSS = 5
"""Small maps in a row where the axes do not say how many."""


def draw_small_multiples(folder: Path, plan: Plan) -> list[Path]:
    """Draw the last frame of the first finished realization of each point; the file, or none for too many.

    A grid of two axes has a column for each value of the last one.
    """
    first: dict[int, Member] = {}
    for member in plan.members:
        if state_of(folder, member.id) == State.DONE:
            first.setdefault(member.point, member)
    if len(first) > MOST_PANELS:
        return []
    across = len(plan.axes[-1].values) if plan.design == "grid" and len(plan.axes) == 2 else ACROSS
    if len(first) < len(plan.points):
        across = min(ACROSS, len(first))
    panels = [_panel(folder, plan, member) for member in first.values()]
    figure = small_multiples(panels, min(across, len(panels)), f"{plan.title or 'Runs'}, last frames")
    figure.savefig(folder / SMALL)
    return [folder / SMALL]


def _panel(folder: Path, plan: Plan, member: Member) -> Panel:
    with open_run(member_folder(folder, member.id)) as run:
        frame = run.isel(step=-1).load()
    return Panel(label_of(plan, member) or f"seed {member.seed}", frame, load_scenario(member.scenario))


def label_of(plan: Plan, member: Member) -> str:
    """The values of a member, for people to read: ``momiji, hop_length 3``; files without their folders."""
    names = _names_of_files(plan)
    return ", ".join(
        _label(axis, name, value, names)
        for axis, name, value in zip(plan.axes, short_names(plan), member.values, strict=True)
    )


def _label(axis: Axis, name: str, value: Any, names: Mapping[str, str]) -> str:
    if _is_file(axis):
        return f"{axis.key.split('.')[-2]} {names.get(value, value)}"
    label = value_label(with_paths(value, lambda path: names.get(path, path)))
    grouped = axis.key.endswith((".name", ".kind")) or isinstance(value, dict)
    return label if grouped else f"{name.rpartition('.')[2]} {label}"


def _is_file(axis: Axis) -> bool:
    return axis.key.endswith(".path")


def _names_of_files(plan: Plan) -> dict[str, str]:
    """The names of all files that the axes of a plan vary."""
    every = [{"path": value} if _is_file(axis) else value for axis in plan.axes for value in axis.values]
    return file_names(paths_in(every))


def draw_measures(folder: Path, plan: Plan, measures: Sequence[str]) -> list[Path]:
    """Draw measures over the one or two varied keys; the files."""
    table = measure_table(folder)
    names = _names_of_files(plan)
    for axis, column in zip(plan.axes, short_names(plan), strict=True):
        if _is_file(axis):
            table[column] = [names.get(value, value) for value in table[column]]
    written = []
    for name in measures:
        figure = phase_diagram(table, name, table.attrs["units"].get(name, ""), short_names(plan))
        written.append(folder / f"{name}.png")
        figure.savefig(written[-1])
    return written
