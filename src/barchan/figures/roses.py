"""Wind roses and sand roses, with the drift and the crests to expect."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.figures.style import CURVE, GROUND, SAND, SHADOW, new_figure
from barchan.theory.assessment import Assessment
from barchan.theory.crests import Crest
from barchan.theory.drift import Drift
from barchan.theory.roses import SECTORS, sand_rose, sectors, speed_limits, wind_rose
from barchan.wind.records import WindRecord

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from matplotlib.projections.polar import PolarAxes


def roses(
    title: str,
    found: Assessment,
    record: WindRecord | None = None,
    threshold: float = 6.0,
    count: int = SECTORS,
) -> "Figure":
    """The wind rose of a record, if there is one, and the sand rose with the resultant and predicted crests.

    Petals point where winds come from, arrows where sand goes. The classes of speed are counted from the
    ``threshold`` (m/s).
    """
    figure = new_figure(11.5 if record else 6.2, 6.2)
    panels = figure.subplots(1, 2 if record else 1, subplot_kw={"projection": "polar"}, squeeze=False)[0]
    for axes in panels:
        _compass(axes)
    if record:
        _draw_wind(panels[0], record, threshold, count)
    _draw_sand(panels[-1], found, count)
    figure.suptitle(title, fontsize=11, x=0.01, ha="left")
    return figure


def _compass(axes: "PolarAxes") -> None:
    axes.set_theta_zero_location("N")
    axes.set_theta_direction(-1)
    axes.set_thetagrids(range(0, 360, 45), ["N", "NE", "E", "SE", "S", "SW", "W", "NW"])
    axes.tick_params(labelsize=8)
    axes.grid(alpha=0.4)


def _draw_wind(axes: "PolarAxes", record: WindRecord, threshold: float, count: int) -> None:
    """Shares of the time by direction and speed."""
    import matplotlib as mpl
    from cmcrameri import cm

    limits = speed_limits(record, threshold)
    table, calms, unknown = wind_rose(record, limits, count)
    shades = mpl.colormaps.get_cmap(cm.lapaz_r)(np.linspace(0.15, 0.95, table.shape[1]))
    edges = [0.0, *limits]
    names = [f"{low:.3g}–{high:.3g}" for low, high in zip(edges, limits, strict=False)] + [
        f"over {limits[-1]:.3g}"
    ]
    bottom = np.zeros(count)
    for column, (colour, name) in enumerate(zip(shades, names, strict=True)):
        bottom = _petals(axes, 100.0 * table[:, column], colour, bottom, f"{name} m/s")
    _scale(axes, table.sum(axis=1))
    variable = f", no direction {100 * unknown:.1f} %" if unknown else ""
    axes.set_title(f"Share of the time (%), calm {100 * calms:.1f} %{variable}", fontsize=10, pad=18)
    _legend(axes)


def _draw_sand(axes: "PolarAxes", found: Assessment, count: int) -> None:
    """Sand moved by direction, where it goes, and how crests should run."""
    drift = found.drift
    petals = sand_rose(drift, count)
    unit = "share" if drift.unit == "-" else drift.unit
    axes.set_title(f"Sand moved ({unit})", fontsize=10, pad=18)
    if not found.moves:
        axes.text(0.5, 0.5, "nothing would move", transform=axes.transAxes, ha="center", va="center")
        axes.set_yticks([])
        return
    _petals(axes, petals, SAND, np.zeros(count), "sand moved, by where its wind is from")
    reach = float(petals.max())
    axes.set_ylim(0, 1.12 * reach)
    crests = [found.gross_transport.azimuth, found.bed_instability.azimuth]
    _scale(axes, petals, [drift.toward, found.elongation, *crests, *(crest + 180.0 for crest in crests)])
    _arrow(axes, drift, reach)
    _crest(axes, found.gross_transport, reach, SHADOW, "-", "crest, gross transport")
    _crest(axes, found.bed_instability, reach, SHADOW, (0, (4, 2)), "crest, bed instability")
    if not np.isnan(found.elongation):
        angle = np.radians(found.elongation)
        axes.plot([angle, angle], [0, reach], ":", color=GROUND, linewidth=2.2, label="fingers grow to")
    _legend(axes)


def _legend(axes: "PolarAxes") -> None:
    axes.legend(fontsize=8, loc="upper center", bbox_to_anchor=(0.5, -0.07), ncols=2, frameon=False)


def _scale(axes: "PolarAxes", lengths: NDArray, lines: Sequence[float] = ()) -> None:
    """Few marks of the scale, written where the rose is emptiest, away from lines in it (degrees)."""
    from matplotlib.ticker import MaxNLocator

    count = len(lengths)
    filled = lengths.copy()
    at = sectors(np.array([line for line in lines if not np.isnan(line)]) % 360.0, count)
    filled[at] += lengths.max()
    around = filled + 0.5 * (np.roll(filled, 1) + np.roll(filled, -1))
    axes.set_rlabel_position(float(np.argmin(around)) * 360.0 / count)
    axes.yaxis.set_major_locator(MaxNLocator(4))


def _petals(axes: "PolarAxes", lengths: NDArray, colour: object, bottom: NDArray, label: str) -> NDArray:
    """Bars about the compass; returns where the next ones begin."""
    count = len(lengths)
    angles = np.arange(count) * 2 * np.pi / count
    axes.bar(
        angles, lengths, width=0.85 * 2 * np.pi / count, bottom=bottom, color=colour, edgecolor="black",
        linewidth=0.3, label=label,
    )  # fmt: skip
    return bottom + lengths


def _arrow(axes: "PolarAxes", drift: Drift, reach: float) -> None:
    """The resultant, as long as RDP is of DP against the largest petal."""
    if np.isnan(drift.toward):
        return
    tip = (np.radians(drift.toward), drift.steadiness * reach)
    style = {"arrowstyle": "-|>", "color": CURVE, "linewidth": 2.4, "shrinkA": 0, "shrinkB": 0}
    axes.annotate("", xy=tip, xytext=(0, 0), arrowprops=style, zorder=5)
    axes.plot([], [], color=CURVE, linewidth=2.4, label=f"resultant, RDP/DP {drift.steadiness:.2f}")


def _crest(axes: "PolarAxes", crest: Crest, reach: float, colour: str, style: object, label: str) -> None:
    """A line through the middle, thin for rivals that are as good."""
    if np.isnan(crest.azimuth):
        return
    for azimuth, width in [(crest.azimuth, 2.0), *((rival, 0.8) for rival in crest.rivals)]:
        angles = np.radians([azimuth, azimuth, azimuth + 180])
        name = label if width > 1 else f"{label}, as good"
        axes.plot(angles, [reach, 0, reach], linestyle=style, color=colour, linewidth=width, label=name)
