"""Random streams are SplitMix64 sequences that belong to a seed, a name and a number."""

import hashlib

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from barchan.streams import Stream, below, derive, high, low

PUBLISHED = [
    6457827717110365317,
    3203168211198807973,
    9817491932198370423,
    4593380528125082431,
    16408922859458223821,
]
"""The first outputs of SplitMix64 from the state 1234567."""


def test_numbers_under_a_key_are_the_published_outputs_of_splitmix64():
    assert [derive(1234567, n) for n in range(5)] == PUBLISHED


def test_a_streams_key_is_the_seeds_number_under_the_hash_of_its_name():
    hashed = int.from_bytes(hashlib.sha256(b"transport").digest()[:8], "little")
    assert Stream(5, "transport").key == derive(hashed, 5)


@given(st.integers(0, 2**53 - 1), st.integers(0, 10**12))
def test_draws_are_the_sequence_that_starts_under_their_number(seed, number):
    stream = Stream(seed, "wind")
    start = derive(stream.key, number)
    assert stream.draws(number, 6).tolist() == [derive(start, n) for n in range(6)]


def test_asking_for_more_draws_never_changes_the_first_ones():
    stream = Stream(3, "initial surface")
    np.testing.assert_array_equal(stream.draws(2, 10), stream.draws(2, 1000)[:10])


def test_no_draws_are_an_empty_array():
    assert Stream(3, "wind").draws(0, 0).size == 0


@pytest.mark.parametrize(
    ("first", "second"),
    [
        (Stream(1, "wind").draws(0, 500), Stream(1, "transport").draws(0, 500)),
        (Stream(1, "wind").draws(0, 500), Stream(2, "wind").draws(0, 500)),
        (Stream(1, "wind").draws(0, 500), Stream(1, "wind").draws(1, 500)),
    ],
    ids=["names", "seeds", "numbers"],
)
def test_different_streams_share_no_draws(first, second):
    assert not set(first.tolist()) & set(second.tolist())


@given(st.integers(0, 2**64 - 1), st.integers(1, 2**31))
def test_a_number_below_a_bound_is_the_floor_of_the_fraction_times_the_bound(draw, bound):
    draws = np.array([draw], np.uint64)
    assert below(high(draws), bound)[0] == (draw >> 32) * bound // 2**32
    assert below(low(draws), bound)[0] == (draw & 0xFFFFFFFF) * bound // 2**32


def test_numbers_below_a_bound_are_uniform():
    count, bound = 30_000, 7
    numbers = below(high(Stream(11, "wind").draws(0, count)), bound)
    observed = np.bincount(numbers, minlength=bound)
    chi_square = float(((observed - count / bound) ** 2 / (count / bound)).sum())
    mean, deviation = bound - 1, np.sqrt(2 * (bound - 1))
    assert abs(chi_square - mean) < 4 * deviation
