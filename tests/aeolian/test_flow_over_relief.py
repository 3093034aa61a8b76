"""The wind over a bed of waves: its slope, its speed, its stress on the bed."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import barchan
from barchan.aeolian.flow_over_relief import LinearFlow, stress_coefficients, wind_over_relief
from barchan.lattice import Lattice
from barchan.models import model
from barchan.simulation import Simulation
from barchan.streams import Stream
from barchan.wind.segment import Segment

WIDTH, HEIGHT = 0.005, 0.01
ROUGHNESS = 5e-6


def lattice(boundary="periodic", rows=24, columns=64):
    return Lattice(
        rows=rows,
        columns=columns,
        cell_size=WIDTH,
        slab_height=1e-4,
        boundary_x=boundary,
        boundary_y=boundary,
    )


def streamlines(bed, field, direction, height):
    waves = LinearFlow(bed, field, direction)
    return waves.slope(height), waves.speedup(height), waves.crosswind(height)


@pytest.mark.parametrize("waves", [1, 4, 12])
def test_streamlines_follow_a_wave_as_in_frictionless_flow(waves):
    field = lattice()
    number = 2 * np.pi * waves / (64 * WIDTH)
    bed = np.tile(1e-3 * np.sin(number * np.arange(64) * WIDTH), (24, 1))
    middles = (np.arange(64) + 0.5) * WIDTH
    weak = 1e-3 * np.exp(-number * HEIGHT)
    rise = weak * 2 / WIDTH * np.sin(number * WIDTH / 2) * np.cos(number * middles)
    speedup = weak * number * np.cos(number * WIDTH / 2) * np.sin(number * middles)
    slope, faster, aside = streamlines(bed, field, 270.0, HEIGHT)
    np.testing.assert_allclose(aside, 0.0, atol=1e-15)
    np.testing.assert_allclose(slope, np.tile(rise, (24, 1)), atol=1e-12)
    np.testing.assert_allclose(faster, np.tile(speedup, (24, 1)), atol=1e-12)
    back = streamlines(bed, field, 90.0, HEIGHT)
    np.testing.assert_allclose(back[0], -slope, atol=1e-15)
    np.testing.assert_allclose(back[1], faster, atol=1e-15)
    slope, faster, aside = streamlines(bed, field, 180.0, HEIGHT)
    np.testing.assert_allclose(aside, 0.0, atol=1e-15)
    np.testing.assert_allclose(slope, 0.0, atol=1e-15)
    np.testing.assert_allclose(faster, 0.0, atol=1e-15)


def test_the_wind_turns_across_oblique_crests():
    field = lattice(rows=64)
    number = 2 * np.pi / (64 * WIDTH)
    x, y = np.meshgrid(np.arange(64) * WIDTH, np.arange(64) * WIDTH)
    bed = 1e-3 * np.sin(number * (x + y))
    _, faster, aside = streamlines(bed, field, 270.0, HEIGHT)
    np.testing.assert_allclose(aside, faster, atol=1e-12)
    np.testing.assert_allclose(streamlines(bed, field, 180.0, HEIGHT)[2], -aside, atol=1e-12)


@settings(max_examples=20, deadline=None)
@given(st.integers(0, 2**32), st.sampled_from([0.0, 90.0, 213.0]), st.integers(0, 23), st.integers(0, 63))
def test_the_origin_of_a_joined_field_does_not_matter(seed, direction, rows, columns):
    field = lattice()
    bed = np.random.default_rng(seed).normal(0.0, 1e-3, field.shape)
    moved = streamlines(np.roll(bed, (rows, columns), (0, 1)), field, direction, HEIGHT)
    for found, one in zip(streamlines(bed, field, direction, HEIGHT), moved, strict=True):
        np.testing.assert_allclose(one, np.roll(found, (rows, columns), (0, 1)), atol=1e-12)


@settings(max_examples=20, deadline=None)
@given(st.integers(0, 2**32), st.sampled_from([0.0, 40.0, 213.0]), st.sampled_from(["periodic", "open"]))
def test_a_bed_and_a_wind_turned_together_have_the_same_streamlines(seed, direction, boundary):
    field = lattice(boundary, rows=40, columns=40)
    bed = np.random.default_rng(seed).normal(0.0, 1e-3, field.shape)
    turned = streamlines(bed.T.copy(), field, (270.0 - direction + 180.0) % 360.0, HEIGHT)
    mirrored = (*turned[:2], -turned[2])
    for found, one in zip(streamlines(bed, field, direction, HEIGHT), mirrored, strict=True):
        np.testing.assert_allclose(one.T, found, atol=1e-12)


def test_a_wind_does_not_feel_the_other_side_over_open_edges():
    field = lattice("open")
    bed = np.zeros(field.shape)
    bed[:, :4] = 0.01
    slope, faster, _ = streamlines(bed, field, 270.0, HEIGHT)
    assert slope[:, 3].max() < -0.05
    assert np.abs(slope[:, -16:]).max() < 1e-2 * np.abs(slope).max()
    assert np.abs(faster[:, -16:]).max() < 0.1 * np.abs(faster).max()
    assert (slope[:, -1] == 0.0).all()


def test_the_wind_blows_level_and_uniformly_over_a_flat_bed():
    slope, faster, _ = streamlines(np.full((24, 64), 0.3), lattice(), 300.0, HEIGHT)
    assert (slope == 0.0).all()
    assert (faster == 0.0).all()


def test_the_wind_over_waves_is_bounded_where_ground_is_steep():
    field = lattice()
    bed = np.zeros(field.shape)
    bed[8:16, 24:40] = 0.2
    wind = wind_over_relief(bed, field, 270.0, HEIGHT, 2.0, (4.0, 2.0), ROUGHNESS)
    assert (wind.streamline_slope.min(), wind.streamline_slope.max()) == (-0.3, 0.3)
    assert (wind.speedup.min(), wind.speedup.max()) == (0.1, 2.0)
    assert (wind.crosswind_ratio.min(), wind.crosswind_ratio.max()) == (-0.3, 0.3)
    assert (wind.stress.min(), wind.stress.max()) == (pytest.approx(0.01), 4.0)
    assert (np.abs(wind.crosswind_stress) <= wind.stress).all()
    low, (rise, faster, _) = 1e-3 * bed, streamlines(1e-3 * bed, field, 270.0, HEIGHT)
    wind = wind_over_relief(low, field, 270.0, HEIGHT, 2.0, (4.0, 0.0), ROUGHNESS)
    np.testing.assert_array_equal(wind.streamline_slope, rise)
    np.testing.assert_array_equal(wind.speedup, 1.0 + 2.0 * faster)


@pytest.mark.parametrize("direction", [270.0, 90.0])
def test_stress_is_highest_ahead_of_crests(direction):
    field = lattice()
    number = 2 * np.pi * 4 / (64 * WIDTH)
    x = np.arange(64) * WIDTH
    bed = np.tile(1e-3 * np.cos(number * x), (24, 1))
    toward = 1.0 if direction == 270.0 else -1.0
    expected = 1.0 + 1e-3 * number * (4.0 * np.cos(number * x) - toward * 2.0 * np.sin(number * x))
    wind = wind_over_relief(bed, field, direction, None, 0.0, (4.0, 2.0), ROUGHNESS)
    np.testing.assert_allclose(wind.stress, np.tile(expected, (24, 1)), atol=1e-12)
    assert (wind.streamline_slope, wind.speedup, wind.crosswind_ratio) == (None, None, None)
    along = wind_over_relief(bed, field, 180.0, None, 0.0, (4.0, 2.0), ROUGHNESS)
    np.testing.assert_allclose(along.stress, 1.0, atol=1e-12)


@pytest.mark.parametrize("waves", [1, 4, 12])
def test_stress_follows_from_the_wavelength_over_the_roughness(waves):
    field = lattice()
    number = 2 * np.pi * waves / (64 * WIDTH)
    x = np.arange(64) * WIDTH
    bed = np.tile(1e-4 * np.cos(number * x), (24, 1))
    a, b = stress_coefficients(2 * np.pi / (number * ROUGHNESS))
    expected = 1.0 + 1e-4 * number * (a * np.cos(number * x) - b * np.sin(number * x))
    wind = wind_over_relief(bed, field, 270.0, None, 0.0, (None, None), ROUGHNESS)
    np.testing.assert_allclose(wind.stress, np.tile(expected, (24, 1)), atol=1e-12)


def test_stress_turns_across_oblique_crests():
    field = lattice(rows=64)
    number = 2 * np.pi / (64 * WIDTH)
    x, y = np.meshgrid(np.arange(64) * WIDTH, np.arange(64) * WIDTH)
    bed = 1e-3 * np.sin(number * (x + y))
    wind = wind_over_relief(bed, field, 270.0, None, 0.0, (4.0, 2.0), ROUGHNESS)
    np.testing.assert_allclose(wind.crosswind_stress, wind.stress - 1.0, atol=1e-12)


def test_a_wind_that_is_not_to_differ_does_not():
    assert (
        wind_over_relief(np.zeros((24, 64)), lattice(), 270.0, None, 2.0, (0.0, 0.0), ROUGHNESS)
        == (None,) * 5
    )
    calm = wind_over_relief(np.zeros((24, 64)), lattice(), 270.0, HEIGHT, 0.0, (0.0, 0.0), ROUGHNESS)
    assert (calm.speedup, calm.crosswind_ratio, calm.stress) == (None, None, None)


@pytest.mark.extended
def test_dust_goes_along_the_streamlines():
    ripples = model("ripples")
    scenario = barchan.load("ripples", lattice__rows=8, lattice__columns=64, run__seed=1)
    bed = Simulation(scenario).bed
    waves = np.arange(64) * 2 * np.pi / 64
    bed.sand[...] += np.rint(2e-3 / bed.lattice.thickness * np.sin(waves)).astype(np.int32)
    rules = ripples.Parameters(
        grain_diameter=5e-5, grain_density=100, time_step=1e-4, wind_speed=10.0, feedback={"length": None}
    )
    wind = Segment(0, 1, 0, bed.lattice.cells, 270.0)
    paths = ripples(rules, bed.lattice).paths(bed, wind, Stream(1, "paths"), 5, longest=0.3)
    slope = LinearFlow(bed.elevation, bed.lattice, 270.0).slope(0.01)
    path = max(paths, key=len)[100:-200]
    column = (path[:, 0] / WIDTH - 0.5).astype(int) % 64
    ways = np.corrcoef(path[:, 5] / path[:, 3], slope[4, column])
    assert len(path) > 300
    assert ways[0, 1] > 0.95
