"""Barchan: surfaces that wind shapes.

>>> import barchan
>>> scenario = barchan.load("barchans")
>>> run = barchan.simulate(scenario)
>>> run.elevation.isel(step=-1).plot()
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from barchan.version import __version__

if TYPE_CHECKING:
    from barchan.archive import branch, open_run, resume
    from barchan.ensembles.results import open_ensemble
    from barchan.entry import load, run, simulate
    from barchan.errors import ArchiveError, BarchanError, ScenarioError
    from barchan.models import model_names
    from barchan.scenario import Scenario, preset_names
    from barchan.simulation import (
        IceStroke,
        PlantStroke,
        RockStroke,
        SetParameter,
        SetWind,
        Simulation,
        SnowfallStroke,
        Stroke,
    )
    from barchan.survey import measure

_HOMES = {
    "ArchiveError": "errors",
    "BarchanError": "errors",
    "IceStroke": "simulation",
    "PlantStroke": "simulation",
    "RockStroke": "simulation",
    "Scenario": "scenario",
    "ScenarioError": "errors",
    "SetParameter": "simulation",
    "SetWind": "simulation",
    "Simulation": "simulation",
    "SnowfallStroke": "simulation",
    "Stroke": "simulation",
    "branch": "archive",
    "load": "entry",
    "measure": "survey",
    "model_names": "models",
    "open_ensemble": "ensembles.results",
    "open_run": "archive",
    "preset_names": "scenario",
    "resume": "archive",
    "run": "entry",
    "simulate": "entry",
}

_RETURN_RUNS = ("open_run", "simulate")
"""Functions whose datasets have the accessor ``run.barchan``."""

__all__ = [
    "ArchiveError",
    "BarchanError",
    "IceStroke",
    "PlantStroke",
    "RockStroke",
    "Scenario",
    "ScenarioError",
    "SetParameter",
    "SetWind",
    "Simulation",
    "SnowfallStroke",
    "Stroke",
    "__version__",
    "branch",
    "load",
    "measure",
    "model_names",
    "open_ensemble",
    "open_run",
    "preset_names",
    "resume",
    "run",
    "simulate",
]


def __dir__() -> list[str]:
    return sorted(__all__)


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'barchan' has no attribute '{name}'")
    if name in _RETURN_RUNS:
        import_module("barchan.accessor")
    return getattr(import_module(f"barchan.{_HOMES[name]}"), name)
