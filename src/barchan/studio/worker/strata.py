"""The layers of a bed along a section, for a model that keeps any."""

from typing import Any

import numpy as np

from barchan.errors import BarchanError
from barchan.models import Strata
from barchan.simulation import Simulation

MOST_PLACES = 2048
"""Places along a section at which layers are read."""


def layers_along(simulation: Simulation, line: list[float], name: str) -> dict[str, Any]:
    """The layers of the cells under a line from x, y to x, y (m): thickness (m) and value, the lowest first.

    A row for each layer, a number for each cell; ``place`` is where cells begin and end along the line (m).
    Raises BarchanError where that is no line, or the model keeps no layers of that name.
    """
    if len(line) != 4 or not np.isfinite(line).all():
        raise BarchanError("a section needs two places: x, y, x, y in metres")
    chosen = _chosen(simulation, name)
    rows, columns, edges = _cells(simulation, line)
    found = [
        (thickness[rows, columns], np.where(thickness[rows, columns] > 0.0, values[rows, columns], 0.0))
        for thickness, values in chosen.compute(simulation.model, simulation.bed)
    ]
    kept = [(thickness, values) for thickness, values in found if thickness.any()]
    return {
        "step": simulation.steps_done,
        "place": edges.tolist(),
        "ground": simulation.bed.ground[rows, columns].tolist(),
        "thickness": [np.round(thickness, 6).tolist() for thickness, _ in kept],
        "values": [np.round(values, 4).tolist() for _, values in kept],
    }


def declared_strata(simulation: Simulation) -> list[dict[str, Any]]:
    """Name, title, unit and words of everything that sections can show of the layers."""
    return [
        {"name": one.name, "title": one.title, "unit": one.unit, "states": list(one.states)}
        for one in simulation.model.strata
        if one.drawn
    ]


def _chosen(simulation: Simulation, name: str) -> Strata:
    known = {one.name: one for one in simulation.model.strata if one.drawn}
    if name not in known:
        allowed = ", ".join(known) or f"none with {simulation.model.name}"
        raise BarchanError(f"no layers by '{name}'; allowed: {allowed}")
    return known[name]


def _cells(simulation: Simulation, line: list[float]) -> tuple[Any, Any, Any]:
    """Rows and columns of the cells under a line, and the distances (m) at which each begins and ends."""
    lattice = simulation.lattice
    x0, y0, x1, y1 = line
    length = float(np.hypot(x1 - x0, y1 - y0))
    count = int(np.clip(round(4 * length / lattice.cell_size), 2, 4 * MOST_PLACES))
    share = (np.arange(count) + 0.5) / count
    rows = ((y0 + share * (y1 - y0)) // lattice.cell_size).astype(np.intp).clip(0, lattice.rows - 1)
    columns = ((x0 + share * (x1 - x0)) // lattice.cell_size).astype(np.intp).clip(0, lattice.columns - 1)
    begins = np.flatnonzero(np.append(True, (np.diff(rows) != 0) | (np.diff(columns) != 0)))
    edges = np.append(begins, count) / count * length
    return rows[begins], columns[begins], edges
