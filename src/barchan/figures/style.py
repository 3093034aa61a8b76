"""Style of all pictures: colours, the wind's arrow, axes in metres."""

import textwrap
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray

from barchan.directions import downwind
from barchan.measures.filters import smoothed
from barchan.scenario import Scenario
from barchan.wind.clock import spoken

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.colors import Colormap
    from matplotlib.figure import Figure

Colours = Literal["perceptual", "grey", "red-green"]

SAND = "#d9a441"
GROUND = "#8c8278"
SHADOW = "#35507a"
CURVE = "#b3402a"
PALE = "#f2ead8"
BARE = (0.80, 0.79, 0.77)


def colour_map(colours: Colours) -> "Colormap":
    """A colour map by its purpose; red-green has red the highest, as in the Prague thesis."""
    import matplotlib as mpl
    from cmcrameri import cm
    from matplotlib.colors import LinearSegmentedColormap

    if colours == "perceptual":
        return LinearSegmentedColormap.from_list("sand", cm.lajolla_r(np.linspace(0.02, 0.8, 256)))
    return mpl.colormaps["gray" if colours == "grey" else "RdYlGn_r"]


def new_figure(width: float, height: float) -> "Figure":
    """An empty figure, sizes in inches."""
    from matplotlib.figure import Figure

    return Figure(figsize=(width, height), dpi=150, layout="constrained")


def smooth(field: NDArray, width: float, scenario: Scenario) -> NDArray[np.float64]:
    """A field smoothed over ``width`` cells for display; 0 leaves it as it is."""
    return smoothed(field, width, scenario.lattice.periodic) if width > 0 else np.asarray(field, float)


def extent(scenario: Scenario) -> tuple[float, float, float, float]:
    """West, east, south and north edge (m)."""
    lattice = scenario.lattice
    return 0.0, lattice.columns * lattice.cell_size, 0.0, lattice.rows * lattice.cell_size


def label_of(field: "xr.DataArray") -> str:
    """A field's meaning and unit, in lines that fit beside a low picture."""
    unit = field.attrs["unit"]
    text = str(field.attrs["long_name"]) + ("" if unit in ("1", "-") else f" ({unit})")
    return textwrap.fill(text, MOST_LABEL)


def map_axes(axes: "Axes", scenario: Scenario, frame: "xr.Dataset") -> None:
    """Label a map's axes, name it, and draw the wind."""
    axes.set_xlabel("x (m)")
    axes.set_ylabel("y (m)")
    axes.set_aspect("equal")
    text = title(scenario, int(frame["step"]))
    axes.set_title(text, loc="left", fontsize=min(10.0, MOST_TITLE / len(text)))
    wind_arrow(axes, float(frame["wind_direction"]))


MOST_LABEL = 24
"""Letters in a line of a label."""

MOST_TITLE = 550.0
"""Letters of a title times their size (points) that leave room for the wind's arrow."""


def title(scenario: Scenario, step: int) -> str:
    """Title of a picture."""
    name = scenario.title or "Run"
    seconds = scenario.step_seconds
    time = "" if seconds is None or step == 0 else f" ({spoken(seconds * step)})"
    return f"{name}, step {step}{time}, seed {scenario.run.seed}"


def wind_arrow(axes: "Axes", direction: float) -> None:
    """An arrow that points where the wind blows, above the upper right corner."""
    from matplotlib.transforms import ScaledTranslation, Transform

    def from_corner(right: float, up: float) -> Transform:
        """So many points (1/72 inch) from the map's upper right corner."""
        return axes.transAxes + ScaledTranslation(right / 72, up / 72, axes.figure.dpi_scale_trans)

    x, y = downwind(direction)
    style: dict[str, Any] = {
        "arrowstyle": "-|>",
        "color": "black",
        "linewidth": 1.4,
        "shrinkA": 0,
        "shrinkB": 0,
    }
    axes.annotate(
        "",
        xy=(1, 1),
        xycoords=from_corner(9 * x - 12, 9 * y + 12),
        xytext=(1, 1),
        textcoords=from_corner(-9 * x - 12, -9 * y + 12),
        arrowprops=style,
        annotation_clip=False,
    )
    axes.text(1, 1, "wind", transform=from_corner(-26, 12), ha="right", va="center", fontsize=9)
