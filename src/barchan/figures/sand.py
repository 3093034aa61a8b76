"""Figures of thresholds and flux laws."""

from typing import TYPE_CHECKING, Any

import numpy as np

from barchan.aeolian.flux import LAWS
from barchan.aeolian.grains import bagnold_threshold, settling_speed, shao_lu
from barchan.aeolian.saltation import Saltation
from barchan.figures.style import CURVE, GROUND, SHADOW, new_figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

DIAMETERS = (0.02e-3, 2e-3)
"""Grain diameters of the figure (m), from silt to very coarse sand."""


def thresholds(sand: Saltation) -> "Figure":
    """Threshold friction velocity against grain diameter, and the divide between saltation and suspension.

    Grains fly in suspension where the friction velocity exceeds the speed at which they settle: then eddies
    carry them up as fast as they fall (Bagnold 1941). The counterpart of Fig. 2.4 of the Prague thesis.
    """
    diameters = np.geomspace(*DIAMETERS, 400)
    grains = (diameters, sand.grain_density, sand.air_density)
    settling, cohesive = settling_speed(*grains), shao_lu(*grains)
    figure = new_figure(7.5, 5.4)
    axes = figure.subplots()
    millimetres = 1e3 * diameters
    axes.loglog(millimetres, cohesive, color=SHADOW, linewidth=2, label="threshold, Shao & Lu (2000)")
    axes.loglog(millimetres, bagnold_threshold(*grains), color=SHADOW, linewidth=1, linestyle=":",
                label="threshold, Bagnold (1941), no cohesion")  # fmt: skip
    axes.loglog(millimetres, settling, color=CURVE, linewidth=1.6, linestyle="--",
                label="u* = settling speed: suspension above")  # fmt: skip
    size, threshold = 1e3 * sand.grain_diameter, sand.threshold_friction_velocity()
    axes.plot(size, threshold, "o", color="black", label=f"{size:g} mm: {threshold:.2f} m/s")
    axes.set_xlim(1e3 * DIAMETERS[0], 1e3 * DIAMETERS[1])
    axes.set_ylim(0.1, 3.0)
    for x, y, name in ((0.04, 0.8, "suspension"), (0.6, 0.8, "saltation"), (0.25, 0.13, "no movement")):
        axes.text(x, y, name, fontsize=11, style="italic", ha="center")
    axes.set_xlabel("grain diameter (mm)")
    axes.set_ylabel("friction velocity u* (m/s)")
    axes.set_xticks([0.02, 0.05, 0.1, 0.2, 0.5, 1, 2], ["0.02", "0.05", "0.1", "0.2", "0.5", "1", "2"])
    axes.set_yticks([0.1, 0.2, 0.5, 1, 2], ["0.1", "0.2", "0.5", "1", "2"])
    axes.minorticks_off()
    per_speed = float(sand.friction_velocity(1.0))
    ways: Any = (lambda u: u / per_speed, lambda speed: speed * per_speed)
    right = axes.secondary_yaxis("right", functions=ways)
    right.set_ylabel(f"wind at {sand.height:g} m over z₀ = {1e3 * sand.roughness_length:.3g} mm (m/s)")
    right.set_yticks([5, 10, 20, 50], ["5", "10", "20", "50"])
    right.minorticks_off()
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8, loc="upper left")
    return figure


def flux_laws(sand: Saltation, fastest: float = 20.0) -> "Figure":
    """All flux laws over wind speed (m/s) for the same sand and threshold; the chosen one is thick."""
    import matplotlib as mpl

    speeds = np.linspace(0.0, max(fastest, 2 * sand.threshold_speed()), 500)
    figure = new_figure(8.0, 5.2)
    axes = figure.subplots()
    colours = mpl.colormaps["tab10"].colors  # type: ignore[attr-defined]
    for colour, (name, law) in zip(colours, LAWS.items(), strict=False):
        flux = sand.model_copy(update={"law": name}).mass_flux(speeds)
        chosen = name == sand.law
        style: dict[str, Any] = {
            "linewidth": 3.0 if chosen else 1.3,
            "color": colour,
            "zorder": 4 if chosen else 2,
        }
        style["linestyle"] = "--" if name == "tsoar" else "-"  # it lies on Lettau's for dune sand
        axes.plot(speeds, flux, label=f"{law.title} ({name})", **style)
    axes.axvline(sand.threshold_speed(), color=GROUND, linestyle="--", linewidth=1)
    axes.annotate(
        f" threshold {sand.threshold_speed():.2f} m/s", (sand.threshold_speed(), 0.97),
        xycoords=("data", "axes fraction"), fontsize=8, va="top", rotation=90, ha="right",
    )  # fmt: skip
    axes.set_xlim(0, speeds[-1])
    axes.set_ylim(0, None)
    axes.set_xlabel(f"wind speed at {sand.height:g} m (m/s)")
    axes.set_ylabel("mass flux (kg/m/s)")
    grains = f"grains of {1e3 * sand.grain_diameter:g} mm, z₀ = {1e3 * sand.roughness_length:.3g} mm"
    axes.set_title(f"Flux laws: {grains}", fontsize=10, loc="left")
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8)
    return figure
