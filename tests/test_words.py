"""Counts and names as people write them."""

import pytest

from barchan.words import counted, spoken_name


@pytest.mark.parametrize(
    ("count", "text"), [(0, "0 steps"), (1, "1 step"), (2, "2 steps"), (-1, "-1 step"), (1000, "1000 steps")]
)
def test_one_of_a_kind_is_not_many(count, text):
    assert counted(count, "step") == text


def test_a_plural_and_a_sign_of_ones_own():
    assert counted(1, "quantum", "quanta", "+d") == "+1 quantum"
    assert counted(-3, "quantum", "quanta", "+d") == "-3 quanta"


def test_names_are_spoken_in_words_and_symbols_as_they_are():
    assert spoken_name("model.hop_length") == "hop length"
    assert spoken_name("model.p_ns") == "p_ns"
    assert spoken_name("dune_height") == "dune height"
