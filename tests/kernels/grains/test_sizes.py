"""Flight, splash and creep by size in compiled code against the slow and obvious way."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numba import njit

import barchan
from barchan.aeolian.flow_over_relief import ReliefWind
from barchan.bed import Bed
from barchan.grains.air import air_of, drag_table
from barchan.grains.bed import GrainGround
from barchan.grains.pool import free_slots, grains_in, work_space
from barchan.grains.rules import rules_of
from barchan.grains.splash import splash_by_size
from barchan.kernels.grains import creep as grain_creep
from barchan.kernels.grains import entries as grain_entries
from barchan.kernels.grains import splash as grain_splash
from barchan.kernels.grains.flight import move
from barchan.kernels.grains.rules import Rules
from barchan.kernels.grains.state import LEFT, MOVED, Scene
from barchan.kernels.grains.territories import ALONE, territories_of
from barchan.simulation import Simulation
from barchan.streams import Stream, derive
from tests.kernels.bed.active_layer_reference import Stacks
from tests.kernels.called import from_python
from tests.kernels.grains.grain_reference import draw

SIZES = [
    {"diameter": 0.15e-3, "share": 0.5},
    {"diameter": 0.4e-3, "share": 0.3},
    {"diameter": 1.2e-3, "share": 0.2},
]
"""The last one creeps."""

SCENARIO = {
    "barchan": 5,
    "lattice": {"rows": 6, "columns": 8, "cell_size": 0.005, "slab_height": 0.15e-3},
    "sand": {"kind": "flat", "mean": 7},
    "model": {
        "name": "ripples",
        "wind_speed": 12.0,
        "footprint": "stack",
        "sizes": {"classes": SIZES, "active_layer": 0.5},
    },
    "run": {"steps": 10, "seed": 3},
}


def simulation():
    return Simulation(barchan.load(SCENARIO))


def test_grains_of_each_size_fly_as_if_there_were_no_others():
    made = simulation()
    model, wind = made.model, made.forcing.wind_of(0)
    ground = GrainGround(model.parameters, made.bed, 270.0, work_space(300))
    random = np.random.default_rng(1)
    motion, counters = free_slots(300)
    motion[:2] = random.uniform(1.5, 4.0, (2, 300))
    motion[2] = random.uniform(0.003, 0.05, 300)
    motion[3:6] = random.uniform(-1.0, 2.0, (3, 300))
    kinds = random.integers(0, 3, 300).astype(np.int32)
    air, alone = air_of(model.setting(wind), None, drag_table(model.parameters)), motion.copy()
    for _ in range(5):
        move(0, 300, grains_in(motion, counters, kinds), air, ground.arrays, ground.landings.candidates)
    size = air.drag.values.size // 3
    for kind in range(3):
        own = air.drag._replace(values=air.drag.values[kind * size : (kind + 1) * size])
        apart = alone.copy()
        for _ in range(5):
            grains = grains_in(apart, counters, None)
            move(0, 300, grains, air._replace(drag=own), ground.arrays, ground.landings.candidates)
        np.testing.assert_array_equal(motion[:, kinds == kind], apart[:, kinds == kind])


def impacts(ground, count, seed):
    """Entries of as many impacts, each followed by free slots, and a slot for each."""
    random = np.random.default_rng(seed)
    events = ground.landings
    for k in range(count):
        events.slot[k], events.deposit_cell[k], events.lift_cell[k] = k, -1, -1
        events.impact_speed[k] = random.uniform(0.1, 6.0) if k % 4 == 0 else 0.0
        events.x[k], events.y[k] = random.uniform(0.0, 7.4), random.uniform(0.0, 5.4)
        events.u[k], events.v[k] = random.uniform(0.1, 4.0), random.uniform(-1.0, 1.0)
        events.start[k] = derive(seed, k)
        events.size_class[k] = random.integers(0, 3)
    return events


class ObviousSplash:
    """Ejecta and creep by size over single stacks, parcel by parcel."""

    def __init__(self, rule, ground, shape, wind):
        layer = ground.arrays.active_layer
        self.near, self.stress, self.side_stress = wind
        layers, deeps = (
            [np.repeat(range(3), counts[:, cell]).tolist() for cell in range(counts.shape[1])]
            for counts in (layer.surface, layer.substrate)
        )
        self.stacks = Stacks(layers, deeps, layer.capacity, int(layer.rng_state[0]))
        self.rule, self.ground, self.shape, self.thrown, self.gone = rule, ground, shape, [], 0

    def hit(self, k, events, slopes):
        row, col = (math.floor(float(place) + 0.5) for place in (events.y[k], events.x[k]))
        cell, start, by = row * self.shape[1] + col, int(events.start[k]), int(events.size_class[k])
        layer, number = self.stacks.layers[cell], self.rule.by_size.number[by]
        plenty = sum(float(number[s]) * layer.count(s) for s in range(3)) / len(layer) if layer else 0.0
        count = self.rule.number * float(events.impact_speed[k]) * plenty + draw(start, 20)
        for one in range(min(int(count), 8)):
            weights = [float(number[s]) * layer.count(s) for s in range(3)]
            rest = draw(start, 60 + one) * (sum(weights) / len(layer) if layer else 0.0) * len(layer)
            found = None
            for size, weight in enumerate(weights):
                if weight > 0.0 and rest >= 0.0:
                    found, rest = size, rest - weight
            if found is not None:
                self.stacks.take(cell, found, 1)
                self.thrown.append(found)
        self.creep(k, cell, events, slopes())

    def wind_along(self, cell):
        arrays, scale = self.ground.arrays, self.ground.arrays.scale
        parcels = len(self.stacks.layers[cell]) + len(self.stacks.deeps[cell])
        calm = (
            arrays.shelter_surface[cell]
            > np.float32(parcels * scale.parcel * scale.part) + self.rule.creep.shelter
        )
        return 0.0 if calm else float(self.near[cell]) * math.sqrt(self.stress[cell])

    def stress_toward(self, cell):
        rule = self.rule.creep
        left = float(self.side_stress[cell]) / float(self.stress[cell])
        return rule.wind_x - left * rule.wind_y, rule.wind_y + left * rule.wind_x

    def creep(self, k, cell, events, slopes):
        rule, start, layer = self.rule.creep, int(events.start[k]), self.stacks.layers[cell]
        length = math.sqrt(events.u[k] * events.u[k] + events.v[k] * events.v[k])
        toward = events.u[k] / length, events.v[k] / length
        wind = self.wind_along(cell)
        for size in range(3):
            helped = min(wind / rule.threshold[size], 1.0)
            helped = rule.friction * helped * helped
            force = [
                helped * part - slope for part, slope in zip(self.stress_toward(cell), slopes, strict=True)
            ]
            along = toward[0] * force[0] + toward[1] * force[1]
            stopping = max(rule.friction - along, rule.reach[size])
            way = [
                rule.reach[size] / stopping * (part + (one - along * part) / stopping)
                for part, one in zip(toward, force, strict=True)
            ]
            longest = min(max(abs(part) for part in way), 1.0)
            share = layer.count(size) / len(layer) if layer else 0.0
            at = 80 + 64 * size
            number = rule.number[size] * events.impact_speed[k] * share * longest + draw(start, at)
            for one in range(min(int(number), 16)):
                steps = whole_steps(way, longest, start, at + 1 + 2 * one)
                if any(steps) and layer.count(size):
                    self.move(cell, size, *steps, start, at + 1 + 2 * one)

    def move(self, cell, size, east, north, start, at):
        self.stacks.take(cell, size, 1)
        row, col = divmod(cell, self.shape[1])
        for step in range(1, 17):
            row, col = row + north, col + east
            if not (0 <= row < self.shape[0] and 0 <= col < self.shape[1]):
                self.gone += 1
                return
            here = row * self.shape[1] + col
            if self.wind_along(here) <= self.rule.creep.threshold[size]:
                break
            way = self.stress_toward(here)
            east, north = whole_steps(way, max(abs(part) for part in way), start, at + 1024 * step)
        self.stacks.put(row * self.shape[1] + col, size, 1)


def whole_steps(way, longest, start, at):
    """A step of one cell or none along each axis, as likely as the way is long."""
    return [
        int(math.copysign(draw(start, at + axis) < abs(part / longest), part))
        for axis, part in enumerate(way)
    ]


@pytest.mark.extended
@settings(max_examples=20, deadline=None)
@given(st.integers(0, 2**32))
def test_splash_by_size_equals_the_obvious_one(seed):
    data = {**SCENARIO, "lattice": {**SCENARIO["lattice"], "boundary_x": "open", "boundary_y": "open"}}
    made = Simulation(barchan.load(data))
    model, wind, bed = made.model, made.forcing.wind_of(0), made.bed
    bed.sand[...] = np.random.default_rng(seed).integers(0, 14, bed.sand.shape)
    count = 80
    ground = GrainGround(
        model.parameters, bed, 270.0, work_space(count, True), model.sized_sand.active_layer(bed)
    )
    ground.reseed(seed)
    events, rule = impacts(ground, count, seed), rules_of(model.setting(wind)).splash
    random = np.random.default_rng(seed)
    near, stress = random.uniform(0.1, 0.6, bed.sand.shape), random.uniform(0.1, 4.0, bed.sand.shape)
    aside = stress * random.uniform(-1, 1, stress.shape)
    ground.slow(near)
    ground.drag(near, ReliefWind(stress=stress, crosswind_stress=aside))
    ground.raise_shelter()
    wind_by_cell = [part.reshape(-1).astype(np.float32) for part in (near, stress, aside)]
    slow = ObviousSplash(rule, ground, bed.lattice.shape, wind_by_cell)
    copies = [None if entries is None else entries.copy() for entries in events]
    motion, counters = free_slots(count)
    grains = grains_in(motion, counters, np.zeros(count, np.int32))
    for k in range(0, count, 4):
        # one at a time: the slopes that creep sees are those after the ejecta of the same impact
        for entries, copy in zip(events, copies, strict=True):
            if entries is not None:
                entries[...] = copy
        events.impact_speed[...] = 0.0
        events.impact_speed[k] = copies[type(events)._fields.index("impact_speed")][k]
        eject(count, grains, ground, rule)
        slow.hit(k, events, lambda k=k: slopes_before_creep(slow, made, events, k))
        surface, deep = slow.stacks.counts(3)
        np.testing.assert_array_equal(ground.arrays.active_layer.surface, surface)
        np.testing.assert_array_equal(ground.arrays.active_layer.substrate, deep)
    assert int(counters[0].sum()) == len(slow.thrown)
    np.testing.assert_array_equal(grains.size_class[counters[0] > 0], slow.thrown)
    assert ground.counts[LEFT] == slow.gone
    assert ground.counts[MOVED] >= len(slow.thrown)
    heights = ground.arrays.active_layer.surface.sum(0) + ground.arrays.active_layer.substrate.sum(0)
    np.testing.assert_array_equal(bed.sand.ravel(), heights)


def slopes_before_creep(slow, made, events, k):
    """Slopes of the surface over the stacks as they are in the lists."""
    from barchan.kernels.grains.surface import surface_at

    sand = np.array([len(a) + len(b) for a, b in zip(slow.stacks.layers, slow.stacks.deeps, strict=True)])
    bed = Bed(made.lattice, made.bed.ground, sand.reshape(made.lattice.shape))
    ground = GrainGround(made.model.parameters, bed)
    return from_python(surface_at)(events.x[k], events.y[k], ground.arrays)[1:]


@njit
def splash(found, scene, territories):
    """Take and launch the ejecta of a piece's entries, and push sand."""
    grains, landings, ejecta = scene.grains, scene.landings, scene.ejecta
    rule, hits = scene.rules.splash, grain_entries.list_impacts(found, found[0], landings, ejecta)
    number = grain_entries.exchange(ALONE, np.int32(1), found, found[0], hits, rule, scene, territories)
    number = grain_entries.launch_from_free(
        found, found[0], number, scene.grains, scene.landings, scene.ejecta
    )
    grain_splash.throw(0, number, grains, rule, landings, ejecta)
    scene.counts[:] += territories.counts[-1, : scene.counts.size]
    territories.counts[:] = 0


def eject(count, grains, ground, rule):
    """Take and launch ejecta."""
    rules = Rules(None, None, rule)
    scene = Scene(grains, None, ground.arrays, rules, ground.landings, ground.ejecta, ground.counts)
    splash(np.array([count]), scene, territories_of(ground.arrays.grid, 1, count, ground.counts.size))


def test_ejecta_and_speeds_scale_as_published():
    made = simulation()
    by_size = splash_by_size(made.model.setting(made.forcing.wind_of(0)))
    ratio = 0.4 / 0.15
    grains_in_a_parcel = ratio**-3
    assert by_size.number[0, 1] * grains_in_a_parcel == pytest.approx(1 / ratio)
    assert by_size.number[1, 0] / grains_in_a_parcel == pytest.approx(ratio)
    assert by_size.number[:, 2].tolist() == [0.0, 0.0, 0.0]
    momentum = by_size.number * by_size.speed
    assert momentum.max() == pytest.approx(1.0)
    assert by_size.speed.max() == 1.0


def test_the_draws_of_sizes_have_places_of_their_own():
    last = grain_splash.EJECTA_DRAWS + grain_splash.MOST_EJECTA * grain_splash.DRAWS_PER_EJECTUM
    assert last < grain_splash.CLASS_DRAWS
    assert grain_splash.CLASS_DRAWS + grain_splash.MOST_EJECTA < grain_creep.CREEP_DRAWS
    assert grain_creep.DRAWS_PER_SIZE >= 1 + 2 * grain_creep.MOST_PUSHES
    assert Stream(1, "sizes").key != Stream(1, "transport").key
