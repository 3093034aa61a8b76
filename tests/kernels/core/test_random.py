import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from barchan import streams
from barchan.kernels.core import random as kernel
from tests.kernels.called import from_python

derive, below, shuffle = from_python(kernel.derive), from_python(kernel.below), from_python(kernel.shuffle)
WORDS = st.integers(0, 2**64 - 1)

# The first outputs of SplitMix64 from seed 1234567, as its authors' program gives them.
PUBLISHED = [
    6457827717110365317,
    3203168211198807973,
    9817491932198370423,
    4593380528125082431,
    16408922859458223821,
]


def test_derived_numbers_are_the_published_outputs_of_splitmix64():
    assert [streams.derive(1234567, n) for n in range(5)] == PUBLISHED
    assert [int(derive(np.uint64(1234567), n)) for n in range(5)] == PUBLISHED


@given(WORDS, st.integers(0, 2**62))
def test_compiled_and_plain_derivation_agree(key, number):
    assert int(derive(np.uint64(key), number)) == streams.derive(key, number)


@given(WORDS, st.integers(1, 2**31))
def test_a_bounded_number_is_the_share_of_the_half_word(word, count):
    half = word >> 32
    assert below(np.uint64(half), count) == half * count // 2**32


@given(WORDS, st.integers(1, 60))
def test_a_shuffle_keeps_every_item(key, count):
    items = np.arange(count)
    shuffle(items, count, np.uint64(key))
    assert sorted(items) == list(range(count))


def test_shuffles_are_uniform():
    seen = np.zeros((4, 4))
    for key in range(6000):
        items = np.arange(4)
        shuffle(items, 4, np.uint64(streams.derive(9, key)))
        seen[np.arange(4), items] += 1
    chi2 = ((seen - 1500) ** 2 / 1500).sum()
    assert chi2 < 27.9  # 9 degrees of freedom, one in a thousand
