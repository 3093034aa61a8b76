"""Fields of snow for the studies: coarse, 0.2 m with hops of 0.2 m, and fine, 0.1 m with hops of 0.1 m."""

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
                "barchan": 5,
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


FINE = 0.1


def part(hours, speed, temperature=-10.0, snowfall=0.0):
    """Some hours of a wind (m/s) from the left at a temperature (°C), with snowfall (kg/m² an hour)."""
    return {
        "direction": 270,
        "seconds": 3600.0 * hours,
        "speed": speed,
        "unit": "m/s",
        "temperature": temperature,
        "snowfall": snowfall / 3600.0,
    }


def falling(hours, first, last, temperature=-10.0, levels=12):
    """A wind that falls evenly, in levels of equal length."""
    step = (first - last) / levels
    return [part(hours / levels, first - (k + 0.5) * step, temperature) for k in range(levels)]


def fine(winds, seed, *, mean=0, sand=None, rows=32, columns=128, cell=FINE, influx=None, **model):
    """A field on fine cells under winds one after the other; open along the wind where drift enters."""
    lattice = {"rows": rows, "columns": columns, "cell_size": cell}
    if influx is not None:
        lattice["boundary_x"] = "open"
        influx = {"kind": "saturation", "share": influx}
    return barchan.Simulation(
        barchan.load(
            {
                "barchan": 5,
                "lattice": lattice,
                "sand": sand or {"kind": "flat", "mean": mean},
                "wind": {"kind": "regimes", "regimes": winds, "repeat": False},
                "influx": influx,
                "model": {"name": "snow", **model},
                "run": {"steps": 10**7, "seed": seed},
            }
        )
    )


def advance(simulation, hours):
    """Go on for some hours."""
    simulation.advance(round(hours * 3600 / simulation.scenario.step_seconds))


def at_rest(simulation):
    """Relief, spacing, skewness, bare share and density of a field, and the share that has bonded."""
    surface, cell = simulation.elevation, simulation.scenario.lattice.cell_size
    periodic = simulation.scenario.lattice.periodic
    bonding = simulation.model.parameters.bonding
    return {
        "relief": central_relief(surface),
        "spacing": dominant_spacing(surface, cell, 270.0),
        "skew": slope_skewness(surface, cell, 270.0, periodic),
        "bare": float((simulation.bed.arrays["snow"] == 0).mean()),
        "density": float(simulation.bed.arrays["snow"].sum() / simulation.bed.depth.sum()),
        "bonded": float((surface_age(simulation.bed) >= bonding.loose_hours).mean()),
    }


def forms(simulation, hours_between=0.5):
    """What ``at_rest`` finds, the speed over the next half hour, the share bonded then, and the class."""
    before, first = simulation.elevation.copy(), at_rest(simulation)
    seconds = simulation.scenario.step_seconds
    steps = round(hours_between * 3600 / seconds)
    advance(simulation, hours_between)
    shift = migration((0, steps), (before, simulation.elevation))
    speed = shift.along(1.0, 0.0) * simulation.scenario.lattice.cell_size * 3600 / seconds
    bonded = at_rest(simulation)["bonded"]
    kind = form_of(
        relief=first["relief"],
        spacing=first["spacing"],
        skewness=first["skew"],
        speed=speed,
        bonded=bonded,
        quantum=simulation.model.parameters.quantum / first["density"],
    )
    return {**first, "speed": 0.0 if math.isnan(speed) else speed, "bonded": bonded, "form": kind}


def never_moved(simulation):
    """Share of the snow of the start that has never moved: its bonds are older than the run."""
    kept = sum(
        (quanta_of(words) * (epoch_of(words) < FIRST_EPOCH)).sum() for words in layers_of(simulation.bed)
    )
    return float(kept / simulation.ledger.initial)


def dome(length, wind, temperature, seed, **model):
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
        **model,
    )
    advance(simulation, 0.2 + 24.0 / float(np.clip(wind - 6.0, 1.0, 4.0)))
    return never_moved(simulation)
