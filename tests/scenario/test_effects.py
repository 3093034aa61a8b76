"""What the wind of a scenario does: nothing in silence."""

import re

import pytest

import barchan
from barchan.errors import ScenarioError
from barchan.scenario.effects import can_move, stated_speeds

GRAINS = pytest.mark.parametrize("preset", ["ripples", "szabo-10"])
METRES = {"kind": "steady", "unit": "m/s"}
REGIMES = [{"direction": 270.0, "steps": 5, "speed": speed, "unit": "m/s"} for speed in (3.0, 14.0)]


@GRAINS
def test_a_speed_in_cells_is_refused_where_grains_fly_and_a_calm_is_not(preset):
    with pytest.raises(ScenarioError, match=r"wind\.speed: is a hop length in cells, which .* does not use"):
        barchan.load(preset, wind__speed=14)
    assert not can_move(barchan.load(preset, wind__speed=0))


@GRAINS
def test_the_friction_velocity_is_that_of_the_wind_that_blows(preset):
    """u* = 0.4 U / ln(10 m / z0), z0 being a 30th of the grains' 0.15 mm."""
    for speed, ustar in ((14.0, "0.386"), (9.0, "0.248")):
        told = barchan.load(preset, wind={**METRES, "speed": speed}).facts()["friction velocity"]
        assert told.startswith(f"{ustar} m/s, threshold ")
    changing = barchan.load(preset, wind={"kind": "regimes", "regimes": REGIMES})
    assert changing.facts()["friction velocity"].startswith("0.083 to 0.386 m/s, threshold ")


@GRAINS
def test_a_wind_below_the_threshold_is_remarked_whatever_the_models_own_is(preset):
    still = barchan.load(preset, wind={**METRES, "speed": 3.0}, model__wind_speed=12)
    remarks = still.remarks()
    assert (
        "nothing moves: no wind of the run is above the threshold; the fastest wind blows at 3 m/s" in remarks
    )
    assert "model.wind_speed 12 has no effect: the wind states its own speed" in remarks
    assert can_move(barchan.load(preset, wind={**METRES, "speed": 14.0}, model__wind_speed=3))


def test_slabs_under_a_wind_below_the_threshold_are_remarked():
    still = barchan.load("barchans", clock={}, wind={**METRES, "speed": 4.0})
    (remark,) = (remark for remark in still.remarks() if "nothing moves" in remark)
    assert re.search(r"blows at 4 m/s, and sand moves above 6\.4 m/s", remark)
    assert can_move(barchan.load("barchans", clock={}, wind={**METRES, "speed": 9.0}))


def test_a_hop_length_that_the_wind_overrides_is_remarked():
    remarks = barchan.load("barchans", model__hop_length=7, wind__speed=3).remarks()
    assert "model.hop_length 7 has no effect: the wind states its own speed" in remarks
    assert not any(
        "no effect" in remark for remark in barchan.load("barchans", model__hop_length=7).remarks()
    )


def test_the_speeds_of_a_record_are_its_whole_range():
    least, most = stated_speeds(barchan.load("barchans", wind={"kind": "record"}, clock={}))
    assert 0 <= least < 2
    assert most > 10
    assert can_move(barchan.load("barchans", wind={"kind": "record"}, clock={}))
