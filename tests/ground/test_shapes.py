"""Shapes of initial sand: waves, heaps, hills, levels and uneven supply."""

from typing import get_args

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from barchan.errors import ScenarioError
from barchan.ground.heaps import Block, Cone, Mound, Patch
from barchan.ground.landforms import FlatGround
from barchan.ground.layer import Part
from barchan.ground.rocks import ThreeRocks
from barchan.ground.sand import DroppedSand, FileSand, FlatSand, LevelSand, NoisySand, RandomSand, Sand
from barchan.ground.start import first_bed
from barchan.ground.waves import RippledSand, TransverseSand, Waves
from barchan.lattice import Lattice
from barchan.streams import Stream
from tests.scenario.strategies import group

LATTICE = Lattice(rows=60, columns=80, cell_size=2.0, slab_height=0.5)
LEVEL = np.zeros(LATTICE.shape)
STREAM = Stream(5, "initial surface")
KINDS = [kind for kind in get_args(get_args(Sand)[0]) if kind is not FileSand]
LAYERS = [FlatSand, RandomSand, DroppedSand, NoisySand, RippledSand, TransverseSand]


def laid(sand, lattice=LATTICE):
    return sand.slabs(lattice, np.zeros(lattice.shape), STREAM)


@settings(suppress_health_check=[HealthCheck.too_slow])
@given(st.sampled_from(KINDS).flatmap(lambda kind: st.tuples(st.just(kind), group(kind))))
def test_every_sand_lies_in_whole_slabs_none_below_zero_and_none_on_rocks(drawn):
    kind, values = drawn
    values = {name: min(v, 50) if name in ("mean", "height") else v for name, v in values.items()}
    values.pop("parts", None)
    if issubclass(kind, Waves):
        values["wavelength"] = 10.0
    ground = ThreeRocks()
    bed = first_bed(LATTICE, ground, kind.model_validate(values), 3)
    assert bed.sand.shape == LATTICE.shape
    assert bed.sand.min() >= 0
    assert bed.sand[ground.bare(LATTICE)].max() == 0


@pytest.mark.parametrize("kind", LAYERS)
@pytest.mark.parametrize("gradient", [-1.0, 0.4])
def test_a_gradient_tilts_the_supply_and_keeps_its_mean(kind, gradient):
    even, tilted = laid(kind(mean=60)), laid(kind(mean=60, gradient_x=gradient))
    assert tilted.mean() == pytest.approx(even.mean(), rel=0.01)
    halves = [tilted[:, :40].mean(), tilted[:, 40:].mean()]
    assert halves[1] - halves[0] == pytest.approx(60 * gradient, rel=0.1)


def test_a_gradient_to_the_north_leaves_columns_alike():
    slabs = laid(FlatSand(mean=60, gradient_y=0.5))
    assert (np.ptp(slabs, axis=1) == 0).all()
    assert slabs[-1, 0] - slabs[0, 0] == pytest.approx(60, abs=2)


def test_dropped_sand_keeps_its_exact_total_on_a_gradient():
    slabs = laid(DroppedSand(mean=2.5, gradient_x=1.0, gradient_y=-1.0))
    assert slabs.sum() == round(2.5 * LATTICE.cells)
    assert slabs[:30, 40:].sum() > 7 * slabs[30:, :40].sum()


def test_parts_keep_their_own_mean_on_a_gradient():
    slabs = laid(FlatSand(mean=20, gradient_x=1.0, parts=[Part(mean=7.0, north=0.5)]))
    assert set(slabs[:30].ravel()) == {7}


def test_ripples_are_as_long_and_as_high_as_stated():
    slabs = laid(RippledSand(mean=20, amplitude=3.0, wavelength=16.0))
    assert slabs.max() - 20 == 20 - slabs.min() == 6
    np.testing.assert_array_equal(slabs, np.roll(slabs, 8, axis=1))
    assert slabs.mean() == pytest.approx(20)


def test_waves_close_over_joined_edges():
    near, far = (laid(RippledSand(mean=20, amplitude=3.0, wavelength=length)) for length in (16.0, 16.3))
    np.testing.assert_array_equal(near, far)


@pytest.mark.parametrize(("direction", "axis"), [(270.0, 0), (90.0, 0), (180.0, 1), (0.0, 1)])
def test_crests_lie_across_their_wind(direction, axis):
    slabs = laid(TransverseSand(direction=direction, wavelength=30.0))
    assert (np.ptp(slabs, axis=axis) == 0).all()
    assert np.ptp(slabs) > 0


@pytest.mark.parametrize("direction", [270.0, 90.0])
def test_transverse_dunes_turn_their_long_side_to_the_wind(direction):
    profile = laid(TransverseSand(direction=direction, wavelength=40.0, height=10.0, mean=30))[0]
    down_the_wind = profile if direction == 270.0 else profile[::-1]
    steps = np.diff(down_the_wind)
    assert (steps > 0).sum() > 1.5 * (steps < 0).sum()


def test_a_wave_longer_than_the_field_is_refused():
    with pytest.raises(ScenarioError, match=r"sand\.wavelength: is 500 m; allowed: waves of which"):
        laid(RippledSand(wavelength=500.0))


def volume(slabs):
    return slabs.sum() * LATTICE.thickness * LATTICE.cell_size**2


def test_heaps_hold_the_sand_of_their_solids():
    assert volume(laid(Cone(height=12.0, radius=40.0))) == pytest.approx(np.pi * 40**2 * 12 / 3, rel=0.01)
    assert volume(laid(Mound(height=12.0, width=12.0))) == pytest.approx(2 * np.pi * 12**2 * 12, rel=0.02)
    assert volume(laid(Patch(height=2.0, radius=40.0))) == pytest.approx(np.pi * 40**2 * 2, rel=0.01)
    assert volume(laid(Block(height=4.0, length_x=40.0, length_y=20.0))) == pytest.approx(40 * 20 * 4)


def test_a_heap_lies_on_its_layer_where_it_is_stated():
    slabs = laid(Block(mean=3, height=4.0, length_x=8.0, length_y=4.0, x=0.25, y=0.75))
    rows, cols = np.nonzero(slabs > 3)
    assert (rows.min(), rows.max(), cols.min(), cols.max()) == (44, 45, 18, 21)
    assert set(slabs.ravel()) == {3, 11}


def test_sand_fills_hollows_up_to_a_level_and_leaves_higher_ground_bare():
    ground = np.linspace(-4.0, 4.0, LATTICE.cells).reshape(LATTICE.shape)
    slabs = LevelSand(level=1.0).slabs(LATTICE, ground, STREAM)
    surface = ground + slabs * LATTICE.thickness
    assert (np.abs(surface[ground < 1.0] - 1.0) <= LATTICE.thickness / 2 + 1e-12).all()
    assert (slabs[ground > 1.0 + LATTICE.thickness / 2] == 0).all()


def test_hills_of_sand_differ_from_seed_to_seed():
    one, other = (NoisySand().slabs(LATTICE, LEVEL, Stream(seed, "initial surface")) for seed in (1, 2))
    assert (one != other).any()


def test_more_sand_than_can_be_counted_is_refused():
    thin = Lattice(rows=8, columns=8, slab_aspect=1e-4)
    with pytest.raises(ScenarioError, match=r"sand: has stacks of up to \d+ slabs; allowed: up to 1000000"):
        first_bed(thin, FlatGround(), Block(height=1e4, length_x=9.0, length_y=9.0), 1)
