"""The wind beside a picture: an arrow of a steady one, a small sand rose of one that changes."""

import json
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from barchan.directions import downwind
from barchan.figures.style import CURVE, SAND
from barchan.scenario import Scenario
from barchan.theory.assessment import scenario_drift
from barchan.theory.drift import Drift
from barchan.theory.roses import SECTORS, sand_rose

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.transforms import Transform

STEADY = 0.97
"""RDP/DP above which an arrow stands for all winds: they vary by some 14 degrees about their mean."""

ROSE = 44.0
"""Diameter of the small rose (points)."""


def wind_sign(axes: "Axes", scenario: Scenario, frame: "xr.Dataset") -> None:
    """The wind, above the upper right corner: its arrow, or the sand rose of a wind that changes.

    The petals of the rose point where winds come from, its arrow where the sand goes on the whole.
    """
    drift = changing_drift(scenario, frame)
    if drift is None:
        wind_arrow(axes, float(frame["wind_direction"]))
    else:
        small_rose(axes, drift)


def changing_drift(scenario: Scenario, frame: "xr.Dataset") -> Drift | None:
    """The drift of a scenario's winds where they change direction; None where one arrow stands for all.

    None, too, of a frame before which an event changed the wind: the scenario's winds did not all blow.
    """
    if any(event["kind"] == "wind" for event in json.loads(frame.attrs.get("events", "[]"))):
        return None
    drift = scenario_drift(scenario)
    return drift if drift.total > 0 and drift.steadiness < STEADY else None


def from_corner(axes: "Axes", right: float, up: float) -> "Transform":
    """Points (1/72 inch) to the right of and above the upper right corner, from a place given in points."""
    from matplotlib.transforms import Affine2D, ScaledTranslation

    figure = axes.figure
    points = Affine2D().translate(right, up).scale(1 / 72) + figure.dpi_scale_trans
    return points + ScaledTranslation(1, 1, cast(Any, axes.transAxes))


def wind_arrow(axes: "Axes", direction: float) -> None:
    """An arrow that points where the wind blows, above the upper right corner."""
    x, y = downwind(direction)
    style: dict[str, Any] = {"arrowstyle": "-|>", "color": "black", "linewidth": 1.4}
    corner = from_corner(axes, -12, 12)
    axes.annotate(
        "",
        xy=(9 * x, 9 * y),
        xycoords=corner,
        xytext=(-9 * x, -9 * y),
        textcoords=corner,
        arrowprops=style | {"shrinkA": 0, "shrinkB": 0},
        annotation_clip=False,
    )
    axes.text(-14, 0, "wind", transform=corner, ha="right", va="center", fontsize=9)


def small_rose(axes: "Axes", drift: Drift) -> None:
    """Sand moved by the winds of each direction, and where it goes on the whole."""
    corner = from_corner(axes, -ROSE, 4)
    rose: Any = axes.inset_axes((0, 0, ROSE, ROSE), transform=corner, projection="polar")
    rose.set_theta_zero_location("N")
    rose.set_theta_direction(-1)
    rose.set_xticks([])
    rose.set_yticks([])
    rose.spines["polar"].set_linewidth(0.6)
    petals = sand_rose(drift)
    reach = float(petals.max())
    angles = np.arange(SECTORS) * 2 * np.pi / SECTORS
    width = 0.85 * 2 * np.pi / SECTORS
    rose.bar(angles, petals, width=width, color=SAND, edgecolor="black", linewidth=0.3)
    rose.set_ylim(0, 1.05 * reach)
    if not np.isnan(drift.toward):
        tip = (np.radians(drift.toward), drift.steadiness * reach)
        style = {"arrowstyle": "-|>", "color": CURVE, "linewidth": 1.4, "shrinkA": 0, "shrinkB": 0}
        rose.annotate("", xy=tip, xytext=(0, 0), arrowprops=style, zorder=5)
    axes.text(-4, 8, "sand moved,\nby wind from", transform=corner, ha="right", va="bottom", fontsize=8)
