"""Speed of single dunes against their height: bedforms of one shape move at a speed of one over height.

A cone of sand on bare ground, 128 × 256 cells, periodic; its height and speed are measured from step 100 to
step 300 (highest stack; centre of what stands above 0.3 of it, from five frames). Cones of 20 to 40
cells in radius. The exponent of height is expected to be -1 (flux over height); real barchans follow 1 /
(height + some tenths of a metre), which comes out less steep.
"""

import numpy as np

import barchan
from validation.study import Row, over_seeds, spread

TITLE = "Speed against height"

MODELS = {"werner": {"name": "werner", "lee_erosion": False}, "momiji": {"name": "momiji"}}
RADII = (20.0, 26.0, 32.0, 40.0)


def dune(model, radius, seed):
    scenario = barchan.load(
        "barchans",
        lattice__rows=128,
        sand={"kind": "cone", "mean": 0, "height": radius / 2, "radius": radius, "x": 0.3, "y": 0.5},
        model=MODELS[model],
        run__steps=300,
        run__seed=seed,
    )
    simulation = barchan.Simulation(scenario)
    simulation.advance(100)
    places, heights = [], []
    for _ in range(5):
        surface = simulation.elevation
        heights.append(float(surface.max()))
        places.append(centre(np.where(surface > 0.3 * surface.max(), surface, 0.0)))
        simulation.advance(50)
    speed = np.polyfit(50 * np.arange(5), np.unwrap(places, period=scenario.lattice.columns), 1)[0]
    return {"height": float(np.mean(heights)), "speed": float(speed)}


def centre(surface):
    """Where the surface's weight lies along a periodic field (cells)."""
    angles = 2 * np.pi * np.arange(surface.shape[1]) / surface.shape[1]
    return float(np.angle(surface.sum(axis=0) @ np.exp(1j * angles))) * surface.shape[1] / (2 * np.pi)


def rows():
    cases = [(model, radius) for model in MODELS for radius in RADII]
    results = dict(zip(cases, over_seeds(dune, cases), strict=True))
    for model in MODELS:
        found = [results[model, radius] for radius in RADII]
        for radius, result in zip(RADII, found, strict=True):
            text = f"height {spread(result['height'])} m, speed {spread(result['speed'])} cells/step"
            yield Row(f"{model}, cone of radius {radius:g} cells", "-", text)
        exponents = [
            np.polyfit(np.log([f["height"][k] for f in found]), np.log([f["speed"][k] for f in found]), 1)[0]
            for k in range(len(found[0]["height"]))
        ]
        yield Row(f"{model}: exponent of height", "-1", spread(exponents))


READING = """
Larger dunes are slower in both models. The exponent is nearer to zero than -1: as for 1 / (H + H0), for a
cone changes its shape with its size and sand passes along its sides and leaves at its horns; in Momiji's
model also because hops, and with them the flux, grow with height, so that speed hardly falls.
"""
