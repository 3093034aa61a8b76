"""Kept states of a run written for other programs."""

import zipfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from barchan.archive import dataset_of
from barchan.export import export
from barchan.export.options import in_words
from barchan.simulation import Simulation, State
from barchan.studio.worker.background import Count


def export_states(states: Sequence[State], target: Path, options: dict[str, Any], count: Count) -> str:
    """Write states as a format of ``barchan export``; the name of the file for the page to fetch.

    Formats of one frame a file get a file for each state. Several files become one ``.zip`` beside them.
    ``count`` takes how far it is: half of it is reading the states, half drawing a film of them. Raises
    ExportError for what ``export`` refuses, in the words of the page.
    """
    frames, half = [], len(states)
    for number, state in enumerate(states):
        frames.append(Simulation.from_state(state).frame())
        count(number + 1, 2 * half)
    dataset = dataset_of(Simulation.from_state(states[-1]), frames)
    target.parent.mkdir(parents=True, exist_ok=True)
    with in_words():
        written = export(
            dataset, target, step="all", progress=lambda done: count(half + done, 2 * half), **options
        )
    files = [path for path in target.parent.rglob("*") if path.is_file()]
    data = [path for path in files if path != written[-1]]
    if len(data) == 1:
        return data[0].name
    packed = target.with_suffix(".zip")
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for path in files:
            archive.write(path, path.relative_to(target.parent))
    return packed.name
