"""How far impacts push grains, and what the wind along the bed does to them."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import barchan
from barchan.aeolian.flow_over_relief import ReliefWind
from barchan.grains.bed import GrainGround
from barchan.grains.canopy import PlantRoughness
from barchan.grains.creep import Creep
from barchan.grains.pool import work_space
from barchan.grains.rules import rules_of
from barchan.kernels.core.state import TRAVEL_UNIT
from barchan.kernels.grains import creep as grain_creep
from barchan.kernels.grains.creep import FARTHEST
from barchan.kernels.grains.state import MOVED, TRAVEL_X, TRAVEL_Y
from barchan.simulation import Simulation
from barchan.streams import derive
from tests.kernels.called import from_python

displacement, push = from_python(grain_creep.displacement), from_python(grain_creep.push)

pytestmark = pytest.mark.extended
"""Pushes alone are a kernel of their own, which no model runs."""

DIAMETER, WIDTH = 0.15e-3, 0.005


def field(**rules):
    """A level field of 12 × 12 cells of fine parcels, and its ground in calm air."""
    scenario = {
        "barchan": 5,
        "lattice": {"rows": 12, "columns": 12, "cell_size": WIDTH, "slab_height": DIAMETER / 16},
        "sand": {"kind": "flat", "mean": 2000},
        "model": {"name": "ripples", "wind_speed": 12.0, "grain_diameter": DIAMETER, **rules},
        "run": {"steps": 1, "seed": 1},
    }
    made = Simulation(barchan.load(scenario))
    ground = GrainGround(made.model.parameters, made.bed, 270.0, work_space(1))
    ground.drag(np.array(0.0), ReliefWind())
    return made, ground


def push_from_the_middle(made, ground, velocity, count=2000):
    """Push sand by as many impacts on a cell; the grains moved and how far they came on average (cells)."""
    setting = made.model.setting(made.forcing.wind_of(0))
    creep, landings = rules_of(setting).splash.creep, ground.landings
    landings.x[0] = landings.y[0] = 6.0
    landings.u[0], landings.v[0] = velocity
    landings.impact_speed[0] = math.hypot(*velocity)
    before = ground.arrays.sand.copy(), ground.arrays.level.copy(), ground.arrays.height.copy()
    for number in range(count):
        landings.start[0] = derive(5, number)
        push(creep, 0, 6, 6, ground.arrays, landings, ground.counts)
        for whole, part in zip(
            (ground.arrays.sand, ground.arrays.level, ground.arrays.height), before, strict=True
        ):
            whole[...] = part
    moved = int(ground.counts[MOVED])
    way = [int(ground.counts[at]) / TRAVEL_UNIT for at in (TRAVEL_X, TRAVEL_Y)]
    return moved, [one / max(moved, 1) for one in way], creep


def test_pushes_take_their_share_of_momentum_and_stop_by_friction():
    made, ground = field()
    ground.arrays.shelter_surface[:] += 1.0
    moved, way, creep = push_from_the_middle(made, ground, (3.0, 0.0))
    rules = made.model.parameters
    closure = rules.part(Creep)
    start = closure.speed * math.sqrt(rules.gravity * DIAMETER)
    assert creep.number[0] * start == pytest.approx(closure.momentum)
    step = start**2 / (2.0 * rules.gravity * math.tan(math.radians(rules.repose_angle)))
    expected = 2000 * closure.momentum * 3.0 / start * step / WIDTH
    assert moved == pytest.approx(expected, rel=0.1)
    assert way == pytest.approx([1.0, 0.0])


def test_no_grain_goes_on_for_ever():
    made, ground = field()
    ground.drag(np.array(0.5), ReliefWind())
    _, way, _ = push_from_the_middle(made, ground, (0.2, 0.0))
    assert way == pytest.approx([float(FARTHEST), 0.0])


def test_a_wind_below_the_impact_threshold_helps_grains_along():
    made, ground = field()
    found = []
    for friction in (0.0, 0.12, 0.18):
        ground.drag(np.array(friction), ReliefWind())
        ground.counts[:] = 0
        moved, way, creep = push_from_the_middle(made, ground, (2.0, 0.0))
        assert way == pytest.approx([1.0, 0.0])
        found.append(moved)
    eased = [1.0 / (1.0 - (friction / creep.threshold[0]) ** 2) for friction in (0.0, 0.12, 0.18)]
    assert np.array(found) / found[0] == pytest.approx(np.array(eased), rel=0.1)


def test_grains_go_on_over_crests_until_the_wind_is_too_weak():
    made, ground = field()
    stress = np.ones(made.lattice.shape)
    stress[:, 5:9] = 2.0
    ground.drag(np.array(0.19), ReliefWind(stress=stress))
    _, way, _ = push_from_the_middle(made, ground, (0.2, 0.0))
    assert way == pytest.approx([3.0, 0.0])


def test_nothing_moves_on_through_plants():
    made, ground = field()
    lift = np.zeros(made.lattice.shape, np.float32)
    lift[:, 7:] = 0.01
    ground.plants = PlantRoughness(lift.reshape(-1), np.zeros(made.lattice.cells))
    ground.drag(np.array(0.3), ReliefWind())
    _, way, _ = push_from_the_middle(made, ground, (0.2, 0.0))
    assert way == pytest.approx([1.0, 0.0])


def test_the_wind_over_oblique_crests_turns_grains_aside():
    made, ground = field()
    one = np.ones(made.lattice.shape)
    ground.drag(np.array(0.3), ReliefWind(stress=one, crosswind_stress=0.5 * one))
    _, way, _ = push_from_the_middle(made, ground, (0.2, 0.0))
    assert way[0] == pytest.approx(float(FARTHEST))
    assert way[1] == pytest.approx(0.5 * FARTHEST, rel=0.1)


FORCES = st.floats(-0.6, 0.6)


@given(st.floats(-math.pi, math.pi), FORCES, FORCES, FORCES, FORCES, st.floats(1e-3, 0.5))
def test_a_push_goes_as_far_as_energy_takes_it_and_turns_to_where_it_is_forced(
    angle, east, north, help_x, help_y, reach
):
    x, y = math.cos(angle), math.sin(angle)
    way_x, way_y = displacement((x, y), (east, north), 0.67, help_x, help_y, reach)
    along, aside = way_x * x + way_y * y, way_y * x - way_x * y
    force_x, force_y = help_x - east, help_y - north
    stopping = 0.67 - (force_x * x + force_y * y)
    assert along == pytest.approx(reach / stopping if stopping > reach else 1.0, rel=1e-6)
    assert aside * (force_y * x - force_x * y) >= -1e-9
    assert math.hypot(*displacement((x, y), (0.0, 0.0), 0.67, 0.0, 0.0, reach)) == pytest.approx(
        min(reach / 0.67, 1.0)
    )


def test_without_momentum_there_is_no_creep():
    made, ground = field(creep={"momentum": 0.0})
    ground.drag(np.array(0.5), ReliefWind())
    moved, _, _ = push_from_the_middle(made, ground, (2.0, 0.0))
    assert moved == 0
