"""Lines through the field along the wind: where they lie, and the shadow line over them."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.directions import downwind
from barchan.fields import depth_of
from barchan.scenario import Scenario

if TYPE_CHECKING:
    import xarray as xr


@dataclass(frozen=True)
class Section:
    """A line through the field along the wind, from its upwind to its downwind end."""

    rows: NDArray[np.int64]
    cols: NDArray[np.int64]
    distance: NDArray[np.float64]
    """Distance (m) along the wind from the line's upwind end."""
    joined: bool
    """Whether the line closes on itself across a periodic edge."""
    place: str
    """Where the line lies, in words."""

    def edges(self, cell_size: float) -> NDArray[np.float64]:
        """Distances (m) along the wind at which cells meet, from before the first to after the last one."""
        between = (self.distance[1:] + self.distance[:-1]) / 2
        first, last = self.distance[[0, -1]]
        return np.concatenate([[first - cell_size / 2], between, [last + cell_size / 2]])


def section_along_wind(scenario: Scenario, direction: float, at: float) -> Section:
    """The section that crosses the field's middle line at ``at`` (0 to 1, to the wind's left growing).

    Along a lattice axis it is a whole row or column; for an oblique wind it is the cells nearest to a
    line from edge to edge.
    """
    if not 0 <= at <= 1:
        raise ValueError(f"a section lies at {at:g}; allowed: 0 to 1")
    lattice = scenario.lattice
    x, y = downwind(direction)
    rows, cols = lattice.shape
    width, depth = cols - 1, rows - 1
    across = (at - 0.5) * (abs(x) * depth + abs(y) * width)
    middle = np.array([depth / 2 + x * across, width / 2 - y * across])
    reach = float(np.hypot(rows, cols))
    line = np.arange(-reach, reach + 0.5, 0.5 if min(abs(x), abs(y)) > 1e-9 else 1.0)
    start = middle + np.outer(line, (y, x))
    if abs(x) > 1 - 1e-9 or abs(y) > 1 - 1e-9:
        start = np.round(start - middle + np.round(middle))
    cells = np.rint(start).astype(np.int64)
    inside = ((cells >= 0) & (cells < (rows, cols))).all(axis=1)
    cells = cells[inside]
    fresh = np.ones(len(cells), bool)
    fresh[1:] = (np.diff(cells, axis=0) != 0).any(axis=1)
    cells = cells[fresh]
    along = (cells - cells[0]) @ (y, x) * lattice.cell_size
    straight = min(abs(x), abs(y)) < 1e-9
    boundary = lattice.boundary_x if abs(x) > abs(y) else lattice.boundary_y
    place = _place(scenario, cells[len(cells) // 2], x, y, straight)
    return Section(cells[:, 0], cells[:, 1], along, straight and boundary == "periodic", place)


def _place(scenario: Scenario, cell: NDArray[np.int64], x: float, y: float, straight: bool) -> str:
    """Where the line through a cell along the wind (x, y) lies: its row, its column, or the cell itself."""
    north, east = (f"{value:.4g} m" for value in (cell + 0.5) * scenario.lattice.cell_size)
    if not straight:
        return f"along the wind through x = {east}, y = {north}"
    return f"along y = {north}" if abs(x) > abs(y) else f"along x = {east}"


def shadow_line(
    section: Section, surface: NDArray, angle: float, cell_size: float, start: float = 0.0
) -> NDArray[np.float64]:
    """Height (m) of the shadow line over each point of a section; below the surface where it is lit.

    Lines fall at ``angle`` (degrees) from ``start`` cells downwind of each cell's centre.
    """
    distance = section.distance
    slope = np.tan(np.radians(angle))
    if section.joined:
        length = distance[-1] + cell_size
        distance = np.concatenate([distance - length, distance])
        surface = np.concatenate([surface, surface])
    tilted = np.maximum.accumulate(surface + slope * distance)
    line = np.empty_like(tilted)
    line[0] = -np.inf
    line[1:] = tilted[:-1]
    line += slope * (start * cell_size - distance)
    return line[-len(section.distance) :]


def model_shadow(section: Section, surface: NDArray, scenario: Scenario) -> NDArray[np.float64]:
    """The shadow line of a scenario's model; a model without shadows has none."""
    angle = getattr(scenario.model, "shadow_angle", None)
    if angle is None:
        return np.full(len(surface), -np.inf)
    start = 0.0 if getattr(scenario.new_model(), "shadow_rule", "centre") == "centre" else 0.5
    return shadow_line(section, surface, angle, scenario.lattice.cell_size, start)


def through_highest(frame: "xr.Dataset", scenario: Scenario) -> float:
    """Where the section lies that crosses the highest stack."""
    depth = depth_of(scenario.layers, frame, scenario.lattice.thickness).values
    row, col = np.unravel_index(int(np.argmax(depth)), depth.shape)
    rows, cols = scenario.lattice.shape
    x, y = downwind(float(frame["wind_direction"]))
    across = x * (row - (rows - 1) / 2) - y * (col - (cols - 1) / 2)
    width = abs(x) * (rows - 1) + abs(y) * (cols - 1)
    return float(np.clip(0.5 + across / width, 0.0, 1.0)) if width else 0.5
