"""Marks that stand for a missing value in a file: numbers and texts, declared and compared in one way."""

import math
from collections.abc import Sequence
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray
from pydantic import BeforeValidator

from barchan.parameters import parameter

SINGLE = 1e-6
"""Relative difference of two numbers that single precision may write alike."""


def _several(value: Any) -> Any:
    """A single mark as a list of one."""
    return [value] if isinstance(value, int | float | str) and not isinstance(value, bool) else value


def _marks(value: Any) -> Any:
    """Marks with texts that are numbers as numbers."""
    value = _several(value)
    return [_mark(one) for one in value] if isinstance(value, list) else value


def _mark(value: Any) -> Any:
    try:
        number = float(value) if isinstance(value, str) else math.nan
    except ValueError:
        return value
    return number if math.isfinite(number) else value


Codes = Annotated[list[float], BeforeValidator(_several)]
"""Numbers that stand for a missing value."""

Marks = Annotated[list[float | str], BeforeValidator(_marks)]
"""Numbers and texts that stand for a missing value."""


def missing_key(default: Any, marks: str, more: str) -> Any:
    """The declaration of a key ``missing``: ``marks`` names what it lists, ``more`` its rules."""
    return parameter(
        default, unit="-", max_length=100, meaning=f"{marks} that stand for a missing value{more}"
    )


def codes_in(marks: Sequence[float | str]) -> list[float]:
    """The numbers among marks."""
    return [mark for mark in marks if not isinstance(mark, str)]


def texts_in(marks: Sequence[float | str]) -> frozenset[str]:
    """The texts among marks, in lower case and without blanks around them."""
    return frozenset(mark.strip().lower() for mark in marks if isinstance(mark, str))


def marked(values: NDArray[np.float64], codes: Sequence[float]) -> NDArray[np.bool_]:
    """Where values are one of the codes, as exactly as single precision writes them."""
    found = np.zeros(values.shape, bool)
    for code in codes:
        found |= np.abs(values - code) <= SINGLE * abs(code)
    return found
