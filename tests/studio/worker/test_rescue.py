"""What a worker survives, and the state that is kept outside it."""

import json
from multiprocessing import Pipe
from multiprocessing.connection import Connection

import numpy as np
import pytest

from barchan.studio.protocol import is_frame, is_state, numbered, read_request, state_head
from barchan.studio.worker.loop import Worker
from barchan.studio.worker.rescue import from_bytes, to_bytes
from barchan.studio.worker.run import started
from barchan.studio.worker.state_files import FileNames, StateNames
from tests.studio.conftest import small
from tests.studio.worker.test_run import run_to


class Bench:
    """A worker in this process, and the server's end of its pipe."""

    def __init__(self, measurer: Connection | None = None) -> None:
        self.ours, theirs = Pipe()
        self.worker = Worker(theirs, "a", measurer)

    def send(self, command: str, **content) -> None:
        self.worker.on_data(json.dumps({"command": command, **content}).encode())

    def messages(self, kind: str) -> list[dict]:
        found = []
        while self.ours.poll():
            data = self.ours.recv_bytes()
            if not is_frame(data) and not is_state(data):
                found.append(json.loads(data))
        return [message for message in found if message["type"] == kind]


@pytest.fixture
def bench(scenario):
    bench = Bench()
    bench.send("start", scenario=scenario.data(), number=1)
    bench.messages("scenario")
    return bench


@pytest.mark.parametrize(
    "request_",
    [
        {"command": "run", "steps": 10**400},
        {"command": "limit", "rate": 10**400},
        {"command": "paths", "count": "9" * 400},
        {"command": "switch", "branch": 10**400},
        {"command": "space_time", "line": [10**400, 0, 1, 1]},
        {"command": "view", "fields": 7},
    ],
)
def test_no_number_of_a_request_ends_the_worker(bench, request_):
    bench.send(**request_)
    bench.worker.work()
    assert bench.worker.commands.current.live.steps_done >= 0


def test_a_number_of_steps_and_every_new_run_stop_where_the_scenario_ends(bench):
    short = small(run={"steps": 6, "seed": 7, "save_every": 10}).data()

    def rest() -> int:
        run = bench.worker.commands.current
        while run.busy:
            bench.worker.work()
        return run.live.steps_done

    bench.send("start", scenario=short, number=2)
    bench.send("run", steps=4)
    assert rest() == 4
    bench.send("run", steps=100)
    assert rest() == 6
    bench.send("run", steps=5)  # sent on past the end
    assert rest() == 11
    bench.send("wind", wind={"kind": "steady", "direction": 90})
    bench.send("start", scenario={**short, "ground": {"kind": "bump"}}, number=3, changed=True, running=True)
    assert rest() == 6


def test_a_request_for_which_memory_is_lacking_is_refused_and_the_run_goes_on(bench, monkeypatch):
    def lacking(*_):
        raise MemoryError("Unable to allocate 32.0 GiB")

    monkeypatch.setattr("barchan.studio.worker.beginnings.started", lacking)
    bench.send("start", scenario=small().data(), id=5, number=2)
    messages = bench.messages("refused")
    assert messages[0]["id"] == 5
    assert messages[0]["text"] == "more memory was needed than is free (Unable to allocate 32.0 GiB)"
    assert bench.worker.commands.number == 1
    bench.send("run", steps=3)
    bench.worker.work()
    assert bench.worker.commands.current.live.steps_done > 0


def test_a_lattice_beyond_the_free_memory_is_refused_before_the_run_is_given_up(bench):
    """Memory: 65536 × 65536 cells of 4-byte slabs alone are 17 GB, and the run keeps them some times over."""
    before = bench.worker.commands.current
    large = {**small().data(), "lattice": {**small().data()["lattice"], "rows": 65536, "columns": 65536}}
    bench.send("start", scenario=large, number=2)
    begun = [message for message in bench.messages("begun") if message["number"] == 2]
    assert not begun[0]["ok"]
    assert bench.worker.commands.current is before


def test_a_run_whose_steps_fail_is_paused_at_its_last_whole_state(bench, monkeypatch):
    run = bench.worker.commands.current
    run_to(run, 25)
    run.run()

    def overflow(*_):
        run.live.bed.sand[:] = -7
        raise OverflowError("too large to convert to C long")

    monkeypatch.setattr(run.live, "advance", overflow)
    bench.worker.work()
    text = bench.messages("refused")[0]["text"]
    assert text == "the run is paused at step 20: after step 25 too large to convert to C long"
    assert run.live.steps_done == 20
    assert run.live.bed.sand.min() >= 0
    assert not run.busy


def test_a_run_continues_with_the_same_bits_from_the_state_that_was_kept(scenario, tmp_path):
    run = started(scenario)
    run_to(run, 37)
    data = to_bytes(run, 4, StateNames(tmp_path, FileNames()))
    assert is_state(data)
    assert state_head(data) == (4, 37)
    again = numbered(data, 9)
    assert state_head(again) == (9, 37)
    revived, _ = from_bytes(again)
    assert revived.measures.rows == run.measures.rows
    run_to(run, 60)
    run_to(revived, 60)
    assert np.array_equal(revived.live.bed.sand, run.live.bed.sand)


def test_the_server_gets_a_state_once_until_something_has_changed(bench):
    def states() -> int:
        bench.send("keep")
        return sum(
            is_state(data) for data in iter(lambda: bench.ours.poll() and bench.ours.recv_bytes(), False)
        )

    assert [states(), states()] == [1, 0]
    run_to(bench.worker.commands.current, 1)
    assert states() == 1


@pytest.mark.parametrize(
    "text", ['{"rate": NaN}', '{"rate": Infinity}', '{"rate": -1e999}', "[1]", "[" * 100_000, "{"]
)
def test_numbers_that_are_not_finite_and_messages_that_are_no_object_are_refused(text):
    with pytest.raises(
        Exception, match=r"a message (holds the number|must be an object|that cannot be read)"
    ):
        read_request(text)


def test_a_confirmation_too_many_gives_no_credit(bench):
    bench.worker.frames.attach()
    before = bench.worker.frames.credit
    for _ in range(50):
        bench.send("confirm")
    assert bench.worker.frames.credit == before
