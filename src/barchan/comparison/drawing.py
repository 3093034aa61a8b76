"""The pictures of a comparison, as files in its folder."""

from collections.abc import Callable, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from barchan.archive import open_run
from barchan.comparison.variants import Variant, shared_measures
from barchan.ensembles.pictures import SMALL
from barchan.errors import BarchanError
from barchan.scenario import Scenario
from barchan.squares import Squares

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.figure import Figure

    from barchan.figures.comparison import Course

FIGURES = "figures"

DPI = 110
"""Dots per inch of the pictures in the report."""

SLOPES = np.linspace(-45.0, 45.0, 61)
"""Edges (degrees) of the intervals of slopes."""


@dataclass(frozen=True)
class Picture:
    """A picture of the report."""

    path: Path
    caption: str
    view: str
    """``map``, ``contours``, ``section``, ``space-time``, or what it shows of all variants."""
    step: int | None = None


def chosen_steps(variants: Sequence[Variant], wanted: Sequence[int] = ()) -> list[int]:
    """Steps that pictures show: the ``wanted`` ones, or the saved one nearest to the middle, and the last.

    Raises BarchanError for a step that was not saved.
    """
    with variants[0].run() as run:
        saved = [int(step) for step in run["step"].values]
    for step in wanted:
        if step not in saved:
            near = min(saved, key=lambda known: abs(known - step))
            raise BarchanError(f"--step {step}: was not saved; the nearest saved one is {near}")
    if wanted:
        return sorted(set(wanted))
    middle = min(saved, key=lambda step: abs(step - saved[-1] / 2))
    return sorted({middle, saved[-1]})


def common_limits(variants: Sequence[Variant], steps: Sequence[int]) -> tuple[float, float]:
    """Lowest and highest elevation (m) of sand in all pictures, so that all have one scale of colours."""
    from barchan.figures.maps import surface_range

    ranges = []
    for variant in variants:
        with variant.run() as run:
            ranges += [surface_range(_frame(run, step), variant.scenario) for step in steps]
    return min(low for low, _ in ranges), max(high for _, high in ranges)


def _frame(run: "xr.Dataset", step: int) -> "xr.Dataset":
    """The saved frame nearest to a step; a run may have ended earlier."""
    return run.sel(step=step, method="nearest").load()


def draw_variant(
    runs: str,
    data: str,
    label: str,
    drawn: str,
    name: str,
    folder: str,
    steps: Sequence[int],
    limits: tuple[float, float],
) -> list[Picture]:
    """Draw maps, contours, sections and the section over time of one run; for a process of its own.

    ``runs`` is the run's folder, ``data`` its scenario as JSON, ``drawn`` the label that pictures have.
    """
    import json

    from barchan.figures.contours import contour_map
    from barchan.figures.maps import relief_map
    from barchan.figures.sections import profile
    from barchan.figures.space_time import space_time
    from barchan.scenario import load_scenario

    scenario = load_scenario(json.loads(data)).model_copy(update={"title": drawn})
    home = Path(folder)
    views: tuple[tuple[str, Callable[[xr.Dataset], Figure]], ...] = (
        ("map", lambda frame: relief_map(frame, scenario, limits=limits)),
        ("contours", lambda frame: contour_map(frame, scenario, limits=limits)),
        ("section", lambda frame: profile(frame, scenario)),
    )
    made = []
    with open_run(runs) as run:
        for step in steps:
            frame = _frame(run, step)
            for view, draw in views:
                path = home / f"{name}-{view}-{step}.png"
                draw(frame).savefig(path, dpi=DPI)
                made.append(Picture(path, f"{label}, {view} at step {int(frame['step'])}", view, step))
        path = home / f"{name}-space-time.png"
        space_time(run, scenario).savefig(path, dpi=DPI)
        made.append(Picture(path, f"{label}, the section over time", "space-time"))
    return made


def draw_variants(
    variants: Sequence[Variant], folder: Path, steps: Sequence[int], executor: Executor
) -> dict[str, list[Picture]]:
    """Draw every variant's pictures, each in a worker of its own; lists of pictures by labels."""
    home = folder / FIGURES
    home.mkdir(parents=True, exist_ok=True)
    limits = common_limits(variants, steps)
    futures = {}
    for variant in variants:
        member = variant.first_member
        futures[variant.label] = executor.submit(
            draw_variant,
            str(variant.run_folder(member)),
            member.text,
            variant.label,
            variant.drawn,
            variant.name,
            str(home),
            tuple(steps),
            limits,
        )
    return {label: future.result() for label, future in futures.items()}


def draw_together(variants: Sequence[Variant], folder: Path) -> list[Picture]:
    """Draw what shows all variants in one: final maps, measures over time, slopes, differences."""
    from barchan.figures.comparison import measures_over_time, slope_distributions

    home = folder / FIGURES
    home.mkdir(parents=True, exist_ok=True)
    made = [Picture(draw_overview(variants, home / SMALL), "last frames of each seed", "overview")]
    path = home / "measures-over-time.png"
    measures_over_time(courses_of(variants), shared_measures(variants)).savefig(path, dpi=DPI)
    made.append(Picture(path, "measures over time", "series"))
    path = home / "slopes.png"
    shares = slopes_of(variants)
    drawn = {variant.drawn: shares[variant.label] for variant in variants}
    slope_distributions(SLOPES, drawn).savefig(path, dpi=DPI)
    made.append(Picture(path, "slopes along the wind in the last frames", "slopes"))
    return [*made, *_differences(variants, home)]


def courses_of(variants: Sequence[Variant]) -> "dict[str, list[Course]]":
    """Each shared measure of each variant over time, doubtful values left out."""
    from barchan.figures.comparison import Course

    return {
        name: [Course(variant.drawn, *_over_seeds(variant, name)) for variant in variants]
        for name in shared_measures(variants)
    }


def _over_seeds(variant: Variant, name: str) -> tuple[np.ndarray, np.ndarray]:
    """Steps, and values by (seed, step); NaN where a seed has none that may be quoted."""
    steps = np.unique([step for report in variant.reports.values() for step in report.series["step"]])
    values = np.full((len(variant.reports), len(steps)), np.nan)
    for row, report in zip(values, variant.reports.values(), strict=True):
        doubtful = set(report.doubtful.get(name, []))
        for step, value in zip(report.series["step"], report.series[name], strict=True):
            if value is not None and step is not None and int(step) not in doubtful:
                row[np.searchsorted(steps, step)] = value
    return steps.astype(float), values


def slopes_of(variants: Sequence[Variant]) -> dict[str, np.ndarray]:
    """Shares (seed, interval of ``SLOPES``) of slopes along the wind in the last frames, by label."""
    from barchan.measures.slopes import slope_shares

    found = {}
    for variant in variants:
        lattice, rows = variant.scenario.lattice, []
        for seed in variant.reports:
            with variant.run(seed) as run:
                last = run.isel(step=-1)
                wind = float(last["wind_direction"])
                surface = Squares(lattice).between(last["elevation"].values)
            rows.append(slope_shares(surface, lattice.cell_size, wind, SLOPES, lattice.periodic))
        found[variant.label] = np.array(rows)
    return found


MOST_SEEDS = 4
"""Realizations of each variant in the overview."""


def draw_overview(variants: Sequence[Variant], path: Path) -> Path:
    """Last frames, a row for each variant and a column for each of the first seeds."""
    from barchan.figures.ensembles import Panel, small_multiples

    panels = []
    across = min(*(len(variant.reports) for variant in variants), MOST_SEEDS)
    for variant in variants:
        for seed in list(variant.reports)[:across]:
            with variant.run(seed) as run:
                frame = run.isel(step=-1).load()
            panels.append(Panel(f"{variant.drawn}, seed {seed}", frame, variant.scenario))
    if across == 1:
        across = min(len(panels), 4)
    small_multiples(panels[: 100 // across * across], across, "").savefig(path, dpi=DPI)
    return path


def _differences(variants: Sequence[Variant], home: Path) -> list[Picture]:
    """Maps of last surfaces less the reference's with the same seed, where fields have one size."""
    from barchan.figures.comparison import difference_map

    reference, *others = variants
    last: dict[str, xr.Dataset] = {}
    seeds: dict[str, int] = {}
    for other in others:
        common = [seed for seed in reference.reports if seed in other.reports]
        if common and other.scenario.lattice == reference.scenario.lattice:
            seeds[other.label] = common[0]
            with other.run(common[0]) as run:
                last[other.label] = run.isel(step=-1).load()
    bases = {}
    for seed in set(seeds.values()):
        with reference.run(seed) as run:
            bases[seed] = run.isel(step=-1).load()
    pairs = [(label, frame, bases[seeds[label]]) for label, frame in last.items()]
    if not pairs:
        return []
    spans = [np.percentile(np.abs(f["elevation"].values - b["elevation"].values), 99) for _, f, b in pairs]
    limit = max(float(max(spans)), 1e-6)
    made = []
    for other in others:
        if other.label not in last:
            continue
        text = f"higher (m) than {reference.drawn}"
        titled: Scenario = other.scenario.model_copy(
            update={"title": f"{other.drawn} less {reference.drawn}"}
        )
        frame, base = last[other.label], bases[seeds[other.label]]
        path = home / f"{other.name}-difference.png"
        difference_map(frame, base, titled, limit, text).savefig(path, dpi=DPI)
        caption = f"{other.label} less {reference.label}, seed {seeds[other.label]}, last step"
        made.append(Picture(path, caption, "difference"))
    return made
