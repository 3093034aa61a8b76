"""One published model a file. Every file here, and every installed entry point ``barchan.models``, is found.

A model says what it is (name, citation, parameters, fields) and how a bed changes; nothing here knows of
scenarios, files or screens.
"""

import importlib
import pkgutil
import warnings
from functools import cache
from importlib.metadata import EntryPoint, entry_points
from typing import Any

from barchan.errors import BarchanError
from barchan.model import Curve, Derived, Model, ModelMeasure, Overlay, Strata, Tally
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
    "Strata",
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
        candidate = _loaded(point)
        if candidate is None:
            continue
        if candidate.name in found:
            raise BarchanError(f"two models are called '{candidate.name}'; the second is {point.value}")
        found[candidate.name] = candidate
    return dict(sorted(found.items()))


def _loaded(point: EntryPoint) -> type[Model] | None:
    """The model that a package brings; None, with a warning that names it, where it cannot be used."""
    try:
        candidate = point.load()
        reason = _unfit(candidate)
    except Exception as error:
        reason = f"{type(error).__name__}: {error}"
    if not reason:
        return candidate
    warnings.warn(f"the model {point.name} ({point.value}) is left out: {reason}", stacklevel=3)
    return None


def _unfit(candidate: Any) -> str:
    """Why something that a package registers is no model; empty where it is one."""
    if not (isinstance(candidate, type) and issubclass(candidate, Model)):
        return "it is not a class derived from barchan.models.Model"
    if not candidate.name:
        return "it has no name"
    if getattr(candidate, "__abstractmethods__", None):
        return f"it lacks {', '.join(sorted(candidate.__abstractmethods__))}"
    declared = candidate.Parameters.model_fields.get("name")
    if declared is None or declared.default != candidate.name:
        return f"its Parameters lack the key name with the only value '{candidate.name}'"
    return ""


def model_names() -> list[str]:
    """Names of all models."""
    return list(models())


def model(name: str) -> type[Model]:
    """The model of that name; raises KeyError where there is none."""
    return models()[name]
