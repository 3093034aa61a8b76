"""Valid scenarios drawn at random from the declarations themselves, so that new keys are covered."""

from typing import Any, Literal, Union, get_args, get_origin

from hypothesis import strategies as st

from barchan.grains.parameters import GrainFlight
from barchan.ground.area import Area
from barchan.lattice import LARGEST_ASPECT, LEAST_ASPECT, Lattice
from barchan.models import models
from barchan.parameters import NOTE, Parameters
from barchan.plants.species import Species
from barchan.scenario import Scenario
from barchan.slabs.hardening import Hardening
from barchan.slabs.parameters import SlabParameters
from barchan.snow.parameters import SnowParameters
from barchan.wind import MixedAxes, Regime, Steady
from barchan.wind.ramps import Points
from barchan.wind.weather_course import Course

WIDEST = 10**6
"""Numbers without bounds are drawn within this."""

LEAST_REST = 34.0
"""Above the default angle of repose of every model."""

notes = st.none() | st.text(max_size=5) | st.lists(st.text(max_size=5), max_size=2)

paths = st.sampled_from(["/data/dunes.tif", "/data/dunes.png"])
"""A path from the root means the same file from anywhere."""


def scenarios() -> st.SearchStrategy[dict[str, Any]]:
    """Plain data of valid scenarios; every key may be there or be left to its default."""
    return group(Scenario).map(lambda data: {"barchan": 5, **data})


def group(parameters: type[Parameters]) -> st.SearchStrategy[dict[str, Any]]:
    """Plain data of one group."""
    given = {
        name: values(field.annotation, field.metadata) if name != "path" else paths
        for name, field in parameters.model_fields.items()
        if name != NOTE
    }
    needed = {n: s for n, s in given.items() if n == parameters.kind_key}
    needed |= {n: s for n, s in given.items() if parameters.model_fields[n].is_required()}
    optional = {n: s for n, s in given.items() if n not in needed} | {NOTE: notes}
    drawn = st.fixed_dictionaries(needed, optional=optional)
    if issubclass(parameters, Area):
        return drawn.map(_with_area)
    if parameters is Scenario:
        return drawn.map(_timeless)
    if issubclass(parameters, Course):
        return drawn.map(_lasts_where_it_changes)
    if parameters is Hardening:
        return drawn.map(_packs)
    if parameters in (Regime, Steady):
        return drawn.map(_starts_somewhere)
    if parameters is MixedAxes:
        return drawn.map(_crosses)
    if parameters is Points:
        return drawn.map(_goes_on)
    if issubclass(parameters, Species):
        return drawn.map(_is_a_function)
    if issubclass(parameters, GrainFlight):
        return drawn.map(_flies)
    if issubclass(parameters, SnowParameters):
        return drawn.map(_drifts)
    if issubclass(parameters, SlabParameters):
        return drawn.map(_lets_go_above_rest)
    return drawn.map(_one_height) if parameters is Lattice else drawn


def values(annotation: Any, metadata: Any = ()) -> st.SearchStrategy[Any]:
    """Values of an annotation within the bounds of its metadata."""
    origin, args = get_origin(annotation), get_args(annotation)
    if hasattr(annotation, "__metadata__"):
        inner = [part for m in annotation.__metadata__ for part in getattr(m, "metadata", [m])]
        return values(args[0], inner)
    if isinstance(annotation, type) and issubclass(annotation, Parameters):
        return group(annotation)
    if origin is Literal:
        return st.sampled_from(args)
    if origin in (list, tuple):
        least = max([getattr(m, "min_length", 0) for m in metadata], default=0)
        return st.lists(values(args[0]), min_size=least, max_size=least + 3)
    if origin is Union or args:
        return st.one_of([values(arg, metadata) for arg in args])
    return _plain(annotation, metadata)


def _plain(kind: type, metadata: Any) -> st.SearchStrategy[Any]:
    bounds = {
        name: getattr(m, name) for m in metadata for name in ("ge", "gt", "le", "lt") if hasattr(m, name)
    }
    low, high = bounds.get("ge", bounds.get("gt", -WIDEST)), bounds.get("le", bounds.get("lt", WIDEST))
    if kind is bool:
        return st.booleans()
    if kind is int:
        return st.integers(low + ("gt" in bounds), high - ("lt" in bounds))
    if kind is float:
        return st.floats(low, high, exclude_min="gt" in bounds, exclude_max="lt" in bounds)
    return st.none() if kind is type(None) else st.text(max_size=10)


def _with_area(area: dict[str, Any]) -> dict[str, Any]:
    for low, high in (("west", "east"), ("south", "north")):
        edges = sorted((area.get(low, 0.0), area.get(high, 1.0)))
        area |= {low: edges[0], high: edges[1]} if edges[0] < edges[1] else {low: 0.0, high: 1.0}
    return {**area, "mean": round(area["mean"])} if "mean" in area else area


def _one_height(lattice: dict[str, Any]) -> dict[str, Any]:
    height = lattice.pop("slab_height", None)
    if height is not None and lattice.get("slab_aspect") is None:
        cell = lattice.get("cell_size", 1.0)
        lattice["slab_height"] = min(max(height, 2 * LEAST_ASPECT * cell), LARGEST_ASPECT / 2 * cell)
    if lattice.get("kind") == "hex":
        lattice["rows"] = 2 * (lattice.get("rows", 256) // 2 or 1)
    return lattice


def _lets_go_above_rest(data: dict[str, Any]) -> dict[str, Any]:
    rest = data.get("repose_angle", LEAST_REST)
    if (data.get("static_repose_angle") or rest) < rest:
        return {**data, "static_repose_angle": rest}
    return data


def _flies(data: dict[str, Any]) -> dict[str, Any]:
    """Grains heavier than air, ranges in order, sizes that make up all sand or a spread, bonds by time."""
    sizes = data.get("sizes", {})
    if sizes.get("classes"):
        share = 1.0 / len(sizes["classes"])
        sizes["classes"] = [
            {**one, "diameter": (at + 1) * 1e-3, "share": share} for at, one in enumerate(sizes["classes"])
        ]
        sizes.pop("spread", None)
    if sizes.get("spread"):
        data |= {"grain_diameter": 0.5e-3}
    lifted = data.get("entrainment", {})
    for name in ("lift_speed", "lift_angle"):
        given = [lifted[key] for key in (f"min_{name}", f"max_{name}") if key in lifted]
        if given:
            lifted |= {f"min_{name}": min(given), f"max_{name}": max(given)}
    idle = ("air_density", "grain_density", *(("clock",) if data["name"] == "snow_grains" else ()))
    return {name: value for name, value in data.items() if name not in idle}


def _is_a_function(data: dict[str, Any]) -> dict[str, Any]:
    """A species with balances that increase, and both bounds in order or none."""
    if "curve" in data:
        data["curve"] = [{**vertex, "balance": float(at)} for at, vertex in enumerate(data["curve"])]
    bounds = sorted(data.pop(name) for name in ("lowest", "highest") if name in data)
    return {**data, "lowest": bounds[0], "highest": bounds[1]} if len(bounds) == 2 else data


def _starts_somewhere(data: dict[str, Any]) -> dict[str, Any]:
    """A wind that says where its speed begins if it says where it ends, and how long it blows but once."""
    data = {**data, "unit": "cells", "gusts": None}
    if "kind" in data:
        return data
    data |= {"steps": data.get("steps") or 7, "seconds": None}
    unknown = [name for name in ("speed", "temperature", "snowfall") if data.get(name) is None]
    return {**data, **{f"final_{name}": None for name in unknown}}


def _lasts_where_it_changes(data: dict[str, Any]) -> dict[str, Any]:
    """A quantity that changes over a number of steps, or not at all."""
    steps = None if data.get("last") is None else data.get("steps") or 7
    return {**data, "steps": steps, "seconds": None}


def _packs(data: dict[str, Any]) -> dict[str, Any]:
    """Snow with curves that go on, and that get denser until it is immobile."""
    for curve, key in (("fresh_snow", "temperature"), ("packed_snow", "day")):
        if curve in data:
            data[curve] = [{**point, key: 10.0 * at} for at, point in enumerate(data[curve])]
    if "packed_snow" in data:
        points = [{**point, "density": 50.0 + 10 * at} for at, point in enumerate(data["packed_snow"])]
        data |= {"packed_snow": points, "locks_after": 9}
    return {**data, "locks_after": min(data.get("locks_after", 98), 98)}


def _timeless(data: dict[str, Any]) -> dict[str, Any]:
    """A scenario without clock and influx, which would ask more of its parts than can be drawn one by one."""
    wind = data.get("wind")
    if wind is not None and wind.get("kind") in {"record", "storms"}:
        data = {**data, "wind": {"kind": "steady"}}
    model = models()[data.get("model", {}).get("name", "werner")]
    if "wind" in data and not model.takes_hops:
        data = {**data, "wind": {"kind": "steady"}}
    data = {**data, "clock": None, "influx": None}
    parts = (data.get("ground"), data.get("sand"), data.get("model", {}).get("vegetation"))
    if "hex" not in model.lattices or any((part or {}).get("kind") == "file" for part in parts):
        data["lattice"] = {key: value for key, value in data.get("lattice", {}).items() if key != "kind"}
    return data if model.temperature_range is None else _cold(data)


def _cold(data: dict[str, Any]) -> dict[str, Any]:
    """A scenario whose weather the model takes: none is stated."""
    return {**data, "wind": {"kind": "steady"}, "weather": None}


def _crosses(data: dict[str, Any]) -> dict[str, Any]:
    return {**data, "first": 90, "second": 180}


def _goes_on(data: dict[str, Any]) -> dict[str, Any]:
    """Points whose times increase."""
    points = [{**point, "time": (at + 1) / 10} for at, point in enumerate(data["points"])]
    return {**data, "points": points}


def _drifts(data: dict[str, Any]) -> dict[str, Any]:
    """The reference wind moves snow, densities of drift are in order, and a cell keeps all older layers."""
    drift = {k: v for k, v in (data.get("drift") or {}).items() if "_density" not in k}
    beneath = (data.get("beneath") or [])[: data.get("layers", 2)]
    return {**data, "reference_wind": 100.0, "drift": drift, "beneath": beneath}
