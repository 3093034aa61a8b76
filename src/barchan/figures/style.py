"""Style of all pictures: colours, sizes, titles and labels."""

import textwrap
from collections.abc import Sequence
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from barchan.measures.filters import smoothed
from barchan.scenario import Scenario
from barchan.wind.clock import spoken

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.artist import Artist
    from matplotlib.colors import Colormap
    from matplotlib.figure import Figure

Colours = Literal["natural", "perceptual", "grey", "red-green"]

SAND = "#d9a441"
GROUND = "#8c8278"
SHADOW = "#35507a"
CURVE = "#b3402a"
PALE = "#f2ead8"

SANDS = ("#b58a50", "#dab678", "#f9e7b9")
"""Sand from the lowest to the highest: lighter upwards, so that shade alone darkens a crest's lee."""

SNOWS = ("#7f9dbd", "#bcd0e4", "#fbfdff")
"""Snow from the lowest to the highest."""

DPI = 150
"""Dots per inch of pictures."""

SMOOTHING = 0.8
"""Cells over which surfaces are smoothed for display: single slabs then do not show as pits and steps."""


def colour_map(colours: Colours, material: str = "sand") -> "Colormap":
    """A colour map by its purpose, of a material; red-green has red the highest, as in the Prague thesis."""
    import matplotlib as mpl
    from matplotlib.colors import LinearSegmentedColormap

    if colours == "natural":
        return LinearSegmentedColormap.from_list("natural", SNOWS if material == "snow" else SANDS)
    if colours == "perceptual":
        from cmcrameri import cm  # takes the whole of pyplot, which maps in natural colours do without

        return LinearSegmentedColormap.from_list("perceptual", cm.lajolla_r(np.linspace(0.02, 0.8, 256)))
    return mpl.colormaps["gray" if colours == "grey" else "RdYlGn_r"]


def material_of(scenario: Scenario) -> str:
    """The material of the surface, in one word."""
    return scenario.new_model().material


def new_figure(width: float, height: float, *, of_map: bool = False) -> "Figure":
    """An empty figure, sizes in inches; ``of_map`` keeps colour bars beside panels of a fixed shape."""
    from matplotlib.figure import Figure

    layout: Literal["compressed", "constrained"] = "compressed" if of_map else "constrained"
    return Figure(figsize=(width, height), dpi=DPI, layout=layout)


def smooth(field: NDArray, width: float, scenario: Scenario) -> NDArray[np.float64]:
    """A field smoothed over ``width`` cells for display; 0 leaves it as it is."""
    return smoothed(field, width, scenario.lattice.periodic) if width > 0 else np.asarray(field, float)


def extent(scenario: Scenario) -> tuple[float, float, float, float]:
    """West, east, south and north edge (m)."""
    lattice = scenario.lattice
    return 0.0, lattice.width, 0.0, lattice.height


def label_of(field: "xr.DataArray") -> str:
    """A field's meaning and unit, in lines that fit beside a low picture."""
    unit = field.attrs["unit"]
    text = str(field.attrs["long_name"]) + ("" if unit in ("1", "-") else f" ({unit})")
    return textwrap.fill(text, MOST_LABEL)


MOST_LABEL = 24
"""Letters in a line of a label."""


def title(scenario: Scenario, step: int) -> str:
    """Title of a picture."""
    name = scenario.title or "Run"
    seconds = scenario.step_seconds
    time = "" if seconds is None or step == 0 else f" ({spoken(seconds * step)})"
    return f"{name}, step {step}{time}, seed {scenario.run.seed}"


TITLE = 10.0
"""Size (points) of a title's letters."""

LETTER = 0.56
"""Width of a letter over its size."""

LEGEND = 9.0
"""Size (points) of the letters of a legend above panels."""

LEGEND_LINE = 0.65
"""Inches that the line of a legend takes, with the space between columns."""


def heading(figure: "Figure", text: str) -> None:
    """A title at the upper left of the whole figure, in lines that it is wide enough for."""
    figure.suptitle(in_lines(text, figure.get_figwidth()), x=0.01, ha="left", fontsize=TITLE)


def in_lines(text: str, width: float, size: float = TITLE) -> str:
    """A title, its letters of a ``size`` (points), in lines that fit into a width (inches)."""
    letters = max(16, int(width * 72 / (LETTER * size)) - 2)
    return "\n".join(textwrap.fill(line, letters) for line in text.splitlines())


def legend_above(figure: "Figure", handles: "Sequence[Artist]", labels: Sequence[str]) -> None:
    """A legend above all panels, in lines and columns that fit; the figure grows for all but one line."""
    width = figure.get_figwidth()
    told = [in_lines(label, width - LEGEND_LINE, LEGEND) for label in labels]
    longest = max((len(line) for label in told for line in label.splitlines()), default=1)
    across = int(width / (LEGEND_LINE + longest * LETTER * LEGEND / 72))
    across = min(max(across, 1), 4, max(len(told), 1))
    down = -(-len(told) // across)
    lines = down * max((label.count("\n") + 1 for label in told), default=1)
    figure.set_figheight(figure.get_figheight() + (lines - 1) * 1.5 * LEGEND / 72)
    figure.legend(handles, told, loc="outside upper left", ncols=across, frameon=False, fontsize=LEGEND)
