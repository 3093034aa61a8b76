"""One published model a file. Every file here, and every installed entry point ``barchan.models``, is found.

A model says what it is (name, citation, parameters, fields) and how a bed changes; nothing here knows of
scenarios, files or screens.
"""

import importlib
import pkgutil
from functools import cache
from importlib.metadata import entry_points
from typing import Any

from barchan.errors import BarchanError
from barchan.model import Curve, Derived, Model, ModelMeasure, Overlay, Tally
from barchan.parameters import Parameters, parameter

_ENGINES = {
    "GrainModel": "barchan.grains.model",
    "GrainFlight": "barchan.grains.parameters",
    "SlabModel": "barchan.slabs.model",
    "SlabParameters": "barchan.slabs.parameters",
    "SpeedupModel": "barchan.slabs.speedup",
    "SpeedupParameters": "barchan.slabs.speedup",
}
"""Modules of the names that the engines offer to authors of models."""

__all__ = [
    "Curve",
    "Derived",
    "GrainFlight",
    "GrainModel",
    "Model",
    "ModelMeasure",
    "Overlay",
    "Parameters",
    "SlabModel",
    "SlabParameters",
    "SpeedupModel",
    "SpeedupParameters",
    "Tally",
    "model",
    "model_names",
    "models",
    "parameter",
]


def __getattr__(name: str) -> Any:
    if name not in _ENGINES:
        raise AttributeError(f"module 'barchan.models' has no attribute '{name}'")
    return getattr(importlib.import_module(_ENGINES[name]), name)


@cache
def models() -> dict[str, type[Model]]:
    """All models by name, in order of name."""
    found: dict[str, type[Model]] = {}
    for module in pkgutil.iter_modules(__path__):
        for candidate in vars(importlib.import_module(f"{__name__}.{module.name}")).values():
            if isinstance(candidate, type) and issubclass(candidate, Model) and candidate.name:
                found[candidate.name] = candidate
    for point in entry_points(group="barchan.models"):
        candidate = point.load()
        if candidate.name in found:
            raise BarchanError(f"two models are called '{candidate.name}'; the second is {point.value}")
        found[candidate.name] = candidate
    return dict(sorted(found.items()))


def model_names() -> list[str]:
    """Names of all models."""
    return list(models())


def model(name: str) -> type[Model]:
    """The model of that name; raises KeyError where there is none."""
    return models()[name]
