"""Work on a board: every piece is done once, whoever comes, and nobody waits for those that do not."""

import threading

import numpy as np
import pytest
from numba import njit

from barchan.kernels.core.work_queue import (
    MOST_PIECES,
    NOTHING,
    await_done,
    close,
    count_done,
    new_board,
    pop_front,
    publish,
    task_done,
    wait_pop_back,
)


@njit(nogil=True)
def lead(board, rounds, pieces, done):
    for number in range(rounds):
        publish(board, number, pieces)
        piece = pop_front(board)
        while piece != NOTHING:
            done[number, piece] += 1
            task_done(board)
            piece = pop_front(board)
        await_done(board, (number + 1) * pieces)


@njit(nogil=True)
def help_out(board, done):
    number, piece = wait_pop_back(board)
    while piece != NOTHING:
        done[number, piece] += 1
        task_done(board)
        number, piece = wait_pop_back(board)


@pytest.mark.parametrize("helpers", [0, 1, 2, 5])
@pytest.mark.parametrize("pieces", [1, 7, 64])
def test_every_piece_of_every_round_is_done_once(helpers, pieces):
    board, done = new_board(), np.zeros((400, pieces), np.int64)
    threads = [threading.Thread(target=help_out, args=(board, done)) for _ in range(helpers)]
    for thread in threads:
        thread.start()
    lead(board, *done.shape, done)
    close(board)
    for thread in threads:
        thread.join(60)
        assert not thread.is_alive()
    assert (done == 1).all()
    assert count_done(board) == done.size


def test_leader_and_helper_take_from_opposite_ends():
    board = new_board()
    publish(board, 5, 4)
    assert pop_front(board) == 0
    assert wait_pop_back(board) == (5, 3)
    assert pop_front(board) == 1
    assert wait_pop_back(board) == (5, 2)
    assert pop_front(board) == NOTHING


def test_the_largest_round_keeps_its_number():
    board = new_board()
    publish(board, 1_000_001, MOST_PIECES)
    assert wait_pop_back(board) == (1_000_001, MOST_PIECES - 1)
    assert pop_front(board) == 0


def test_who_comes_after_the_end_goes():
    board = new_board()
    publish(board, 0, 3)
    close(board)
    assert wait_pop_back(board) == (NOTHING, NOTHING)
