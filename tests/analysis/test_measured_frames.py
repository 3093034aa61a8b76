"""Frames are measured over whole cycles of the wind, across their crests, and say when not to be trusted."""

import math

import numpy as np
import pytest
import xarray as xr

from barchan.analysis.declared_measures import MEASURES
from barchan.analysis.time_series import last_values, measure_series, measured_frames
from tests.tiny import tiny

ROWS, COLUMNS = 64, 128
SEASONS = {
    "kind": "regimes",
    "regimes": [{"direction": 270.0, "steps": 10}, {"direction": 90.0, "steps": 10}],
}


def waves(moved=0.0, m=8, n=4, height=8.0):
    """Slabs of waves with so many periods over the width and the depth, moved east by so many cells."""
    north, east = np.mgrid[:ROWS, :COLUMNS]
    return 20.0 + height * np.sin(2 * np.pi * (m * (east - moved) / COLUMNS + n * north / ROWS))


def bedforms(moved=0.0):
    """Slabs of crests that are not straight, so that it shows which way they move, moved east."""
    return 20.0 + sum(waves(moved, *wave) - 20.0 for wave in ((8, 1), (6, -3), (5, 2))) / 2


def scenario_of(**changes):
    return tiny(lattice__rows=ROWS, lattice__columns=COLUMNS, **changes)


def run_of(scenario, slabs, steps, ground=None, directions=270.0):
    """A run whose frames are given, with slabs in whole numbers."""
    sand = np.rint(np.array(slabs)).astype(np.int32)
    ground = np.broadcast_to(np.zeros((ROWS, COLUMNS)) if ground is None else ground, sand.shape)
    fields = {"sand": sand, "ground": ground, "elevation": ground + sand * scenario.lattice.thickness}
    columns = {"wind_direction": np.broadcast_to(directions, len(steps)), "travel_x": np.zeros(len(steps))}
    columns["travel_y"] = columns["travel_x"]
    return xr.Dataset(
        {name: (("step", "y", "x"), values) for name, values in fields.items()}
        | {name: ("step", values) for name, values in columns.items()},
        {"step": np.array(steps)},
    )


def last(scenario, run, name, **options):
    """Value and doubt of a measure of the last frame."""
    (found,) = [value for value in last_values(run, scenario, **options) if value.measure.name == name]
    return found.value, found.doubt


@pytest.mark.parametrize("height", [0.0, 6.0])
def test_waves_that_move_a_cell_in_four_steps_do_so_between_rocks_too(height):
    """They go over level ground and over rocks, on which sand lies too."""
    ground = np.zeros((ROWS, COLUMNS))
    ground[10:20, 30:50] = ground[40:50, 80:90] = height
    scenario = scenario_of(ground={"kind": "three_rocks"})
    slabs = [np.roll(np.rint(bedforms()), k, axis=1) for k in range(6)]
    measured = measure_series(run_of(scenario, slabs, range(0, 24, 4), ground), scenario)
    assert math.isnan(measured["speed_cells"][0])
    np.testing.assert_allclose(measured["speed_cells"][1:], 0.25, atol=1e-9)


@pytest.mark.parametrize("net", [0.0, 1.0, -2.5])
def test_dunes_that_swing_in_place_do_not_migrate(net):
    """They go east by 5 cells in one season and back in the next, but for a net shift in each cycle."""
    steps = np.arange(0, 81, 5)
    swing = 5.0 * np.abs((steps / 10.0 + 1) % 2 - 1)
    scenario = scenario_of(wind=SEASONS)
    slabs = [bedforms(net * step / 20 + s) for step, s in zip(steps, swing, strict=True)]
    run = run_of(scenario, slabs, steps)
    frames = list(measured_frames(run, scenario))
    for frame, step in zip(frames, steps, strict=True):
        if step < 20:
            assert math.isnan(frame.migration.x)
        else:
            assert frame.migration.x == pytest.approx(net / 20, abs=0.003)
    assert "whole cycles of the wind (20 steps)" in frames[2].standing


def test_a_net_shift_longer_than_the_spacing_is_followed_through_the_cycle():
    """Waves that stand 16 cells and more apart go 20 cells in a cycle."""
    steps = np.arange(0, 61, 2)
    scenario = scenario_of(wind=SEASONS)
    run = run_of(scenario, [bedforms(step * 1.0) for step in steps], steps)
    (frame,) = measured_frames(run, scenario, len(steps) - 1)
    assert (frame.migration.x, frame.migration.y) == pytest.approx((1.0, 0.0), abs=0.02)


def test_frames_that_never_fall_on_whole_cycles_have_no_migration():
    scenario = scenario_of(wind=SEASONS)
    steps = [0, 13, 27, 46, 55]
    value, doubt = last(scenario, run_of(scenario, [bedforms(k) for k in range(5)], steps), "speed")
    assert math.isnan(value)
    assert doubt == "no frame is whole cycles of the wind (20 steps) earlier"


def test_surfaces_that_are_not_alike_have_no_migration_and_say_so():
    scenario, random = scenario_of(), np.random.default_rng(5)
    run = run_of(scenario, [random.integers(0, 30, (ROWS, COLUMNS)) for _ in range(3)], [0, 5, 10])
    value, doubt = last(scenario, run, "speed")
    assert math.isnan(value)
    assert doubt.startswith("correlation 0.")
    assert doubt.endswith("is below 0.5: not the same bedforms")


@pytest.mark.parametrize("wind", ["resultant", "last"])
def test_spacing_is_across_the_crests_whatever_the_wind(wind):
    """8 periods over 128 cells and 4 over 64: crests every 16 cells in x and y, so 16 / sqrt(2) apart."""
    scenario = scenario_of(wind=SEASONS)
    run = run_of(scenario, [waves()], [0], directions=250.0)
    value, doubt = last(scenario, run, "spacing", wind=wind)
    assert value == pytest.approx(16 / math.sqrt(2), rel=0.01)
    assert doubt == ""


def test_the_resultant_wind_tells_windward_from_lee_where_winds_come_in_turn():
    """Two thirds of the sand go east: windward sides face west, though the last wind was from the east."""
    wind = {
        "kind": "regimes",
        "regimes": [{"direction": 270.0, "steps": 20}, {"direction": 90.0, "steps": 10}],
    }
    scenario = scenario_of(wind=wind)
    profile = np.tile(np.concatenate([np.arange(24) / 24, np.arange(8, 0, -1) / 8]) * 15, 4)
    run = run_of(scenario, [np.tile(profile, (ROWS, 1))], [25], directions=90.0)
    windward, lee = last(scenario, run, "windward_slope")[0], last(scenario, run, "lee_slope")[0]
    assert windward == pytest.approx(math.degrees(math.atan(15 / 24 / 3)), abs=0.7)
    assert lee > 25.0
    assert last(scenario, run, "resultant_wind") == (270.0, "")
    assert last(scenario, run, "windward_slope", wind="last")[0] == pytest.approx(lee)


def test_winds_that_cancel_have_no_resultant_and_sides_are_doubtful():
    scenario = scenario_of(wind=SEASONS)
    run = run_of(scenario, [waves(n=0)], [5])
    value, doubt = last(scenario, run, "resultant_wind")
    assert math.isnan(value)
    assert doubt == "the winds cancel, or none moves sand"
    assert last(scenario, run, "lee_slope")[1] == "the winds cancel: the last one is taken"
    assert last(scenario, run, "lee_slope", wind="last")[1] == ""


@pytest.mark.parametrize(
    ("slabs", "name", "doubt"),
    [
        (waves(height=0.8), "spacing", "slabs is roughness"),
        (waves(height=0.8), "lee_slope", "slabs is roughness"),
        (waves(m=2, n=0), "spacing", "only 2.0 bedforms in the field"),
        (waves(m=32, n=0), "spacing", "a spacing of 4.0 cells is shaped by the lattice"),
        (waves(m=0, n=4), "lee_slope", "crests lie along the wind: no lee side"),
        (waves(m=8, n=0) + waves(m=0, n=4), "crest_azimuth", "no common direction (straightness 0.00)"),
        (np.full((ROWS, COLUMNS), 5.0), "bedform_height", "no relief"),
        (waves(), "speed", "no earlier frame to compare with"),
        (waves(), "flux", "no earlier frame"),
    ],
)
def test_a_measure_says_why_it_should_not_be_quoted(slabs, name, doubt):
    scenario = scenario_of()
    assert last(scenario, run_of(scenario, [slabs], [0]), name)[1].endswith(doubt)


def test_relief_of_the_ground_far_above_that_of_the_dunes_is_told():
    scenario = scenario_of(ground={"kind": "uneven"})
    north, east = np.mgrid[:ROWS, :COLUMNS]
    ground = 40.0 * np.sin(2 * np.pi * (east / COLUMNS + north / ROWS))
    value, doubt = last(scenario, run_of(scenario, [waves(n=0)], [0], ground), "dune_height")
    assert value == pytest.approx(16 / 3, rel=0.1)
    assert doubt == "the ground's relief is 16 times the bedforms' height"


def test_every_measure_of_an_ordinary_field_can_be_quoted():
    scenario = scenario_of()
    run = run_of(scenario, [waves(k, m=4, n=0, height=12.0) for k in range(4)], [0, 5, 10, 15])
    doubtful = {value.measure.name: value.doubt for value in last_values(run, scenario) if value.doubt}
    assert doubtful == {}
    assert {value.measure.name for value in last_values(run, scenario)} == {m.name for m in MEASURES}
    assert last(scenario, run, "migration_direction")[0] == pytest.approx(90.0, abs=0.1)
    assert last(scenario, run, "crest_azimuth")[0] % 180.0 == pytest.approx(0.0, abs=0.1)


def test_a_series_lists_the_steps_at_which_a_measure_is_doubtful():
    scenario = scenario_of()
    run = run_of(scenario, [waves(k, m=4, n=0, height=12.0) for k in range(3)], [0, 5, 10])
    measured = measure_series(run, scenario)
    assert measured["speed"].attrs["doubtful"] == [0]
    assert measured["spacing"].attrs["doubtful"] == []


def test_migration_over_buried_rock_is_doubted_for_the_sand_that_it_holds():
    """Walls of half a metre, in cells of 1 m, with sand above and around them; level ground holds none."""
    rock = np.zeros((ROWS, COLUMNS))
    rock[10:20, 30:50] = 0.5
    scenario = scenario_of()
    slabs = [np.roll(np.rint(bedforms()) + 3, k, axis=1) for k in range(3)]
    held = last(scenario, run_of(scenario, slabs, range(0, 12, 4), rock), "speed")[1]
    assert held == "sand that rocks or steep ground hold stands still and counts"
    assert last(scenario, run_of(scenario, slabs, range(0, 12, 4)), "speed")[1] == ""
