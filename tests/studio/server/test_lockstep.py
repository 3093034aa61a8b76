"""Two runs that are led together, with workers that only note what they are sent."""

import pytest

from barchan.studio.server.lockstep import Lockstep


class Worker:
    """Notes requests; its run is at a step, and does what it is asked for when ``arrive`` is called."""

    def __init__(self):
        self.step, self.asked, self.order = 0, None, None
        self.commands = []

    def send(self, command, **content):
        self.commands.append(command)
        if command == "run":
            limit = content["until"] if content["until"] is not None else float("inf")
            self.asked, self.order = min(self.step + content["steps"], limit), content["order"]


class Pair:
    def __init__(self):
        self.workers = {"a": Worker(), "b": Worker()}
        self.said = []
        self.lockstep = Lockstep(self.workers, self.said.append)

    def arrive(self, name):
        worker = self.workers[name]
        if worker.asked is None:
            return
        worker.step = max(worker.step, worker.asked)
        self.lockstep.arrived(name, worker.step, worker.order)

    def meet(self):
        for name in "ab":
            self.arrive(name)

    @property
    def steps(self):
        return [worker.step for worker in self.workers.values()]


@pytest.fixture
def pair():
    return Pair()


def test_a_pause_on_the_way_is_carried_out_and_said_where_both_meet(pair):
    pair.lockstep.run()
    pair.arrive("a")
    pair.lockstep.pause()
    assert pair.said == [True]
    assert "pause" not in pair.workers["a"].commands + pair.workers["b"].commands
    pair.arrive("b")
    assert pair.said == [True, False]
    assert [worker.commands[-1] for worker in pair.workers.values()] == ["pause", "pause"]
    assert pair.steps[0] == pair.steps[1]


def test_a_halt_stops_both_at_once_and_whichever_is_behind_comes_up_first_when_they_go_on(pair):
    pair.lockstep.run()
    pair.arrive("a")
    pair.lockstep.halt()
    assert pair.said == [True, False]
    assert [worker.commands[-1] for worker in pair.workers.values()] == ["pause", "pause"]
    pair.arrive("b")
    assert pair.said == [True, False]
    pair.lockstep.run()
    pair.meet()
    assert pair.steps[0] == pair.steps[1]


def test_what_changes_a_run_waits_until_both_are_at_the_same_step(pair):
    pair.lockstep.run()
    pair.arrive("a")
    seen = []
    pair.lockstep.meet(lambda: seen.append(pair.steps))
    assert seen == []
    pair.arrive("b")
    assert len(seen) == 1
    assert seen[0][0] == seen[0][1] > 0
    assert [worker.commands[-1] for worker in pair.workers.values()] == ["run", "run"]


def test_looking_back_on_the_way_pauses_both_first_and_they_can_run_again(pair):
    pair.lockstep.run()
    pair.lockstep.meet(lambda: [worker.send("look") for worker in pair.workers.values()], pausing=True)
    pair.meet()
    assert [worker.commands[-2:] for worker in pair.workers.values()] == [["pause", "look"]] * 2
    assert pair.said == [True, False]
    pair.lockstep.run()
    assert [worker.commands[-1] for worker in pair.workers.values()] == ["run", "run"]


def test_at_rest_everything_is_done_at_once(pair):
    seen = []
    pair.lockstep.meet(lambda: seen.append(1), pausing=True)
    assert seen == [1]
    assert pair.said == []


def test_both_stop_at_the_step_that_they_were_to_run_to(pair):
    pair.lockstep.run(until=7)
    while pair.lockstep.running:
        pair.meet()
    assert pair.steps == [7, 7]


def test_both_do_the_steps_that_they_were_asked_for(pair):
    pair.lockstep.run(steps=5)
    while pair.lockstep.running:
        pair.meet()
    assert pair.steps == [5, 5]


def test_an_arrival_of_an_earlier_pair_counts_for_nothing(pair):
    """A worker that was at the steps of an earlier pair's order when it was given those of another one."""
    pair.lockstep.run()
    earlier = pair.workers["a"].order
    later = Lockstep(pair.workers, pair.said.append)
    later.run()
    later.arrived("a", 57, earlier)
    later.arrived("b", pair.workers["b"].asked, pair.workers["b"].order)
    assert [worker.commands for worker in pair.workers.values()] == [["run", "run"]] * 2


def test_a_run_that_cannot_do_its_steps_pauses_the_other_where_it_arrives(pair):
    pair.lockstep.run()
    pair.lockstep.stopped("a")
    assert pair.said == [True]
    pair.arrive("b")
    assert pair.said == [True, False]


def test_what_waits_for_a_meeting_is_done_where_the_pair_is_left(pair):
    pair.lockstep.run()
    seen = []
    pair.lockstep.meet(lambda: seen.append(1))
    pair.lockstep.leave()
    assert seen == [1]


def test_both_run_to_the_end_of_the_scenario_that_ends_first_and_on_and_on_from_there(pair):
    pair.lockstep.ends = {"a": 5, "b": 9}
    pair.lockstep.run()
    while pair.lockstep.running:
        pair.meet()
    assert pair.steps == [5, 5]
    pair.lockstep.run()
    for _ in range(20):
        pair.meet()
    assert pair.lockstep.running
    assert pair.steps[0] > 5


def test_steps_stop_at_the_end_of_the_scenario_and_are_all_done_from_there_on(pair):
    pair.lockstep.ends = {"a": 5, "b": 9}
    for wanted in (5, 13):
        pair.lockstep.run(steps=8)
        while pair.lockstep.running:
            pair.meet()
        assert pair.steps == [wanted, wanted]


def stand(pair, **steps):
    for name, step in steps.items():
        pair.workers[name].step = step
        pair.lockstep.stands(name, step, 100)


def test_two_that_were_opened_run_to_the_end_of_their_scenario_and_no_further(pair):
    stand(pair, a=98, b=98)
    pair.lockstep.run()
    while pair.lockstep.running:
        pair.meet()
    assert pair.steps == [100, 100]


def test_two_whose_ends_are_put_off_on_the_way_go_on_to_the_new_one(pair):
    stand(pair, a=90, b=90)
    pair.lockstep.run()
    for name in "ab":
        pair.lockstep.stands(name, 90, 190)
    while pair.lockstep.running:
        pair.meet()
    assert pair.steps == [190, 190]


def test_one_that_is_behind_comes_to_the_step_of_the_other_one_first(pair):
    stand(pair, a=40, b=34)
    pair.lockstep.run(steps=2)
    seen = []
    while pair.lockstep.running:
        seen.append(pair.steps)
        pair.meet()
    assert [steps[0] for steps in seen[:-1]] == [40] * (len(seen) - 1)
    assert pair.steps == [42, 42]


def test_one_that_is_behind_can_be_paused_on_its_way(pair):
    stand(pair, a=40, b=0)
    pair.lockstep.run()
    pair.lockstep.pause()
    pair.arrive("b")
    assert not pair.lockstep.running
    assert pair.steps[0] == 40 > pair.steps[1] > 0


def test_one_that_ended_before_the_other_is_not_waited_for(pair):
    """Its model has nothing more to move: it arrives at once, where it was."""
    stand(pair, a=40, b=34)
    pair.lockstep.run(until=45)
    while pair.lockstep.running:
        pair.workers["b"].asked = 34
        pair.meet()
    assert pair.steps == [45, 34]
