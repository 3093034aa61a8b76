"""A run is seen before its first steps, and its frames say whose they are."""

from multiprocessing import Pipe

import pytest

from barchan.studio.protocol import is_frame
from tests.studio.conftest import small
from tests.studio.frames import read_frame
from tests.studio.worker.test_rescue import Bench


def frames(bench) -> list[dict]:
    found = []
    while bench.ours.poll():
        data = bench.ours.recv_bytes()
        if is_frame(data):
            found.append(read_frame(data)[0])
    return found


@pytest.fixture
def bench(scenario):
    bench = Bench()
    bench.send("attach")
    bench.send("start", scenario=scenario.data(), number=1, running=True)
    return bench


def test_the_first_frame_comes_before_the_first_steps_whose_kernels_may_have_to_be_compiled(bench):
    done = []
    run = bench.worker.commands.current
    run.advance_chunk = lambda: done.append(len(frames(bench)))
    bench.worker.work()
    assert done == [1]


def test_frames_name_the_start_that_loaded_their_scenario_as_its_description_does(bench):
    bench.worker.work()
    shown = [frames(bench)[-1]["loaded"]]
    for request in (
        {"command": "start", "scenario": small().data(), "changed": True, "number": 2},
        {"command": "restart", "running": False},
        {"command": "start", "scenario": small().data(), "aside": True, "number": 3},
        {"command": "take_back", "number": 4},
    ):
        bench.send("confirm")
        bench.send(**request)
        described = bench.messages("scenario")[-1]["loaded"]
        bench.worker.frames.send(bench.worker.commands.current)
        shown.append(frames(bench)[-1]["loaded"])
        assert described == shown[-1]
    assert shown == [1, 1, 1, 3, 1]


def test_the_picture_of_a_pause_does_not_wait_for_its_measures(scenario):
    """Not even where the process that measures has begun and never answers."""
    measurer, theirs = Pipe()
    bench = Bench(theirs)
    bench.send("attach")
    bench.send("start", scenario=scenario.data(), number=1, running=True)
    measurer.send_bytes(b"ready")
    run = bench.worker.commands.current
    while run.live.steps_done < 13:
        bench.worker.work()
    frames(bench)
    bench.send("pause")
    bench.send("confirm")
    bench.worker.frames.send_if_due = bench.worker.frames.send  # whatever the time since the last frame
    bench.worker.work()
    (shown,) = frames(bench)
    assert not shown["status"]["running"]
    assert shown["status"]["step"] == run.live.steps_done
    assert bench.worker.desk.pending > 1
    assert run.measures.rows == []
