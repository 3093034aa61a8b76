import numpy as np

from barchan.simulation import State
from barchan.studio.worker import history as history_module
from barchan.studio.worker.history import History


def state(step: int, sand: np.ndarray, ground: np.ndarray) -> State:
    return State({"step": step}, {"bed/sand": sand, "bed/ground": ground.copy()})


def test_what_did_not_change_is_held_once():
    history = History(10)
    ground = np.zeros((8, 8))
    for step in range(0, 50, 10):
        history.keep(state(step, np.full((8, 8), step, np.int32), ground))
    assert history.steps == [0, 10, 20, 30, 40]
    assert history.bytes == 5 * 8 * 8 * 4 + 8 * 8 * 8
    assert history.due == 50


def test_beyond_the_budget_every_second_state_is_forgotten_and_the_first_kept(monkeypatch):
    monkeypatch.setattr(history_module, "BUDGET", 10 * 256)
    history = History(1)
    for step in range(100):
        if step >= history.due:
            history.keep(state(step, np.full((8, 8), step, np.int32), np.zeros(1)))
    assert history.steps[0] == 0
    assert history.bytes <= 10 * 256
    gaps = np.diff(history.steps)
    assert set(gaps[:-1]) == {history.every}


def test_the_nearest_state_is_found():
    history = History(10)
    for step in (0, 10, 20):
        history.keep(state(step, np.zeros((2, 2), np.int32), np.zeros(1)))
    assert history.at(14).step == 10
    assert history.at(99).step == 20
    assert history.until(10).steps == [0, 10]
