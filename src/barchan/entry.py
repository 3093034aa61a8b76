"""The two shortest ways in: a scenario from anything that names one, and a run in memory."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from barchan.archive import dataset_of, source_at
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
