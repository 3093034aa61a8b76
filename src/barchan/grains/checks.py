"""Checks of grains in flight: problems, facts and remarks."""

import math
from collections.abc import Sequence

import numpy as np

from barchan.aeolian.wall import log_wind
from barchan.bed import Bed
from barchan.errors import Problem
from barchan.grains.canopy import Canopy, canopy_facts
from barchan.grains.entrainment import Entrainment
from barchan.grains.parameters import GrainFlight
from barchan.lattice import Lattice

MOST_DRAG = 0.5
"""Share of a velocity difference that drag may take away in a time step."""

RIPPLES = "10 cm"
"""Spacing of ripples of fine sand, as a rough figure; ours."""

_THIN, _THICK = 0.5, 2.0
"""Heights of a grain's sand in grain diameters beyond which a user is found."""

_PATCH_WIDTH = 3
"""Stacks along a side of a patch."""


def problems(rules: GrainFlight, bed: Bed, fastest: float) -> list[Problem]:
    """Problems of a bed and of parameters; ``fastest`` is the greatest upward speed (m/s) of lift-off."""
    found = []
    if rules.carried > 1 and min(bed.lattice.shape) < _PATCH_WIDTH:
        found.append(
            Problem(
                "model.footprint",
                f"is 'patch', {_PATCH_WIDTH} stacks wide, on a field of {bed.lattice.shape[0]} × "
                f"{bed.lattice.shape[1]}; allowed there: 'stack'",
            )
        )
    if bed.units == 0:
        found.append(Problem("sand", "lies nowhere: no grain can be lifted; allowed: at least one parcel"))
    speed = _greatest_speed(rules, fastest)
    rate = float(rules.drag_rate(np.array(speed), rules.diameters[0]))
    if rate * rules.time_step > MOST_DRAG:
        found.append(
            Problem(
                "model.time_step",
                f"is {rules.time_step:g} s, long beside the {1 / rate:.2g} s in which drag works at "
                f"{speed:.2g} m/s; allowed: up to {MOST_DRAG / rate:.2g} s",
            )
        )
    if speed * rules.time_step > bed.lattice.cell_size:
        found.append(
            Problem(
                "model.time_step",
                f"is {rules.time_step:g} s, in which grains of {speed:.2g} m/s pass over a cell of "
                f"{bed.lattice.cell_size:g} m; allowed: up to {bed.lattice.cell_size / speed:.2g} s",
            )
        )
    return found


def _greatest_speed(rules: GrainFlight, fastest: float) -> float:
    """Speed (m/s) of the wind at the top of the highest first hop, or of lift-off if that is greater."""
    friction = rules.friction_velocity(rules.wind_speed)
    top = np.array(max(fastest**2 / (2.0 * rules.gravity), rules.roughness_length))
    return max(float(log_wind(top, friction, rules.roughness_length, rules.displacement)), fastest, 0.1)


def grains_in_flight(rules: GrainFlight, lattice: Lattice) -> float:
    """Number of grains of sand that a simulated grain stands for."""
    volume = lattice.cell_size**2 * lattice.thickness * rules.carried * (1.0 - rules.porosity)
    return volume / (math.pi / 6.0 * rules.diameter**3)


def facts(rules: GrainFlight, lattice: Lattice) -> dict[str, str]:
    """Parcels, settling and time, for people to read."""
    found = {
        "a grain in the air": f"stands for {grains_in_flight(rules, lattice):.4g} grains: "
        f"{lattice.thickness * rules.carried * 1e3:.3g} mm of sand with {rules.porosity:.0%} pores over "
        "a cell",
        "settling speed": ", ".join(f"{rules.settling_speed(one):.2f}" for one in rules.diameters) + " m/s",
    }
    canopy = rules.part(Canopy)
    if canopy is not None and canopy.stands:
        found["plants"] = canopy_facts(canopy, lattice)
    if rules.step_seconds is not None:
        found["step"] = f"{rules.step_seconds:g} s"
        if rules.step_seconds != rules.flight_seconds:
            found["step"] += f" of wind over the bed, {rules.flight_seconds:g} s of flight"
    return found


def wind_facts(rules: GrainFlight, speeds: Sequence[float]) -> dict[str, str]:
    """The friction velocities of winds (m/s at 10 m) and the threshold, for people to read."""
    least, most = (f"{rules.friction_velocity(speed):.3f}" for speed in (min(speeds), max(speeds)))
    friction = most if least == most else f"{least} to {most}"
    return {"friction velocity": f"{friction} m/s, threshold {rules.threshold():.3f} m/s"}


def usual_hop(rules: GrainFlight) -> float:
    """Length (m) of a hop of a grain that the wind lifts at the mean speed of lift-off, roughly.

    It rises and falls without drag, and downwind it is half as fast as the wind at its top. A wind below the
    threshold counts as one at it.
    """
    lifts = rules.part(Entrainment)
    factor = 1.0 if lifts is None else (lifts.min_lift_speed + lifts.max_lift_speed) / 2.0
    friction = max(rules.friction_velocity(rules.wind_speed), rules.threshold())
    upward = factor * friction
    top = np.array(max(upward**2 / (2.0 * rules.gravity), rules.roughness_length))
    wind = float(log_wind(top, friction, rules.roughness_length, rules.displacement))
    return max(wind, 0.0) / 2.0 * 2.0 * upward / rules.gravity


def remarks(rules: GrainFlight, lattice: Lattice) -> list[str]:
    """Remarks on these parameters on this lattice."""
    found = []
    hop = usual_hop(rules)
    if lattice.cell_size > hop:
        found.append(
            f"cells of {lattice.cell_size:g} m are wider than a hop of about {hop:.1g} m: most grains land "
            f"where they started, and ripples, some {RIPPLES} apart, are narrower than a cell; these rules "
            "need cells of millimetres to a few centimetres (lattice.cell_size)"
        )
    heights = rules.carried * lattice.thickness / rules.diameter
    if not (_THIN if rules.carried == 1 else 0.0) <= heights <= _THICK:
        parcels = f"{rules.carried} parcels are" if rules.carried > 1 else "a parcel is"
        found.append(
            f"{parcels} {heights:.3g} grain diameters high; the sources lift and lay down one "
            f"(lattice.slab_height {rules.diameter / rules.carried:g})"
        )
    return found
