"""The shortest ways in: a scenario from anything that names one, a run in memory, a run on disk."""

import json
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from barchan.archive import Outcome, dataset_of, source_at
from barchan.archive import run as run_into
from barchan.scenario import Scenario, load_scenario
from barchan.scenario.overrides import ARGUMENT
from barchan.simulation import Simulation

if TYPE_CHECKING:
    import xarray as xr


def load(source: str | Path | Mapping[str, Any], **overrides: Any) -> Scenario:
    """A scenario: a preset by name, a JSON file, a run's folder, or plain data.

    ``overrides`` set single values, ``__`` standing for the dot: ``load("barchans", run__steps=100)``. Keys
    of ``run`` and ``lattice`` need no group, ``load("barchans", steps=100)``, and ``model="ripples"``
    chooses another model. Raises ScenarioError with every problem found.
    """
    pairs = [(key.replace("__", "."), json.dumps(value)) for key, value in overrides.items()]
    found = source if isinstance(source, Mapping) else source_at(source)
    return load_scenario(found, pairs, ARGUMENT)


def simulate(scenario: Scenario | str | Path | Mapping[str, Any], **overrides: Any) -> "xr.Dataset":
    """Run a scenario in memory; its frames with ``sand``, ``ground`` and ``elevation`` over (step, y, x).

    Anything that ``load`` takes is loaded first, with the ``overrides``: ``simulate("barchans", steps=100)``.
    Where steps have a duration the coordinate ``time`` (s) holds the frames' times.

    The dataset's attributes hold the complete scenario, with the seed that was used, and the reason why
    the run ended. Raises ScenarioError with every problem found.
    """
    if not isinstance(scenario, Scenario):
        scenario = load(scenario, **overrides)
    elif overrides:
        scenario = load(scenario.data(), **overrides)
    simulation = Simulation(scenario)
    dataset = dataset_of(simulation, list(simulation))
    dataset.attrs["stopped"] = simulation.finished or "all steps done"
    return dataset


def run(
    scenario: Simulation | Scenario | str | Path | Mapping[str, Any],
    path: str | Path,
    *,
    overwrite: bool = False,
    progress: Callable[[Simulation], None] | None = None,
    stop: Callable[[], bool] = lambda: False,
) -> Outcome:
    """Run a simulation, or anything that ``load`` takes, to its end into a new folder.

    ``progress`` is called about ten times a second; when ``stop`` says so the run is saved where it is and
    ends, to be resumed. Raises ScenarioError with every problem found, and ArchiveError where the folder is
    not empty or cannot be written; what was saved stays good.
    """
    if not isinstance(scenario, Simulation):
        scenario = Simulation(scenario if isinstance(scenario, Scenario) else load(scenario))
    return run_into(scenario, path, overwrite=overwrite, progress=progress, stop=stop)
