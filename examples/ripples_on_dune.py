"""Compose a picture of two scales: ripples laid over a dune, after Figs. 1.2 and 3.9 of the Prague thesis.

A barchan grows from a heap in Werner's model, ripples grow in Nishimori & Ouchi's. The dune is resampled to
finer cells and the ripples are laid over its sand: not on the slip face, not in the shadow zone, not on bare
ground. The ripples are exaggerated: on a dune of this size real ones, some 10 cm long, could not be seen.

Run ``python examples/ripples_on_dune.py picture.png`` for the picture, ``--help`` for its options.
"""

import argparse
from pathlib import Path

import numpy as np

import barchan
from barchan.figures.composition import laid_over
from barchan.figures.oblique import oblique_view
from barchan.measures import dominant_spacing

FACTOR = 5
"""Fine cells to a cell of the dune."""

RIPPLE_INDEX = 14.0
"""Spacing of the ripples over their height, about that of real ones."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("picture", type=Path, help="file of the picture: .png, .jpg, .pdf, …")
    parser.add_argument(
        "--size", type=int, default=104, help="cells of the dune's field across the wind (104)"
    )
    parser.add_argument("--steps", type=int, default=200, help="steps in which the dune grows (200)")
    parser.add_argument("--ripple-steps", type=int, default=80, help="steps in which ripples grow (80)")
    parser.add_argument("--dpi", type=int, default=150, help="dots per inch of the picture (150)")
    asked = parser.parse_args()
    frame, scenario = dune(asked.size, asked.steps)
    relief, spacing = ripples(asked.size, asked.ripple_steps, scenario.lattice.cell_size / FACTOR)
    fine, composed = laid_over(frame, scenario, relief, FACTOR, smoothing=1.5)
    height = float(fine["elevation"].max())
    sandy = (-1.5 * height, 5.0 * height)
    oblique_view(fine, composed, angle=40.0, limits=sandy).savefig(asked.picture, dpi=asked.dpi)
    print(f"dune {height:.1f} m high, ripples {spacing:.1f} m apart: {spacing / 0.1:.0f} times real ones")


def dune(size: int, steps: int):
    """A barchan, grown from a heap: its last frame and its scenario."""
    heap = {"kind": "mound", "height": size / 8, "width": size / 7, "x": 0.3}
    scenario = barchan.load(
        "single-barchan",
        lattice__rows=size,
        lattice__columns=size * 11 // 8,
        sand=heap,
        model__hop_length=8,
        run__steps=steps,
        run__save_every=max(steps, 1),
        run__seed=3,
    )
    return barchan.simulate(scenario).isel(step=-1), scenario


def ripples(size: int, steps: int, cell_size: float):
    """Heights (m) of a field of ripples on cells of another width, and their spacing (m) there."""
    scenario = barchan.load(
        "coupled-map",
        lattice__rows=2 * size,
        lattice__columns=3 * size,
        run__steps=steps,
        run__save_every=max(steps, 1),
        run__seed=1,
    )
    surface = barchan.simulate(scenario)["elevation"].values[-1]
    spacing = dominant_spacing(surface, cell_size, 270.0)
    relief = surface - surface.mean()
    height = 2.0 * np.sqrt(2.0) * relief.std()
    return relief * spacing / RIPPLE_INDEX / height, spacing


if __name__ == "__main__":
    main()
