"""The brushes that the browser offers for a simulation."""

from typing import Any

import numpy as np

from barchan.simulation import Simulation

MOST = 1000.0
"""Strength of a brush that counts quanta, at most."""

USUAL_SHARE = 0.1
"""Strength of a brush for plants at first, as a share of the field's upper bound."""

USUAL_QUANTA = 5.0
"""Strength of the brush of snowfall at first (quanta)."""

USUAL_ROCK = 2.0
"""Height of rock at first, in cells, and at least."""

ROCK_SHARE = 0.5
"""Height of rock at first among forms that are higher, as a share of the relief."""

USUAL_FRESH = 100.0
"""Density of fresh snow that a brush lays at first (kg/m³)."""

USUAL_ICE = 1.0
"""Height of a lump of ice at first, in cells."""


UNDER_SAND = "Rock rises under the {}, and is seen only where the wind has laid it bare."
"""What is said of the brush of rock."""


def brushes(simulation: Simulation) -> list[dict[str, Any]]:
    """What may be painted: data of a stroke, unit, strengths, a note, and further numbers that it takes."""
    layer = simulation.bed.layers[-1]
    units = {"unit": layer.unit, "least": 1.0, "most": MOST, "whole": True, "usual": 2.0}
    own = [{"title": simulation.model.material, "stroke": {"kind": "stroke"}, **units}]
    if layer.mass is None:
        note = UNDER_SAND.format(simulation.model.material)
        rock = {**units, "usual": _rock(simulation)}
        own.append({"title": "rock", "stroke": {"kind": "rock"}, **rock, "note": note})
    else:
        own += [*_fresh(simulation, units), _ice(simulation)]
    return [{"numbers": [], "note": "", **brush} for brush in (*own, *_plants(simulation))]


def _rock(simulation: Simulation) -> float:
    """Slabs of rock that are seen among the forms that there are."""
    lattice, elevation = simulation.lattice, simulation.elevation
    height = max(USUAL_ROCK * lattice.cell_size, ROCK_SHARE * float(np.ptp(elevation)))
    return min(float(np.ceil(height / lattice.thickness)), MOST)


def _fresh(simulation: Simulation, units: dict[str, Any]) -> list[dict[str, Any]]:
    """Fresh snow at a density that may be chosen, where the model keeps densities."""
    bounds = simulation.model.fresh_densities
    if bounds is None:
        return []
    density = {
        "key": "density",
        "title": "density",
        "unit": "kg/m³",
        "least": bounds[0],
        "most": bounds[1],
        "usual": USUAL_FRESH,
    }
    stroke = {"kind": "snowfall"}
    return [{"title": "snowfall", "stroke": stroke, **units, "usual": USUAL_QUANTA, "numbers": [density]}]


def _ice(simulation: Simulation) -> dict[str, Any]:
    """Ground in metres, where the layers count masses and no height belongs to a unit."""
    return {
        "title": "ice nucleus",
        "stroke": {"kind": "ice"},
        "unit": "m",
        "least": 0.001,
        "most": 10.0,
        "usual": USUAL_ICE * simulation.lattice.cell_size,
        "whole": False,
    }


def _plants(simulation: Simulation) -> list[dict[str, Any]]:
    """The fields that the model lets paint."""
    return [
        {
            "title": field,
            "stroke": {"kind": "plants", "field": field},
            "unit": simulation.bed.declared[field].unit.removeprefix("1"),
            "least": 0.01,
            "most": high,
            "usual": USUAL_SHARE * high,
            "whole": False,
        }
        for field, (_, high) in simulation.model.paintable().items()
    ]
