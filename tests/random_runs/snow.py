"""``python -m tests.random_runs.snow FIRST [COUNT]``: random snow under random weather, its ledger checked.

A scenario comes from its number alone. After every piece of a run each cell holds what its layers hold, and
the bed what the ledger counts: at the start, entered (fallen too), less what left. Elevation is the layers'.
"""

import json
import sys
from random import Random
from typing import Any

import numpy as np

import barchan
from barchan.fields import HEIGHT_UNIT
from barchan.kernels.snow.state import quanta_of
from barchan.simulation import Simulation
from barchan.snow.conditions import thickness_of
from barchan.snow.fields import layers_of


def scenario(number: int) -> dict[str, Any]:
    """The scenario of a number: what decides which kernels are compiled is the same in all."""
    rng = Random(number)
    edges = rng.random() < 0.5
    strength = rng.choice([6.0, 9.0, 12.0, 18.0, 30.0])
    model: dict[str, Any] = {
        "name": "snow",
        "quantum": rng.choice([0.1, 0.5, 1.0, 3.0, 20.0]),
        "layers": rng.choice([2, 3, 8]),
        "hop": rng.choice([0.05, 0.1, 0.37, 1.0]),
        "reference_wind": rng.choice([20.0, 25.0]),
        "creep": rng.choice([{"gain": 1.0}, {"gain": 8.0}, {"law": "threshold"}]),
        "abrasion": {"rate": rng.choice([0.02, 0.5])},
        "threshold": {"law": rng.choice(["bonds", "bonds", "li_pomeroy", "snowtran", "mar"])},
        "bonding": {"impact_mass": rng.choice([0.0, 0.7, 6.0])},
        "packing": {"law": rng.choice(["vionnet", "anderson", "none"])},
        "beneath": [
            {"mass": rng.uniform(0.5, 30.0), "age": rng.choice([0.0, 30.0, 400.0]), "weak_share": 0.1}
            for _ in range(rng.choice([0, 0, 1, 2]))
        ],
    }
    return {
        "barchan": 5,
        "lattice": {
            "rows": rng.randint(8, 24),
            "columns": rng.randint(8, 32),
            "cell_size": rng.choice([0.05, 0.1, 0.5]),
            "boundary_x": "open" if edges else rng.choice(["open", "periodic"]),
            "boundary_y": "open" if edges else rng.choice(["open", "periodic"]),
        },
        "ground": rng.choice([{"kind": "flat"}, {"kind": "uneven"}]),
        "sand": {"kind": rng.choice(["flat", "dropped"]), "mean": rng.choice([0, 1, 4, 30])},
        "wind": {
            "kind": "regimes",
            "regimes": [_regime(rng, strength * rng.uniform(0.3, 1.2)) for _ in range(rng.randint(1, 3))],
        },
        "influx": {"kind": "saturation", "share": 0.7} if edges else None,
        "model": model,
        "run": {"steps": rng.randint(5, 60), "seed": rng.randrange(2**32)},
    }


def _regime(rng: Random, speed: float) -> dict[str, Any]:
    """A wind of some steps, along an axis, with its weather."""
    found: dict[str, Any] = {
        "direction": rng.choice([0.0, 90.0, 180.0, 270.0]),
        "steps": rng.randint(1, 20),
        "speed": round(speed, 2),
        "unit": "m/s",
        "temperature": rng.choice([-30.0, -10.0, -1.0, 2.0]),
        "snowfall": rng.choice([0.0, 0.0, 1e-3, 5e-2]),
    }
    if rng.random() < 0.3:
        found["gusts"] = {"intensity": 0.3}
    return found


def check(number: int) -> int:
    """Run a scenario in pieces and check the ledger after each; the quanta that moved."""
    simulation = Simulation(barchan.load(scenario(number)))
    rng, moved = Random(number + 1), 0
    parameters = simulation.model.parameters
    while simulation.steps_done < simulation.scenario.run.steps:
        rest = simulation.scenario.run.steps - simulation.steps_done
        moved += simulation.advance(min(rng.randint(1, 20), rest)).moved
        bed, ledger = simulation.bed, simulation.ledger
        layers = list(layers_of(bed))
        np.testing.assert_array_equal(sum(map(quanta_of, layers)), bed.arrays["snow"])
        assert bed.units == ledger.initial + ledger.entered - ledger.left
        depth = sum(thickness_of(layer, parameters.quantum) for layer in layers) * HEIGHT_UNIT
        np.testing.assert_allclose(bed.depth, depth, atol=1e-9)
    return moved


def main() -> int:
    """Run the scenarios; 1 where one fails."""
    first, count = int(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 1
    moved = failed = refused = 0
    for number in range(first, first + count):
        try:
            moved += check(number)
        except barchan.BarchanError as error:
            refused += 1
            sys.stderr.write(f"scenario {number} is refused: {error}\n")
        except AssertionError as error:
            failed += 1
            sys.stdout.write(f"scenario {number} failed: {error}\n{json.dumps(scenario(number))}\n")
    sys.stdout.write(f"{count} scenarios, {refused} refused, {failed} failed, {moved:,} quanta moved\n")
    return min(failed, 1)


if __name__ == "__main__":
    sys.exit(main())
