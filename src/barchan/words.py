"""Counts and names as people write them."""

import re

_WORDS_MEET = re.compile(r"_(?=[a-z0-9]{3})")
"""An underscore before a word; one before a letter or two is of a symbol, as in ``p_ns``."""


def counted(count: int, noun: str, plural: str = "", form: str = "") -> str:
    """A count with its noun, in the ``plural`` (one with an s without it) unless it is one."""
    return f"{count:{form}} {noun if abs(count) == 1 else plural or f'{noun}s'}"


def spoken_name(name: str) -> str:
    """A name of a measure or parameter, or the last part of a key, in words; symbols stay as they are."""
    return _WORDS_MEET.sub(" ", name.rpartition(".")[2])
