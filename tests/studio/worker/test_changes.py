"""The list of changes from which they are undone, and the words that name them."""

from barchan.scenario import load_scenario, validate
from barchan.scenario.changes import changed_from
from barchan.simulation import SetParameter, SetWind, Simulation
from barchan.studio.worker.changes import changes_of
from barchan.studio.worker.description import description
from tests.studio.worker.test_rescue import Bench

TINY = {"barchan": 5, "lattice": {"rows": 16, "columns": 16}, "run": {"seed": 1}, "model": {"p_s": 0.6}}


def test_changes_are_listed_with_the_value_before_and_only_the_newest_of_a_key_can_be_undone():
    simulation = Simulation(validate(TINY))
    simulation.apply(SetParameter(key="model.p_s", value=0.4))
    simulation.advance(2)
    simulation.apply(SetParameter(key="model.p_s", value=0.2))
    simulation.apply(SetWind(wind={"direction": 90}))
    found = [(c["step"], c["key"], c["undo"]) for c in changes_of(simulation)]
    assert found == [(0, "model.p_s", False), (2, "model.p_s", True), (2, "wind", True)]
    assert [(c["before"], c["value"]) for c in changes_of(simulation)[:2]] == [(0.6, 0.4), (0.4, 0.2)]
    assert changes_of(simulation)[2]["before"]["direction"] == 270.0  # the default


def test_title_and_citation_name_what_was_changed_and_lose_it_again():
    origin = load_scenario("barchans", [("lattice.rows", "16"), ("lattice.columns", "16")])
    words = {"title": "Barchans", "citation": "Werner (1995)", "look_for": "Horns."}
    origin = origin.model_copy(update=words)
    simulation = Simulation(origin)
    simulation.apply(SetWind(wind={"direction": 180}))
    shown = description(simulation, origin)["scenario"]
    assert shown["title"] == "Barchans, changed: wind.direction 180"
    assert shown["citation"] == "Werner (1995); changed: wind.direction 180"
    assert shown["look_for"] == "(without these changes) Horns."
    simulation.apply(SetWind(wind={"direction": 270}))
    shown = description(simulation, origin)["scenario"]
    assert {key: shown[key] for key in words} == words


def test_another_kind_of_ground_and_another_model_are_named_by_their_kind():
    origin = validate({**TINY, "title": "Sand", "look_for": "Ridges."})
    other = validate({**TINY, "title": "x", "ground": {"kind": "bump"}, "model": {"name": "momiji"}})
    named = changed_from(other, origin)
    assert named.title == "Sand, changed: ground.kind bump, model.name momiji"
    assert named.look_for == ""  # it was written for another model


def test_only_the_message_that_follows_a_change_says_that_one_was_made():
    bench = Bench()
    bench.send("start", scenario=TINY, number=1)
    bench.send("set", key="model.p_s", value=0.4)
    bench.send("wind", wind={"direction": 90})
    bench.send("restart")
    told = bench.messages("scenario")
    assert [message["changed"] for message in told] == [False, True, True, False]
    assert [message["changes"][-1]["key"] for message in told[1:3]] == ["model.p_s", "wind"]
