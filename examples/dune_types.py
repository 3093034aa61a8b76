"""Draw a diagram of dune types from real runs: sand supply against how variable the wind is.

The counterpart of Fig. 2.5 of Szabó (2019), after Wasson & Hyde (1983) and Bishop et al. (2002): barchans and
transverse dunes under one wind, linear dunes between two, domes, stars and networks under many. Each
picture is one run of Werner's model, from the lowest to the highest of its surface. Below each column stands
RDP/DP of its wind, beside each row the thickness of its sand spread evenly.

Run ``python examples/dune_types.py diagram.png`` for the picture, ``--help`` for its options.
"""

import argparse
from pathlib import Path

from matplotlib.colors import Normalize
from matplotlib.figure import Figure

import barchan
from barchan.figures.maps import shaded
from barchan.figures.style import extent
from barchan.theory.assessment import scenario_drift

SUPPLIES = (3, 5, 8, 16)
"""Slabs on a cell."""

WINDS = {
    "one wind": (270,),
    "two winds 60° apart": (300, 240),
    "two winds 120° apart": (330, 210),
    "five winds": (270, 54, 198, 342, 126),
}
"""Where winds come from that blow in turn for equal times."""

MODEL = {"name": "werner", "p_s": 0.4, "p_ns": 0.9, "repose_angle": 30, "repose_test": "before"}
MODEL |= {"lee_erosion": True, "forced_erosion": True, "neighbourhood": "moore", "corner_limit": 3}
"""The probabilities of the preset barchans-p, with which dunes form fast; eight neighbours."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("picture", type=Path, help="file of the picture: .png, .jpg, .pdf, …")
    parser.add_argument("--size", type=int, default=160, help="cells to a side (160)")
    parser.add_argument("--steps", type=int, default=250, help="steps of each run (250)")
    parser.add_argument("--turn", type=int, default=25, help="steps that a wind blows (25)")
    parser.add_argument("--dpi", type=int, default=100, help="dots per inch of the picture (100)")
    asked = parser.parse_args()
    diagram(asked.size, asked.steps, asked.turn).savefig(asked.picture, dpi=asked.dpi)


def diagram(size: int, steps: int, turn: int) -> Figure:
    """A picture for each supply (upwards) and each wind (to the right)."""
    figure = Figure(figsize=(2.1 * len(WINDS) + 0.4, 2.2 * len(SUPPLIES) + 0.6), layout="constrained")
    grid = figure.subplots(len(SUPPLIES), len(WINDS))
    for row, supply in zip(grid[::-1], SUPPLIES, strict=True):
        for axes, (name, directions) in zip(row, WINDS.items(), strict=True):
            scenario = scene(supply, directions, size, steps, turn)
            draw(axes, scenario)
            if axes in grid[:, 0]:
                axes.set_ylabel(f"{supply * scenario.lattice.thickness:.2g} m of sand", fontsize=9)
            if axes in grid[-1]:
                axes.set_xlabel(f"{name}\nRDP/DP {scenario_drift(scenario).steadiness:.2f}", fontsize=9)
    return figure


def scene(supply: int, directions: tuple[int, ...], size: int, steps: int, turn: int) -> barchan.Scenario:
    """A field of sand under winds that blow in turn."""
    winds = [{"direction": direction, "steps": turn} for direction in directions]
    return barchan.load(
        {
            "barchan": 5,
            "lattice": {"rows": size, "columns": size},
            "sand": {"kind": "flat", "mean": supply},
            "wind": {"kind": "regimes", "regimes": winds},
            "model": MODEL,
            "run": {"steps": steps, "save_every": max(steps, 1), "seed": 1},
        }
    )


def draw(axes, scenario: barchan.Scenario) -> None:
    """The last bed of a run, in colours of its own; bare ground is grey."""
    last = barchan.simulate(scenario).isel(step=-1)
    surface = last["elevation"].values
    norm = Normalize(surface.min(), max(surface.max(), surface.min() + 1.0))
    axes.imshow(shaded(last, scenario, norm=norm), origin="lower", extent=extent(scenario))
    axes.set_xticks([])
    axes.set_yticks([])
    axes.set_title(f"{surface.min():.1f} to {surface.max():.1f} m", fontsize=8)


if __name__ == "__main__":
    main()
