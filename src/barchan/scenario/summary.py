"""A scenario in few words, with units, for people who look at it in a console or a notebook."""

from html import escape
from typing import TYPE_CHECKING

from barchan.wind.blowing import speed_in_words
from barchan.words import counted

if TYPE_CHECKING:
    from barchan.scenario.definition import Scenario


def in_a_line(scenario: "Scenario") -> str:
    """Title, model, lattice, length and seed in one line."""
    rows = summary(scenario)
    title = f"'{scenario.title}': " if scenario.title else ""
    return f"{title}{rows['model']}, {rows['lattice']}, {rows['run']}"


def field_size(scenario: "Scenario") -> str:
    """Columns and rows of the field, cell size, and the height of a slab or the mass of a quantum."""
    return f"{scenario.lattice.size_in_words}, {unit_of(scenario)}"


def unit_of(scenario: "Scenario") -> str:
    """What a unit of the uppermost layer is: slabs of a height, or quanta of a mass."""
    layer = scenario.layers[-1]
    if layer.mass is not None:
        return f"{layer.unit} of {layer.mass:g} kg/m²"
    return f"slabs of {scenario.lattice.thickness:.3g} m"


def wind_in_words(scenario: "Scenario") -> str:
    """The wind, with the model's own speed or hop length wherever that is in force."""
    parts = [part for _, part in scenario.wind.placed_parts()]
    own = [
        f"{text} (model.{key})"
        for key, unit in (("wind_speed", "m/s"), ("hop_length", "cells"))
        if isinstance(value := getattr(scenario.model, key, None), float)
        for text in [speed_in_words(unit, value)]
        if not parts or any(part.speed is None or part.unit != unit for part in parts)
    ]
    return " ".join([scenario.wind.summary(), *own])


def summary(scenario: "Scenario") -> dict[str, str]:
    """The parts of a scenario, a few words each."""
    seed = scenario.run.seed
    seconds = scenario.step_seconds
    length = counted(scenario.run.steps, "step") + (f" of {seconds:.3g} s" if seconds is not None else "")
    return {
        "model": scenario.model.name,
        "lattice": field_size(scenario),
        "ground": scenario.ground.kind,
        "sand": scenario.sand.kind,
        "wind": wind_in_words(scenario),
        "run": f"{length}, {'no seed yet' if seed is None else f'seed {seed}'}",
    }


def html_table(title: str, rows: dict[str, str]) -> str:
    """A small table with a title, for notebooks."""
    left = "style='text-align:left'"
    cells = "".join(
        f"<tr><th {left}>{escape(name)}</th><td {left}>{escape(text)}</td></tr>"
        for name, text in rows.items()
    )
    return f"<table><caption><b>{escape(title)}</b></caption>{cells}</table>"
