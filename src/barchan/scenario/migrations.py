"""Configuration files of earlier formats, brought up to date on reading."""

import re
from collections.abc import Callable, Iterator
from copy import deepcopy
from itertools import takewhile
from typing import Any

from barchan.models import models
from barchan.scenario.definition import DEFAULT_MODEL, FORMAT

Data = dict[str, Any]

RENAMED_SINCE_1: dict[str, str] = {
    "run.until.still": "run.until.idle_steps",
    "model.load": "model.max_grains_per_cell",
    "model.entrainment": "model.entrainment.probability",
    "model.lift_least": "model.entrainment.min_lift_speed",
    "model.lift_most": "model.entrainment.max_lift_speed",
    "model.flattest": "model.entrainment.min_lift_angle",
    "model.steepest": "model.entrainment.max_lift_angle",
    "model.lift_from_lee": "model.entrainment.from_lee",
    "model.normal_damping": "model.bounce.normal_damping",
    "model.tangential_damping": "model.bounce.tangential_damping",
    "model.stop_speed": "model.bounce.stop_speed",
    "model.rebound_most": "model.splash.rebound_probability",
    "model.rebound_rate": "model.splash.rebound_speed_scale",
    "model.restitution": "model.splash.restitution",
    "model.rebound_angle": "model.splash.rebound_angle",
    "model.ejecta": "model.splash.ejecta_per_speed",
    "model.ejecta_momentum": "model.splash.ejecta_momentum",
    "model.ejecta_scale": "model.splash.ejecta_speed_scale",
    "model.ejecta_angle": "model.splash.ejecta_angle",
    "model.azimuth_spread": "model.splash.azimuth_spread",
    "model.creep_momentum": "model.creep.momentum",
    "model.creep_speed": "model.creep.speed",
    "model.near_bed": "model.feedback.near_bed",
    "model.focus_height": "model.feedback.focus_height",
    "model.sharing_width": "model.feedback.length",
    "model.sharing_across": "model.feedback.width",
    "model.weight": "model.feedback.momentum_weight",
    "model.wind_every": "model.feedback.update_every",
    "model.streamline_height": "model.relief_flow.streamline_height",
    "model.wave_speedup": "model.relief_flow.speedup",
    "model.crest_stress": "model.relief_flow.stress_in_phase",
    "model.stoss_stress": "model.relief_flow.stress_in_quadrature",
    "model.shelter_angle": "model.shelter.angle",
    "model.shelter_every": "model.shelter.update_every",
    "model.sizes": "model.sizes.classes",
    "model.size_spread": "model.sizes.spread",
    "model.size_classes": "model.sizes.spread_classes",
    "model.active_layer": "model.sizes.active_layer",
    "model.plants": "model.canopy.stands",
    "model.plant_roughness": "model.canopy.roughness",
    "model.plant_displacement": "model.canopy.displacement",
    "model.release_angle": "model.static_repose_angle",
    "model.firm_repose_angle": "model.stabilised_repose_angle",
    "model.firm_cover": "model.stabilised_cover",
    "wind.regimes[].course": "wind.regimes[].speed_ramp",
    "wind.turns": "wind.alternations",
}
"""Keys of format 1 and what they are called now; ``[]`` stands for each member of a list."""

RENAMED_VALUES_SINCE_1: dict[str, dict[str, str]] = {}
"""By keys as they are called now: words of format 1 that a parameter took, and what they are called now."""


CONVERTED_SINCE_1: dict[str, Callable[[Any], Any]] = {
    "model.splash.rebound_speed_scale": lambda rate: 1.0 / rate if isinstance(rate, int | float) else rate,
}
"""By keys as they are called now: values of format 1 in another unit, converted."""


FIELDS_SINCE_1 = (
    (re.compile(r"^layer_(\d+)$"), r"surface_\1"),
    (re.compile(r"^below_(\d+)$"), r"substrate_\1"),
)
"""Names of fields of format 1, and what they are called now."""


def current_field(name: str) -> str:
    """The name now of a field of any earlier format."""
    for old, new in FIELDS_SINCE_1:
        name = old.sub(new, name)
    return name


def current_value(key: str, value: Any) -> Any:
    """The value now of a key of format 1, whose name is the one of today."""
    value = RENAMED_VALUES_SINCE_1.get(key, {}).get(value, value) if isinstance(value, str) else value
    return CONVERTED_SINCE_1[key](value) if key in CONVERTED_SINCE_1 and value else value


def current_key(key: str) -> str:
    """The key that a key of any earlier format stands for now."""
    return RENAMED_SINCE_1.get(key, key)


def current_wind(wind: Data) -> Data:
    """A wind of any earlier format with the keys of today."""
    data = {"wind": deepcopy(wind)}
    for old, new in RENAMED_SINCE_1.items():
        _move(data, old.split("."), new.split("."))
    return data["wind"]


def _to_2(data: Data) -> Data:
    """Standard words for keys, and one group of keys for each closure of a grain model."""
    for old, new in RENAMED_SINCE_1.items():
        _move(data, old.split("."), new.split("."))
    for key in (*RENAMED_VALUES_SINCE_1, *CONVERTED_SINCE_1):
        *path, last = key.split(".")
        for group in _groups(data, path):
            if last in group:
                group[last] = current_value(key, group[last])
    return data


def _to_3(data: Data) -> Data:
    """Shadow lines started at the centre unless a file said otherwise; now that depends on the winds."""
    model = data.setdefault("model", {})
    if not isinstance(model, dict):
        return data
    if _has_shadow_lines(model):
        model.setdefault("shadow_from", "centre")
    return data


def _to_4(data: Data) -> Data:
    """On hexagons shadow lines started at the centre unless a file said otherwise, whatever the winds."""
    lattice = data.get("lattice")
    if not isinstance(lattice, dict) or lattice.get("kind") != "hex":
        return data
    model = data.setdefault("model", {})
    if isinstance(model, dict) and _has_shadow_lines(model) and model.get("shadow_from", "auto") == "auto":
        model["shadow_from"] = "centre"
    return data


def _to_5(data: Data) -> Data:
    """Tops of stacks were level, and slabs slid to the steepest neighbour, the first by the wind."""
    model = data.setdefault("model", {})
    if not isinstance(model, dict) or not _has_shadow_lines(model):
        return data
    if model.get("shadow_from", "auto") in ("auto", "place"):
        model.setdefault("stack_tops", "level")
    model.setdefault("neighbour_order", "wind")
    return data


def _has_shadow_lines(model: Data) -> bool:
    """Whether the model's parameters say where shadow lines start; a model without a name is the default."""
    name = model.setdefault("name", DEFAULT_MODEL)
    kind = models().get(name) if isinstance(name, str) else None
    return kind is not None and "shadow_from" in kind.Parameters.model_fields


STEPS: dict[int, Callable[[Data], Data]] = {1: _to_2, 2: _to_3, 3: _to_4, 4: _to_5}
"""For each earlier format, what turns its data into the next one's."""


def migrate(data: Data) -> tuple[Data, str]:
    """The data in today's format, and what is wrong with its version, if anything."""
    if "barchan" not in data:
        return data, f'is missing: the format\'s version, "barchan": {FORMAT}'
    version = data["barchan"]
    if not isinstance(version, int) or isinstance(version, bool) or version < 1:
        return {**data, "barchan": FORMAT}, f"is {version!r}; allowed: a format version from 1 to {FORMAT}"
    if version > FORMAT:
        text = f"is {version}, written by a newer Barchan; this one reads formats up to {FORMAT}"
        return {**data, "barchan": FORMAT}, text
    while version < FORMAT:
        data = {**STEPS[version](data), "barchan": version + 1}
        version += 1
    return data, ""


def _groups(data: Any, path: list[str]) -> Iterator[Data]:
    """The groups of keys at a path; ``name[]`` stands for the members of a list."""
    if path and isinstance(data, dict):
        name = path[0].removesuffix("[]")
        found = data.get(name)
        several = found if name != path[0] and isinstance(found, list) else [found]
        for one in several:
            yield from _groups(one, path[1:])
    elif isinstance(data, dict):
        yield data


def _move(data: Data, old: list[str], new: list[str]) -> None:
    """Move the value of one key to another, whose groups are made as needed."""
    same = len([*takewhile(lambda names: names[0] == names[1], zip(old[:-1], new[:-1], strict=False))])
    for group in _groups(data, old[:same]):
        for holder in _groups(group, old[same:-1]):
            if old[-1] in holder:
                _put(group, new[same:], holder.pop(old[-1]))


def _put(data: Data, path: list[str], value: Any) -> None:
    for name in path[:-1]:
        data = data.setdefault(name, {})
    data[path[-1]] = value
