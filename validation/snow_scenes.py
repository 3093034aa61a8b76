"""Fields of snow on coarse cells, for the studies: 0.2 m, hops of 0.2 m, quanta of 1 kg/m²."""

import math

import numpy as np

import barchan
from barchan.kernels.snow.state import epoch_of, quanta_of
from barchan.measures import dominant_spacing, migration
from barchan.measures.snow_forms import central_relief, form_of, slope_skewness
from barchan.snow.clock import FIRST_EPOCH
from barchan.snow.conditions import Conditions
from barchan.snow.fields import layers_of, surface_age

CELL = 0.2


def field(wind, temperature, seed, *, mean=60, rows=48, columns=128, sand=None, **model):
    """A periodic field of snow under a steady wind (m/s) at a temperature (°C)."""
    return barchan.Simulation(
        barchan.load(
            {
                "barchan": 2,
                "lattice": {"rows": rows, "columns": columns, "cell_size": CELL},
                "sand": sand or {"kind": "flat", "mean": mean},
                "wind": {"kind": "steady", "speed": wind, "unit": "m/s", "temperature": temperature},
                "model": {
                    "name": "snow",
                    "hop": CELL,
                    "temperature": temperature,
                    "reference_wind": max(wind, 9.0),
                    **model,
                },
                "run": {"steps": 10**7, "seed": seed},
            }
        )
    )


def advance(simulation, hours):
    """Go on for some hours."""
    simulation.advance(round(hours * 3600 / simulation.scenario.step_seconds))


def forms(simulation, hours_between=0.5):
    """Relief, spacing, skewness, speed over the next half hour, and class of a field."""
    before = simulation.elevation.copy()
    parameters = simulation.model.parameters
    first = {
        "relief": central_relief(before),
        "spacing": dominant_spacing(before, CELL, 270.0),
        "skew": slope_skewness(before, CELL, 270.0),
        "bare": float((simulation.bed.arrays["snow"] == 0).mean()),
        "density": float(simulation.bed.arrays["snow"].sum() / simulation.bed.depth.sum()),
    }
    advance(simulation, hours_between)
    steps = round(hours_between * 3600 / simulation.scenario.step_seconds)
    shift = migration((0, steps), (before, simulation.elevation))
    speed = shift.along(1.0, 0.0) * CELL * 3600 / simulation.scenario.step_seconds
    bonded = float((surface_age(simulation.bed) >= parameters.bonding.loose_hours).mean())
    quantum = parameters.quantum / first["density"]
    kind = form_of(
        relief=first["relief"],
        spacing=first["spacing"],
        skewness=first["skew"],
        speed=speed,
        bonded=bonded,
        quantum=quantum,
    )
    return {**first, "speed": 0.0 if math.isnan(speed) else speed, "bonded": bonded, "form": kind}


def never_moved(simulation):
    """Share of the snow of the start that has never moved: its bonds are older than the run."""
    kept = sum(
        (quanta_of(words) * (epoch_of(words) < FIRST_EPOCH)).sum() for words in layers_of(simulation.bed)
    )
    return float(kept / simulation.ledger.initial)


def dome(length, wind, temperature, seed):
    """Share that never moved of a dome of drift of a length (m), a 37th as high, on bare ground."""
    density = Conditions(field(wind, temperature, seed).model.parameters, wind, temperature).drift_density
    width = 0.2 * length
    sand = {"kind": "mound", "mean": 0, "height": length / 37.0, "width": width, "x": 0.3}
    columns = int(max(5 * length / CELL, 40))
    simulation = field(
        wind,
        temperature,
        seed,
        rows=max(int(1.6 * length / CELL), 16),
        columns=columns,
        sand=sand,
        start_density=density,
        start_age=0.4,
        quantum=0.5,
    )
    advance(simulation, 0.2 + 24.0 / float(np.clip(wind - 6.0, 1.0, 4.0)))
    return never_moved(simulation)
