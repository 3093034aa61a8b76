"""A run that is set aside for two that are compared, and taken back."""

import numpy as np
import pytest

from barchan.studio.worker.run import started, states_of
from barchan.studio.worker.saved_runs import save_run
from tests.studio.conftest import small
from tests.studio.worker.test_rescue import Bench
from tests.studio.worker.test_run import run_to


@pytest.fixture
def bench(scenario):
    bench = Bench()
    bench.send("start", scenario=scenario.data(), number=1)
    return bench


def compared(bench, number=2, **content):
    bench.send("start", scenario=small().data(), changed=True, number=number, **content)


def test_the_run_that_was_compared_comes_back_with_its_surface_its_moments_and_its_measures(bench):
    run = bench.worker.commands.current
    run_to(run, 30)
    bench.send("bookmark", bookmarks=[{"id": "m", "name": "horns"}])
    run_to(run, 40)
    sand, rows = run.live.bed.sand.copy(), list(run.measures.rows)
    compared(bench, aside=True)
    run_to(bench.worker.commands.current, 10)
    bench.send("take_back", number=3)
    back = bench.worker.commands.current
    assert back.live.steps_done == 40
    assert np.array_equal(back.live.bed.sand, sand)
    assert back.measures.rows == rows
    assert not back.running
    bench.send("visit", bookmark="m")
    assert back.shown.steps_done == 30


def test_the_compared_run_stays_as_a_branch_with_its_own_moments(bench):
    run_to(bench.worker.commands.current, 20)
    compared(bench, aside=True)
    run_to(bench.worker.commands.current, 30)
    bench.send("bookmark", bookmarks=[{"id": "p", "name": "in the pair"}])
    bench.send("take_back", number=3)
    back = bench.worker.commands.current
    assert back.branches.listing(20) == [
        {"number": 1, "began": 0, "step": 20},
        {"number": 2, "began": 0, "step": 30},
    ]
    assert [(one.name, one.branch) for one in back.bookmarks] == [("in the pair", 2)]
    bench.send("visit", bookmark="p")
    assert back.live.steps_done == 30


def test_a_change_of_both_leaves_what_is_set_aside_and_another_scenario_takes_its_place(bench):
    before = bench.worker.commands.current
    compared(bench, aside=True)
    compared(bench, number=3)
    assert bench.worker.commands.aside.run is before
    bench.send("start", scenario=small().data(), number=4)
    bench.send("take_back", number=5, id=1)
    assert bench.messages("refused")[0]["text"] == "no run was set aside"


def test_a_run_and_another_scenario_take_turns_in_being_set_aside(bench):
    first = bench.worker.commands.current
    run_to(first, 20)
    bench.send("start", scenario=small().data(), number=2, aside=True)
    second = bench.worker.commands.current
    run_to(second, 30)
    for number, (run, other, step) in enumerate([(first, second, 20), (second, first, 30)], start=3):
        bench.send("take_back", number=number)
        assert bench.worker.commands.current is run
        assert run.live.steps_done == step
        assert bench.worker.commands.aside.run is other
        assert len(run.branches.listing(step)) <= 1


def turned(bench, direction):
    bench.send("wind", wind={"kind": "steady", "direction": direction})


def test_another_run_is_said_to_have_ended_also_where_it_has_the_same_name(bench):
    """What is set aside is named with what was changed of it, as the page names it."""
    scenario = small(title="Two winds").data()
    bench.send("start", scenario=scenario, number=2)
    run_to(bench.worker.commands.current, 20)
    turned(bench, 90)
    bench.send("start", scenario=scenario, number=3, aside=True, id=1)
    first = "Two winds, changed: wind.direction 90"
    assert told(bench) == (first, None)
    run_to(bench.worker.commands.current, 10)
    bench.send("start", scenario=scenario, number=4, aside=True, id=2)
    assert told(bench) == ("Two winds", first)


def told(bench) -> tuple[str | None, str | None]:
    """The titles of the run that is set aside, and of the one that has ended for it."""
    content = answer(bench)
    return content["aside"], content["ended"]


def answer(bench) -> dict:
    return bench.messages("done")[-1]


@pytest.fixture
def unasked():
    """A run that the studio began with by itself, at step 10."""
    bench = Bench()
    bench.send("start", scenario=small(title="Shown").data(), number=1, unasked=True)
    run_to(bench.worker.commands.current, 10)
    return bench


def test_a_run_that_nobody_asked_for_and_nobody_touched_is_neither_set_aside_nor_kept(unasked, tmp_path):
    unasked.send("keep_in", folder=str(tmp_path / "state"), id=1)
    assert not answer(unasked)["written"]
    unasked.send("start", scenario=small().data(), number=2, aside=True, id=2)
    assert told(unasked) == (None, None)
    assert unasked.worker.commands.aside is None


@pytest.mark.parametrize("touch", ["wind", "paint", "moment", "save", "go on"])
def test_whoever_touches_it_keeps_it(unasked, tmp_path, touch):
    shown = unasked.worker.commands.current
    if touch in ("wind", "paint"):
        make_a_change(unasked, touch)
    elif touch == "moment":
        unasked.send("bookmark", bookmarks=[{"id": "m", "name": "horns"}])
    elif touch == "save":
        unasked.send("save_folder", folder=str(tmp_path / "saved"))
        while unasked.worker.owed:
            unasked.worker.owed.pay()
    else:
        run_to(shown, shown.live.scenario.run.steps + 1)
    unasked.send("start", scenario=small().data(), number=2, aside=True)
    assert unasked.worker.commands.aside.run is shown


@pytest.fixture
def saved(tmp_path):
    """The folder of a run that was saved at step 10."""
    folder = tmp_path / "saved"
    run = started(small())
    run_to(run, 10)
    save_run(states_of(run), folder)
    return folder


def test_a_run_in_whose_place_a_saved_one_is_opened_is_set_aside_and_both_take_turns(bench, saved):
    first = bench.worker.commands.current
    run_to(first, 20)
    bench.send("open_folder", folder=str(saved), aside=True, number=2, id=1)
    assert answer(bench)["aside"] == first.live.scenario.title
    opened = bench.worker.commands.current
    for number, (run, other, step) in enumerate([(first, opened, 20), (opened, first, 10)], start=3):
        bench.send("take_back", number=number)
        assert bench.worker.commands.current is run
        assert run.live.steps_done == step
        assert bench.worker.commands.aside.run is other


def test_a_folder_that_cannot_be_opened_leaves_the_run_and_what_is_set_aside(bench, tmp_path):
    run_to(bench.worker.commands.current, 20)
    bench.send("start", scenario=small().data(), number=2, aside=True)
    run, aside = bench.worker.commands.current, bench.worker.commands.aside
    bench.send("open_folder", folder=str(tmp_path), aside=True, number=3, id=1)
    assert bench.messages("refused")
    assert bench.worker.commands.current is run
    assert bench.worker.commands.aside is aside


def test_where_one_of_two_is_left_for_another_run_it_becomes_a_branch_of_the_run_before_them(bench, saved):
    before = bench.worker.commands.current
    run_to(before, 20)
    compared(bench, aside=True)
    run_to(bench.worker.commands.current, 30)
    bench.send("open_folder", folder=str(saved), aside=True, number=3, id=1)
    assert bench.worker.commands.aside.run is before
    assert [one["step"] for one in before.branches.listing(20)] == [20, 30]
    bench.send("take_back", number=4)
    assert bench.worker.commands.current is before
    assert bench.worker.commands.aside.run.live.steps_done == 10


def test_the_server_hears_whenever_there_is_more_to_keep_of_the_run_that_is_set_aside(bench):
    def told(number: int) -> tuple[bool, bool]:
        begun = next(message for message in bench.messages("begun") if message["number"] == number)
        return begun["aside"]["new"], begun["aside"]["changed"]

    run_to(bench.worker.commands.current, 20)
    compared(bench, number=2, aside=True)
    assert told(2) == (True, True)
    compared(bench, number=3)
    assert told(3) == (False, False)
    run_to(bench.worker.commands.current, 10)
    bench.send("start", scenario=small().data(), number=4, aside=True)
    assert told(4) == (False, True)  # what was compared has become a branch of it


def test_a_run_that_has_only_begun_does_not_take_the_place_of_one_that_is_set_aside(bench):
    first = bench.worker.commands.current
    run_to(first, 20)
    bench.send("start", scenario=small().data(), number=2, aside=True)
    bench.send("start", scenario=small(title="third").data(), number=3, aside=True, id=1)
    assert answer(bench)["aside"] == first.live.scenario.title
    assert bench.worker.commands.aside.run is first


def test_a_run_without_a_target_goes_to_its_scenarios_end_and_on_and_on_from_there(bench):
    end = bench.worker.commands.current.live.scenario.run.steps
    bench.send("run")
    assert bench.worker.commands.current.target == end
    run_to(bench.worker.commands.current, end)
    bench.send("run")
    assert bench.worker.commands.current.target is None
    bench.send("restart", running=False)
    bench.send("run")
    assert bench.worker.commands.current.target == end


@pytest.mark.parametrize("change", ["wind", "parameter", "paint"])
def test_who_changes_a_run_before_its_end_sees_as_many_steps_again_as_it_would_have_had(bench, change):
    """The scenario has 100 steps: a change after 60 lets it go on to 160, one at its end leaves it."""
    run = bench.worker.commands.current
    run_to(run, 60)
    bench.send("run")
    make_a_change(bench, change)
    assert (run.target, run.status()["end"]) == (160, 160)
    assert bench.messages("scenario")[-1]["end"] == 160
    run_to(run, 160)
    make_a_change(bench, change)
    assert run.status()["end"] == 160
    assert not run.busy


def make_a_change(bench, change):
    if change == "wind":
        turned(bench, 90)
    elif change == "parameter":
        bench.send("set", key="model.p_s", value=0.9)
    else:
        stroke = {"x": 5.0, "y": 5.0, "radius": 3.0, "amount": 4}
        bench.send("stroke", stroke=stroke, begin=True, end=True)
