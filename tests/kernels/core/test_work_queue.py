"""Work on a board: every piece is done once, whoever comes, and nobody waits for those that do not."""

import threading

import numpy as np
import pytest
from numba import njit

from barchan.kernels.core.work_queue import (
    MOST_PIECES,
    NOTHING,
    await_done,
    await_last,
    close,
    count_done,
    new_board,
    offer,
    report,
    take_first,
)


@njit(nogil=True)
def lead(board, rounds, pieces, done):
    for number in range(rounds):
        offer(board, number, pieces)
        piece = take_first(board)
        while piece != NOTHING:
            done[number, piece] += 1
            report(board)
            piece = take_first(board)
        await_done(board, (number + 1) * pieces)


@njit(nogil=True)
def help_out(board, done):
    number, piece = await_last(board)
    while piece != NOTHING:
        done[number, piece] += 1
        report(board)
        number, piece = await_last(board)


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
    offer(board, 5, 4)
    assert take_first(board) == 0
    assert await_last(board) == (5, 3)
    assert take_first(board) == 1
    assert await_last(board) == (5, 2)
    assert take_first(board) == NOTHING


def test_the_largest_round_keeps_its_number():
    board = new_board()
    offer(board, 1_000_001, MOST_PIECES)
    assert await_last(board) == (1_000_001, MOST_PIECES - 1)
    assert take_first(board) == 0


def test_who_comes_after_the_end_goes():
    board = new_board()
    offer(board, 0, 3)
    close(board)
    assert await_last(board) == (NOTHING, NOTHING)
