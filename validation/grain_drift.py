"""Which way waves of sand travel: against the wind after the published rules, downwind with splash.

Waves are laid across fields of 256 × 32 cells of 5 mm once the grains in the air have found their balance,
after 3 s of flight, 3 seeds; they are 8 cm long unless it says otherwise, and a 40th of that high. `wang_hu`
has 10 m/s and steps of 0.5 ms. How the amplitude and the phase of that wave in the bed change in 4000
iterations gives how fast it grows and travels, by the wind that the bed sees. A grain's sand is a quarter of
a grain thick and lies over a patch of nine stacks under `ripples`; under `wang_hu`, and on the rough bed, it
is as thick as a grain and lies on one stack. The rough bed has had 250 s of wind before the wave is laid.
"""

import numpy as np

import barchan
from validation.study import Row, order, over_seeds, spread

TITLE = "Which way waves of grains travel"

SEEDS = (1, 2, 3)
CELL, DIAMETER = 0.005, 0.15e-3
COLUMNS, ROWS = 256, 32
DEPTH = 0.03
LENGTHS = {4: "32 cm", 8: "16 cm", 16: "8 cm", 24: "5.3 cm", 32: "4 cm"}
"""Waves in a field, and how long they are."""
HEIGHT = 1 / 40
"""Of waves, over their length: lower than ripples that have saturated."""
WARM_UP, ROUGHENING, SPELL, MEASURED, LOOKS = 120, 200, 6, 80, 8
"""Steps before the waves are laid, or before that on the rough bed; until grains have met them; measured; and
how often their phase is looked at."""


def response(model, waves, warm_up, seed):
    """Growth (1/s) and speed downwind (mm/s) of the waves, per second of wind."""
    patch = model["name"] == "ripples" and model.get("footprint") != "stack"
    parcel = DIAMETER / 64 if patch else DIAMETER
    scenario = barchan.load(
        {
            "barchan": 5,
            "lattice": {"rows": ROWS, "columns": COLUMNS, "cell_size": CELL, "slab_height": parcel},
            "sand": {"kind": "flat", "mean": round(DEPTH / parcel)},
            "model": {"iterations_per_step": 50, "time_step": 5e-4, **model},
            "run": {"steps": warm_up + SPELL + MEASURED, "seed": seed},
        }
    )
    simulation = barchan.Simulation(scenario)
    simulation.advance(warm_up)
    phase = np.arange(COLUMNS) * 2 * np.pi * waves / COLUMNS
    length = COLUMNS * CELL / waves
    wave = np.rint(0.5 * HEIGHT * length / parcel * np.sin(phase)).astype(np.int32)
    simulation.bed.sand[...] = simulation.bed.sand + wave
    simulation.ledger.entered += int(wave.sum()) * ROWS
    simulation.advance(SPELL)
    before = simulation.bed.sand.mean(axis=0)
    slope = np.diff(simulation.bed.sand - before, axis=1).std() * parcel / CELL
    found = [np.mean(before * np.exp(-1j * phase))]
    for _ in range(LOOKS):
        simulation.advance(MEASURED // LOOKS)
        found.append(np.mean(simulation.bed.sand.mean(axis=0) * np.exp(-1j * phase)))
    seconds = simulation.model.step_seconds * MEASURED
    growth = np.log(abs(found[-1] / found[0])) / seconds
    turn = -np.angle(np.array(found[1:]) / found[:-1]).sum() / seconds
    return {
        "growth": float(growth) * 1e3,
        "speed": float(turn * length / (2 * np.pi) * 1e3),
        "rough": float(np.degrees(np.arctan(slope))),
        "airborne": simulation.model.pool.flying / scenario.lattice.cells,
    }


def rows():
    published = {"name": "wang_hu", "wind_speed": 10.0}
    winds = (10.0, 12.0, 15.0)
    splash = [
        {"name": "ripples", "wind_speed": speed, "max_grains_per_cell": 8.0, **_weight(0.08)}
        for speed in winds
    ]
    whole = [{**model, "footprint": "stack", **_weight(0.02)} for model in splash]
    level = {**splash[2], "relief_flow": {"streamline_height": None}}
    cases = [
        ({**published, "entrainment": {"from_lee": True}}, 16, WARM_UP),
        ({**published, "entrainment": {"from_lee": False}}, 16, WARM_UP),
        *((model, 16, ROUGHENING) for model in whole),
        *((level, waves, WARM_UP) for waves in LENGTHS),
        *((model, waves, WARM_UP) for waves in LENGTHS for model in splash),
    ]
    anywhere, stoss, *others = over_seeds(response, cases, SEEDS)
    rough, straight, smooth = others[:3], others[3 : 3 + len(LENGTHS)], others[3 + len(LENGTHS) :]
    by_length = {waves: smooth[3 * at : 3 * at + 3] for at, waves in enumerate(LENGTHS)}
    found = by_length[16]
    yield _speed("`wang_hu`, lift-off from anywhere", "against the wind (Prague thesis)", anywhere, -1)
    yield _speed("`wang_hu`, not from lee faces", "–", stoss, 1)
    for speed, result in zip(winds, found, strict=True):
        yield _speed(f"`ripples`, {speed:g} m/s", "downwind", result, 1)
    yield order("speed of `ripples`, 15 against 10 m/s", "more", found[2]["speed"], found[0]["speed"], "mm/s")
    for speed, result in zip(winds, rough, strict=True):
        yield _speed(f"`ripples` on the rough bed, {speed:g} m/s", "downwind", result, 1)
    yield from _by_length("15 m/s, wind that blows level", dict(zip(LENGTHS, straight, strict=True)))
    for at, speed in enumerate(winds):
        yield from _by_length(f"{speed:g} m/s", {waves: by_length[waves][at] for waves in LENGTHS})
    for name, results in (("smooth", found), ("rough", rough)):
        for speed, result in zip(winds, results, strict=True):
            yield Row(f"slopes along the wind, {name} bed, {speed:g} m/s", "–", f"{spread(result['rough'])}°")
    for speed, result in zip(winds, found, strict=True):
        yield Row(f"grains in the air, {speed:g} m/s", "–", f"{spread(result['airborne'])} a cell")


def _weight(share):
    return {"feedback": {"momentum_weight": share}}


def _by_length(name, found):
    for waves, length in LENGTHS.items():
        growth, speed = spread(found[waves]["growth"]), spread(found[waves]["speed"])
        what = f"waves of {length}, `ripples`, {name}"
        yield Row(what, "–", f"grow {growth} in 1000 s of wind, travel {speed} mm/s")


def _speed(what, published, found, sign):
    values = found["speed"]
    votes = sum(value * sign > 0 for value in values)
    verdict = f"{votes} of {len(values)} seeds {'downwind' if sign > 0 else 'against the wind'}"
    return Row(f"speed, {what}", published, f"{spread(values)} mm/s", verdict)


READING = """
Lifted from anywhere, sand is lost equally everywhere and gained where faces look upwind: the waves travel
against the wind, as the Prague thesis reports. Where lee faces give none, the windward ones lose it too and
the waves travel downwind.

With splash and grains that are pushed along the bed waves of all lengths travel downwind in every wind and
seed, faster in stronger wind, and of those below 16 cm the shorter ones faster; on a bed that whole parcels
have roughened to slopes of 14° too, at less than half the speed. Lester et al. (2025) derive that the
direction hangs on a small difference of what flies, and that ripples turn where hops are short beside the
wavelength; here pushed grains outweigh it.

These waves are a 40th as high as long. Those of 8 cm shrink slowly, others faster: sines are
not the shape that ripples take, and a bed that is left to itself has as high ones of 10 to 11 cm.
"""
