"""A scenario in few words, with units, for people who look at it in a console or a notebook."""

from html import escape
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from barchan.scenario.definition import Scenario


def in_a_line(scenario: "Scenario") -> str:
    """Title, model, lattice, length and seed in one line."""
    rows = summary(scenario)
    title = f"'{scenario.title}': " if scenario.title else ""
    return f"{title}{rows['model']}, {rows['lattice']}, {rows['run']}"


def field_size(scenario: "Scenario") -> str:
    """Columns and rows of the field, cell size, and the height of a slab or the mass of a quantum."""
    lattice = scenario.lattice
    cells = f"{lattice.columns} × {lattice.rows} cells of {lattice.cell_size:g} m"
    return f"{cells}, {unit_of(scenario)}"


def unit_of(scenario: "Scenario") -> str:
    """What a unit of the uppermost layer is: slabs of a height, or quanta of a mass."""
    layer = scenario.layers[-1]
    if layer.mass is not None:
        return f"{layer.unit} of {layer.mass:g} kg/m²"
    return f"slabs of {scenario.lattice.thickness:.3g} m"


def summary(scenario: "Scenario") -> dict[str, str]:
    """The parts of a scenario, a few words each."""
    wind, seed = scenario.wind, scenario.run.seed
    direction = getattr(wind, "direction", None)
    seconds = scenario.step_seconds
    length = f"{scenario.run.steps} steps" + (f" of {seconds:.3g} s" if seconds is not None else "")
    return {
        "model": scenario.model.name,
        "lattice": field_size(scenario),
        "ground": scenario.ground.kind,
        "sand": scenario.sand.kind,
        "wind": f"{wind.kind} from {direction:g}°" if isinstance(direction, float) else wind.kind,
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
