"""One answer of two workers."""

from types import SimpleNamespace

import pytest

from barchan.studio.server.joint_answers import JointAnswers


class Worker:
    def __init__(self) -> None:
        self.asked: list[dict] = []

    def forward(self, part) -> None:
        self.asked.append(part)

    def send(self, command, **content) -> None:
        self.asked.append({"command": command, **content})


@pytest.mark.parametrize("first", ["a", "b"])
def test_answers_stand_in_the_order_of_the_runs_whichever_worker_is_ready_first(first):
    workers = {"a": Worker(), "b": Worker()}
    joint = JointAnswers(SimpleNamespace(workers=workers))
    answered = []
    joint.ask({run: {"command": "save_folder"} for run in workers}, answered.append, lambda *_: None)
    for run in sorted(workers, key=first.__ne__):
        joint.takes({"type": "done", "id": workers[run].asked[0]["id"], "step": 40, "run": run})
    assert [list(answers) for answers in answered] == [["a", "b"]]
    assert [answer["run"] for answer in answered[0].values()] == ["a", "b"]


def test_a_refusal_names_what_the_others_have_answered_in_their_order():
    workers = {name: Worker() for name in "abc"}
    joint = JointAnswers(SimpleNamespace(workers=workers))
    failures = []
    joint.ask(
        {run: {} for run in workers}, lambda _: None, lambda why, answers: failures.append((why, *answers))
    )
    for run in "ca":
        joint.takes({"type": "done", "id": workers[run].asked[0]["id"]})
    joint.takes({"type": "refused", "id": workers["b"].asked[0]["id"], "text": "the disk is full"})
    assert failures == [("the disk is full", "a", "c")]
