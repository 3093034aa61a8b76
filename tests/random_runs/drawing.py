"""Small scenarios drawn at random over the whole schema, from the declarations themselves.

New keys are covered by being declared. A scenario comes from its number alone, so a failure can be repeated:
``python -m tests.random_runs 17`` runs number 17.
"""

import math
from random import Random
from typing import Any, Literal, get_args, get_origin

from pydantic import BaseModel

from barchan.ground.area import Area
from barchan.models import models
from barchan.parameters import NOTE, Parameters
from barchan.scenario import Scenario
from barchan.slabs.model import SlabModel

GIVEN = 0.3
"""Share of optional keys that a scenario states."""

CAPS = {
    "max_hops": 500,
    "iterations_per_step": 4,
    "max_bounces": 50,
    "max_grains_per_cell": 3.0,
    "hop_length": 300.0,
    "speed": 90.0,
    "final_speed": 90.0,
    "slabs": 5.0,
    "turns": 40,
    "winds": 16,
    "window": 10,
    "height": 40.0,
    "mean": 60,
    "depth": 60,
    "step_seconds": 1e5,
}
"""Numbers that would only make a run long are drawn up to these."""

COMPILED_APART = (
    *("path_test", "static_repose_angle", "feedback", "sizes", "canopy", "relief_flow", "footprint"),
    *("collapse", "clock"),
)
"""Keys of models whose values decide what is compiled: left to their defaults where ``few`` are asked for."""


def scenario(number: int, narrow: bool = False, few: bool = True) -> dict[str, Any]:
    """The scenario of a number, as plain data; ``narrow`` fields have one to three rows.

    Kernels are compiled for each combination of rules by themselves, which takes longer than all runs; with
    ``few`` there are two for each kind of model: flat ground and winds along the axes, or neither.
    """
    data = _drawn(Random(number), narrow, COMPILED_APART if few else ())
    if few:
        on_axes = number % 2 == 0
        data["wind"] = turned(data["wind"], on_axes)
        if on_axes:
            data["ground"] = {"kind": "flat"}
        elif data["ground"]["kind"] == "flat":
            data["ground"] = {"kind": "cliff"}
    return data


def turned(wind: dict[str, Any], on_axes: bool) -> dict[str, Any]:
    """A wind whose directions all lie along the axes of the lattice, or none."""
    if wind["kind"] in ("record", "storms", "mixed_axes"):
        wind = {"kind": "steady"}
    for part in (wind, *wind.get("regimes", [])):
        quarter = 90.0 * (part.get("direction", 270.0) // 90.0)
        if part is wind and "regimes" in wind:
            continue
        part["direction"] = quarter if on_axes else min(part.get("direction", 270.0) + 0.37, 359.0)
        part.pop("spread", None)
    return wind


def _drawn(rng: Random, narrow: bool, without: tuple[str, ...]) -> dict[str, Any]:
    data = {
        "barchan": 5,
        "lattice": _lattice(rng, narrow),
        "ground": _one_of(rng, "ground"),
        "sand": _one_of(rng, "sand"),
        "wind": _one_of(rng, "wind"),
        "model": _model(rng, rng.choice(list(models())), without),
        "run": _run(rng),
    }
    if models()[data["model"]["name"]].temperature_range is not None:
        directions = {"kind": "steady", "direction": rng.choice([0.0, 33.0, 270.0])}
        data["wind"] = {**directions, "temperature": rng.uniform(-20.0, 0.0), "speed": rng.uniform(0.0, 30.0)}
    if "hex" in models()[data["model"]["name"]].lattices and rng.random() < 0.3:
        data["lattice"] |= {"kind": "hex", "rows": 2 * -(-data["lattice"]["rows"] // 2)}
    if issubclass(models()[data["model"]["name"]], SlabModel):
        _add_clock_and_influx(rng, data)
    return data


def _add_clock_and_influx(rng: Random, data: dict[str, Any]) -> None:
    """Give a scenario of slabs the clock that its wind needs, and influx where an edge is open."""
    if _in_metres(data["wind"]):
        data["clock"] = group(rng, Scenario.model_fields["clock"], ("threshold", "threshold_speed"))
        data["model"]["p_s"] = max(data["model"].get("p_s", 0.6), 0.05)
    if "open" in (data["lattice"]["boundary_x"], data["lattice"]["boundary_y"]) and rng.random() < 0.4:
        data["influx"] = group(rng, Scenario.model_fields["influx"])


def event(rng: Random, data: dict[str, Any], live: list[tuple[str, Any]], few: bool) -> dict[str, Any]:
    """A change during a run, as plain data; ``live`` holds keys and declarations that may change.

    With ``few`` it changes nothing that decides what is compiled.
    """
    size = data["lattice"]["cell_size"]
    place = {
        "x": rng.uniform(-1, 12) * size,
        "y": rng.uniform(-1, 4) * size,
        "radius": rng.uniform(0.1, 5) * size,
    }
    kind = rng.choice(["set", "set", "wind", "stroke", "rock", "plants"])
    on_axes = data["ground"]["kind"] == "flat"
    if few:
        live = [one for one in live if one[0].removeprefix("model.") not in COMPILED_APART]
        kind = "stroke" if kind == "rock" and on_axes else kind
    if kind == "set" and live:
        key, field = rng.choice(live)
        return {"kind": "set", "key": key, "value": value(rng, field.annotation, field.metadata, key)}
    if kind == "wind":
        wind = _one_of(rng, "wind")
        return {"kind": "wind", "wind": turned(wind, on_axes) if few else wind}
    if kind == "plants":
        return {"kind": "plants", "field": "grass", "amount": rng.uniform(-2, 2), **place}
    return {"kind": "rock" if kind == "rock" else "stroke", "amount": rng.choice([-30, -3, 1, 40]), **place}


def live_parameters(name: str) -> list[tuple[str, Any]]:
    """Keys and fields of a model's parameters that may change during a run."""
    fields = models()[name].Parameters.model_fields.items()
    return [
        (f"model.{key}", field)
        for key, field in fields
        if isinstance(field.json_schema_extra, dict) and field.json_schema_extra.get("live")
    ]


def group(rng: Random, chosen: Any, without: tuple[str, ...] = ()) -> dict[str, Any]:
    """Plain data of a group of parameters, or of a field that holds one."""
    kind = chosen if isinstance(chosen, type) else rng.choice(_variants(chosen.annotation))
    data: dict[str, Any] = {}
    for key, field in kind.model_fields.items():
        if key in (NOTE, "path", *without):
            continue
        needed = field.is_required() or key == kind.kind_key
        if needed or rng.random() < GIVEN:
            data[key] = value(rng, field.annotation, field.metadata, key)
    return _consistent(rng, kind, data)


def value(rng: Random, annotation: Any, metadata: Any = (), key: str = "") -> Any:
    """A value of an annotation within its bounds, often at one of them."""
    if hasattr(annotation, "__metadata__"):
        inner = [part for m in annotation.__metadata__ for part in getattr(m, "metadata", [m])]
        return value(rng, annotation.__origin__, [*metadata, *inner], key)
    origin, args = get_origin(annotation), get_args(annotation)
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return group(rng, annotation)
    if origin is Literal:
        return rng.choice(args)
    if origin is list:
        least = max([getattr(m, "min_length", 0) or 0 for m in metadata], default=0)
        return [value(rng, args[0], (), key) for _ in range(max(least, 1) + rng.randrange(2))]
    if args:
        return value(rng, rng.choice(args), metadata, key)
    return _plain(rng, annotation, metadata, key)


def _plain(rng: Random, kind: Any, metadata: Any, key: str) -> Any:
    if kind is bool:
        return rng.random() < 0.5
    if kind not in (int, float):
        return None if kind is type(None) else "text"
    bounds = {
        n: getattr(m, n)
        for m in metadata
        for n in ("ge", "gt", "le", "lt")
        if getattr(m, n, None) is not None
    }
    low, high = bounds.get("ge", bounds.get("gt", -1e3)), bounds.get("le", bounds.get("lt", 1e3))
    high = max(low, min(high, CAPS.get(key.removeprefix("model."), high)))
    if kind is int:
        low, high = math.ceil(low) + ("gt" in bounds), math.floor(high) - ("lt" in bounds)
        return rng.choice([low, high, rng.randint(low, high), rng.randint(low, min(high, low + 10))])
    found = rng.choice([low, high, rng.uniform(low, high), rng.uniform(low, high), _log(rng, low, high)])
    if ("gt" in bounds and found <= low) or ("lt" in bounds and found >= bounds["lt"]):
        return low + (high - low) * rng.uniform(0.01, 0.99)
    return float(found)


def _log(rng: Random, low: float, high: float) -> float:
    if high <= 0:
        return rng.uniform(low, high)
    least = max(low, high * 1e-6)
    return min(max(math.exp(rng.uniform(math.log(least), math.log(high))), low), high)


def _variants(annotation: Any) -> list[type[Parameters]]:
    from barchan.parameters import variants

    return variants(annotation)


def _one_of(rng: Random, part: str) -> dict[str, Any]:
    kinds = [one for one in _variants(Scenario.model_fields[part].annotation) if "File" not in one.__name__]
    return group(rng, rng.choice(kinds))


def _lattice(rng: Random, narrow: bool) -> dict[str, Any]:
    cell = rng.choice([0.002, 0.005, 1.0, 1.0, 25.0])
    return {
        "rows": rng.randint(1, 3) if narrow else rng.randint(1, 12),
        "columns": rng.randint(8, 18),
        "cell_size": cell,
        "slab_height": cell * rng.choice([1e-3, 0.075, 0.1, 1 / 3, 2.0]),
        "boundary_x": rng.choice(["periodic", "open"]),
        "boundary_y": rng.choice(["periodic", "open"]),
    }


def _model(rng: Random, name: str, without: tuple[str, ...]) -> dict[str, Any]:
    data = group(rng, models()[name].Parameters, without)
    data["name"] = name
    if rng.random() < 0.7:  # else most scenarios are refused for one of these
        data.pop("time_step", None)
        for key in ("grain_density", "air_density", "gravity", "drag_coefficient", "viscosity"):
            data.pop(key, None)
    return data


def _run(rng: Random) -> dict[str, Any]:
    until: dict[str, Any] = {}
    if rng.random() < 0.3:
        until["idle_steps"] = rng.randint(1, 4)
    if rng.random() < 0.1:
        until["steady"] = {"window": 10, "tolerance": rng.choice([0.05, 1.0])}
    return {"steps": rng.randint(3, 14), "seed": rng.randrange(2**53), "save_every": 3, "until": until}


def _in_metres(wind: dict[str, Any]) -> bool:
    parts = [wind, *wind.get("regimes", [])]
    return wind.get("kind") in ("record", "storms") or any(
        p.get("unit") == "m/s" or p.get("seconds") for p in parts
    )


def _end_what_begins(data: dict[str, Any]) -> None:
    """Leave out the last value of what has no first one."""
    for name in ("speed", "temperature", "snowfall"):
        data.pop("" if data.get(name) is not None else f"final_{name}", None)


def _consistent(rng: Random, kind: type[Parameters], data: dict[str, Any]) -> dict[str, Any]:
    """Mend what keys of one group ask of one another, so that few scenarios are refused."""
    if issubclass(kind, Area):
        for low, high in (("west", "east"), ("south", "north")):
            edges = sorted((data.get(low, 0.0), data.get(high, 1.0)))
            data |= {low: edges[0], high: edges[1]} if edges[0] < edges[1] else {low: 0.0, high: 1.0}
    if kind.__name__ == "MixedAxes":
        data |= {"first": rng.choice([0, 180]), "second": rng.choice([90, 270])}
    if data.get("static_repose_angle") is not None:
        data["static_repose_angle"] = max(data["static_repose_angle"], data.get("repose_angle", 34.0))
    data.pop("columns", None)
    if "gusts" in data and data.get("unit") != "m/s":
        data.pop("gusts")
    if data.get("unit") == "m/s" and data.get("speed") is None:
        data["speed"] = rng.choice([0.0, 4.0, 12.0, 35.0])
    _end_what_begins(data)
    if "final_speed" in data:
        data.pop("speed_ramp", None)
    if kind.__name__ == "Regime":
        data |= {"steps": rng.randint(1, 4), "seconds": None}
    if kind.__name__ == "Hardening":
        data = {key: value for key, value in data.items() if key in ("increment", "cold_factor")}
    for name in ("lift_speed", "lift_angle"):
        given = [data[key] for key in (f"min_{name}", f"max_{name}") if key in data]
        if given:
            data |= {f"min_{name}": min(given), f"max_{name}": max(given)}
    return data
