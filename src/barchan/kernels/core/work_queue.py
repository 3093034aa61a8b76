"""A board on which one thread offers pieces of work, round by round, to itself and to any that help it.

The leader offers a round and waits until every piece that was taken is done. It takes pieces too, so it never
waits for a helper to come: one that comes late finds less to do, one that never comes is not missed. Leader
and helpers take pieces from opposite ends, so each finds in its cache what it had the round before. What a
piece gives must not depend on who does it, nor on other pieces of its round.
"""

import numpy as np
from numba import njit

from barchan.kernels.core.atomics import add, give_way, load, pause, store, swap
from barchan.kernels.core.state import LINE

OFFER, DONE = LINE, 2 * LINE
"""Where the board holds what is on publish, and how many pieces of all rounds are done."""

SIZE = 3 * LINE

CLOSED = -1
"""On publish when nothing more will be."""

NOTHING = -1

_BITS = 20
MOST_PIECES = (1 << _BITS) - 1
"""Pieces of a round at most."""

_PIECES = np.int64(MOST_PIECES)
_ROUNDS = np.int64((1 << (62 - 2 * _BITS)) - 1)
_SPINS = 2000
"""Looks at the board before a waiting thread gives way to others at each: some 50 µs."""


def new_board() -> np.ndarray:
    """A board with nothing on it."""
    return np.zeros(SIZE, np.int64)


@njit(cache=True, nogil=True, error_model="numpy")
def wait_a_moment(spins):
    """Wait for another thread, after so many looks; their number with this one."""
    pause()
    if spins > _SPINS:
        give_way()
    return spins + 1


@njit(cache=True, nogil=True, error_model="numpy")
def publish(board, round_number, pieces):
    """Put the pieces of a round on the board: from the first one on to before the last one, and the round.

    They are one number, so that nobody can take a piece of a round that is past.
    """
    store(board, OFFER, ((round_number & _ROUNDS) << (2 * _BITS)) | pieces)


@njit(cache=True, nogil=True, error_model="numpy")
def pop_front(board):
    """The first piece left, for the leader; ``NOTHING`` where none is."""
    while True:
        word = load(board, OFFER)
        first, end = (word >> _BITS) & _PIECES, word & _PIECES
        if first >= end:
            return NOTHING
        if swap(board, OFFER, word, word + (np.int64(1) << _BITS)):
            return first


@njit(cache=True, nogil=True, error_model="numpy")
def wait_pop_back(board):
    """The round and the last piece left, for a helper, once there is one; ``NOTHING`` twice at the end."""
    spins = 0
    while True:
        word = load(board, OFFER)
        if word == CLOSED:
            return NOTHING, NOTHING
        first, end = (word >> _BITS) & _PIECES, word & _PIECES
        if first < end:
            if swap(board, OFFER, word, word - 1):
                return word >> (2 * _BITS), end - 1
        else:
            spins = wait_a_moment(spins)


@njit(cache=True, nogil=True, error_model="numpy")
def task_done(board):
    """Say that a piece is done."""
    add(board, DONE, 1)


@njit(cache=True, nogil=True, error_model="numpy")
def count_done(board):
    """Pieces of all rounds that are done."""
    return load(board, DONE)


@njit(cache=True, nogil=True, error_model="numpy")
def await_done(board, pieces):
    """Wait until as many pieces of all rounds are done."""
    spins = 0
    while count_done(board) != pieces:
        spins = wait_a_moment(spins)


def close(board: np.ndarray) -> None:
    """Send helpers away. The leader has waited for all that was taken, or nobody will."""
    board[OFFER] = CLOSED
