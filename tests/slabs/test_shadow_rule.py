"""Which shadow rule acts where ``shadow_from`` is ``auto``: that depends on lattice and winds."""

import pytest

from barchan import Simulation, load
from barchan.simulation.events import event_from, in_force

SMALL = {"barchan": 5, "lattice": {"rows": 8, "columns": 8}, "run": {"seed": 1, "steps": 4}}


def scenario(wind, lattice=None, clock=None, **model):
    lattice = {**SMALL["lattice"], **(lattice or {})}
    model = {"name": "werner", **model}
    return load({**SMALL, "lattice": lattice, "wind": wind, "clock": clock, "model": model})


def steady(direction, **more):
    return {"kind": "steady", "direction": direction, **more}


def regimes(*winds):
    return {"kind": "regimes", "regimes": [{"steps": 2, **wind} for wind in winds]}


ALONG_AXES = {
    "from the south": steady(180),
    "from north and east in turn": regimes({"direction": 0}, {"direction": 90}),
    "a calm from between the axes": regimes({"direction": 0}, {"direction": 45, "speed": 0}),
    "mixed along two axes": {"kind": "mixed_axes", "first": 270, "second": 0},
}
OFF_AXES = {
    "from between two axes": steady(285),
    "a hair off an axis": steady(270.001),
    "from an axis, with spread": steady(270, spread=5),
    "from an axis and from between two in turn": regimes({"direction": 0}, {"direction": 45}),
    "a calm from between the axes that wakes up": regimes({"direction": 45, "speed": 0, "final_speed": 5}),
}


@pytest.mark.parametrize("wind", ALONG_AXES.values(), ids=ALONG_AXES)
def test_under_winds_along_axes_lines_start_at_the_centre(wind):
    assert scenario(wind).new_model().shadow_rule == "centre"


@pytest.mark.parametrize("wind", OFF_AXES.values(), ids=OFF_AXES)
def test_under_winds_off_the_axes_they_start_from_each_slabs_place(wind):
    assert scenario(wind).new_model().shadow_rule == "place"


def test_records_and_storms_count_as_winds_off_the_axes():
    for kind in ("record", "storms"):
        assert scenario({"kind": kind}, clock={}).new_model().shadow_rule == "place"


@pytest.mark.parametrize("direction", [30, 90, 150, 210, 270, 330])
def test_hexagons_have_six_axes_along_which_lines_start_at_the_centre(direction):
    hexagons = scenario(steady(direction), {"kind": "hex"})
    assert hexagons.new_model().shadow_rule == "centre"
    assert hexagons.facts()["shadow from"] == "centre (auto: all winds blow along axes)"


@pytest.mark.parametrize(
    "wind",
    [
        steady(285),
        steady(0),  # along a symmetry of the lattice, but along no line of cells
        steady(240),
        steady(30, spread=5),
        regimes({"direction": 30}, {"direction": 45}),
        {"kind": "mixed_axes", "first": 270, "second": 0},
    ],
)
def test_under_other_winds_lines_start_from_each_slabs_place_on_hexagons(wind):
    assert scenario(wind, {"kind": "hex"}).new_model().shadow_rule == "place"


def test_winds_in_turn_along_axes_of_hexagons_start_lines_at_the_centre():
    winds = regimes(*({"direction": direction} for direction in (270, 150, 30)))
    assert scenario(winds, {"kind": "hex"}).new_model().shadow_rule == "centre"
    assert scenario(winds).new_model().shadow_rule == "place"


@pytest.mark.parametrize("rule", ["centre", "edge", "place"])
def test_a_rule_that_is_chosen_acts_under_any_wind(rule):
    for wind in (steady(270), steady(285)):
        assert scenario(wind, shadow_from=rule).new_model().shadow_rule == rule


def test_the_rule_is_told_with_its_reason():
    assert scenario(steady(270)).facts()["shadow from"] == "centre (auto: all winds blow along axes)"
    oblique = scenario(steady(285)).facts()["shadow from"]
    assert oblique == "place, over sloping tops (auto: a wind blows off the lattice's axes)"
    assert scenario(steady(285), shadow_from="edge").facts()["shadow from"] == "edge"
    tops = scenario(steady(285), shadow_from="place", stack_tops="level")
    assert tops.facts()["shadow from"] == "place"


@pytest.mark.parametrize("kind", ["square", "hex"])
def test_tops_slope_under_winds_off_the_axes_alone(kind):
    for direction, sloping in ((270, False), (285, True)):
        chosen = scenario(steady(direction), {"kind": kind}, shadow_from="place", stack_tops="sloping")
        model = chosen.new_model()
        arguments, _ = model._enter(chosen.first_bed(), model._frame(direction), 5.0, None)
        assert (arguments.rules.box.tops is not None) == sloping


def test_a_rule_by_which_the_lattice_steers_crests_is_remarked():
    def remarked(wind, rule, kind="square"):
        remarks = scenario(wind, {"kind": kind}, shadow_from=rule).remarks()
        return [text for text in remarks if "shadow_from" in text]

    (text,) = remarked(steady(285), "centre")
    assert "shadow_from centre" in text
    assert "model.shadow_from place avoids it" in text
    assert not remarked(steady(285), "auto")
    assert not remarked(steady(270), "centre")
    assert "by up to 24°" in remarked(steady(285), "edge", "hex")[0]
    assert not remarked(steady(285), "auto", "hex")
    assert not remarked(steady(210), "centre", "hex")


def test_shadow_lines_of_the_kernel_follow_the_rule():
    for kind, direction, boxes in (
        *(("square", 270, False), ("square", 285, True), ("square", 210, True)),
        *(("hex", 270, False), ("hex", 285, True), ("hex", 210, False)),
    ):
        wind = steady(direction)
        chosen = scenario(wind, {"kind": kind})
        model = chosen.new_model()
        arguments, _ = model._enter(chosen.first_bed(), model._frame(wind["direction"]), 5.0, None)
        assert (arguments.rules.box is not None) == boxes


def test_another_wind_during_a_run_decides_anew_and_is_remembered():
    simulation = Simulation(scenario(steady(270)))
    assert simulation.model.shadow_rule == "centre"
    simulation.apply(event_from({"kind": "wind", "wind": steady(285)}))
    assert simulation.model.shadow_rule == "place"
    assert simulation.scenario_in_force.model.shadow_from == "auto"
    again = Simulation.from_state(simulation.state())
    assert again.model.shadow_rule == "place"
    assert in_force(again.scenario, again.events, 1).new_model().shadow_rule == "place"
    again.apply(event_from({"kind": "set", "key": "model.shadow_from", "value": "edge"}))
    assert again.model.shadow_rule == "edge"
    again.apply(event_from({"kind": "set", "key": "model.shadow_from", "value": "auto"}))
    again.apply(event_from({"kind": "wind", "wind": steady(180)}))
    assert again.model.shadow_rule == "centre"
