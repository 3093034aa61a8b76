"""The two shortest ways in: a scenario from anything that names one, and a run in memory."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from barchan.archive import dataset_of, source_at
from barchan.scenario import Scenario, load_scenario
from barchan.simulation import Simulation

if TYPE_CHECKING:
    import xarray as xr


def load(source: str | Path | Mapping[str, Any], **overrides: Any) -> Scenario:
    """A scenario: a preset by name, a JSON file, a run's folder, or plain data.

    ``overrides`` set single values, ``__`` standing for the dot: ``load("barchans", run__steps=100)``.
    Raises ScenarioError with every problem found.
    """
    pairs = [(key.replace("__", "."), json.dumps(value)) for key, value in overrides.items()]
    return load_scenario(source if isinstance(source, Mapping) else source_at(source), pairs)


def simulate(scenario: Scenario) -> "xr.Dataset":
    """Run a scenario in memory; its frames with ``sand``, ``ground`` and ``elevation`` over (step, y, x).

    Where steps have a duration the coordinate ``time`` (s) holds the frames' times.

    The dataset's attributes hold the complete scenario, with the seed that was used, and the reason why
    the run ended.
    """
    simulation = Simulation(scenario)
    dataset = dataset_of(simulation, list(simulation))
    dataset.attrs["stopped"] = simulation.finished or "all steps done"
    return dataset
