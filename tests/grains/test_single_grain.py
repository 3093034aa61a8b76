"""One grain in the air against an independent solution of its equation of motion."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from barchan.bed import Bed
from barchan.lattice import Lattice
from barchan.models import model
from barchan.streams import Stream
from barchan.wind.segment import Segment
from tests.kernels.called import from_python

LATTICE = Lattice(rows=16, columns=64, cell_size=0.02, slab_height=0.15e-3)
WIND = Segment(0, 1, 0, LATTICE.cells, 270.0)


def first_hop(path):
    """Length, apex and impact angle of a path's first hop, the touch-down interpolated."""
    first = path[path[:, 6] == 0]
    x, z, u, w = first[:, 0] - first[0, 0], first[:, 2] - first[0, 2], first[:, 3], first[:, 5]
    missing = z[-1] / -w[-1]
    up = np.flatnonzero(w > 0)[-1]
    apex = z[up] + w[up] ** 2 / (2 * 9.81)
    slowing = (w[-1] - w[-2], u[-1] - u[-2])
    part = missing / 1e-3
    angle = np.degrees(np.arctan2(-(w[-1] + slowing[0] * part), u[-1] + slowing[1] * part))
    return x[-1] + u[-1] * missing, apex, angle


def exact_hop(flight, velocity):
    """The same from an adaptive solver of eighth order with tight tolerances."""
    rules = flight.parameters
    friction = rules.friction_velocity(rules.wind_speed)

    def motion(_time, state):
        _x, z, u, w = state
        wind = float(flight.wind_profile(np.array(max(z, 1e-9)), friction))
        lag = np.array([wind - u, -w])
        rate = rules.drag_rate(np.array(np.hypot(*lag)))
        return [u, w, rate * lag[0], rate * lag[1] - 9.81]

    def lands(_time, state):
        return state[1]

    def tops(_time, state):
        return state[3]

    lands.terminal, lands.direction = True, -1
    tops.direction = -1
    start = [0.0, 1e-9, *velocity]
    found = solve_ivp(motion, (0, 5), start, "DOP853", rtol=1e-10, atol=1e-12, events=[lands, tops])
    x, _, u, w = found.y_events[0][0]
    return x, found.y_events[1][0][1], np.degrees(np.arctan2(-w, u))


@pytest.mark.parametrize("drag", ["constant", "reynolds"])
@pytest.mark.parametrize("wind_speed", [10.0, 15.0])
def test_hop_apex_and_impact_angle_are_exact_within_one_percent(drag, wind_speed):
    wang_hu = model("wang_hu")
    flight = wang_hu(wang_hu.Parameters(drag=drag, wind_speed=wind_speed), LATTICE)
    bed = Bed(LATTICE, np.zeros(LATTICE.shape), np.full(LATTICE.shape, 9))
    paths = flight.paths(bed, WIND, Stream(1, "paths"), 20)
    assert len(paths) == 20
    for path in paths:
        found, exact = first_hop(path), exact_hop(flight, path[0, [3, 5]])
        np.testing.assert_allclose(found, exact, rtol=0.01)


@pytest.mark.parametrize(("diameter", "published"), [(0.15e-3, 0.81), (0.25e-3, 1.49)])
def test_natural_drag_gives_the_settling_speed_of_sand(diameter, published):
    rules = model("wang_hu").Parameters(grain_diameter=diameter, drag="reynolds")
    assert rules.settling_speed() == pytest.approx(published, rel=0.05)


def test_the_published_drag_lets_fine_sand_fall_far_too_fast():
    assert model("wang_hu").Parameters().settling_speed() == pytest.approx(2.99, abs=0.01)


def test_a_falling_grain_reaches_its_settling_speed():
    """Straight from the kernels: still air, a long fall."""
    from barchan.grains.bed import GrainGround
    from barchan.grains.pool import free_slots, grains_in, work_space
    from barchan.grains.rules import rules_of
    from barchan.kernels.grains.flight import move
    from barchan.kernels.grains.landing import land

    wang_hu = model("wang_hu")
    flight = wang_hu(wang_hu.Parameters(drag="reynolds", wind_speed=0.0), LATTICE)
    ground = GrainGround(
        flight.parameters, Bed(LATTICE, np.zeros(LATTICE.shape), np.ones(LATTICE.shape)), work=work_space(1)
    )
    grains = grains_in(*free_slots(1), None)
    grains.z[0], grains.status[0] = 100.0, 1
    about, landings = (flight.blow(ground, WIND), ground.arrays), ground.landings
    rules = rules_of(flight.setting(WIND))
    handle = from_python(land)
    for _ in range(2000):
        count = move(0, 1, grains, *about, landings.candidates)
        handle(0, count, np.uint64(1), grains, *about, rules, landings)
    assert -grains.w[0] == pytest.approx(flight.parameters.settling_speed(), rel=0.01)
