"""Commas in numbers: decimals in most of the world, thousands in some."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from barchan.errors import Problem, RecordError
from barchan.missing import marked

if TYPE_CHECKING:
    import pandas as pd

_COMMA = r"\s*-?\d+,\d+\s*"
_THOUSANDS = r"\s*-?[1-9]\d{0,2},\d{3}\s*"
_PLAIN = r"\s*-?\d+(?:\.\d*)?\s*"


def with_points(
    words: "pd.Series", column: str, rows: NDArray[np.int64], codes: list[float], source: str
) -> "pd.Series":
    """A column of words with points for its decimal commas.

    Raises RecordError where all its commas could part thousands and other numbers have none: 1,234 beside 940
    may be 1234 or 1.234. Codes of a missing value (``codes``) do not count.
    """
    commas = words.str.fullmatch(_COMMA)
    if not commas.any():
        return words
    thousands = words[commas].str.fullmatch(_THOUSANDS)
    plain = words[words.str.fullmatch(_PLAIN)].astype(float).to_numpy()
    if thousands.all() and not marked(plain, codes).all():
        at = int(np.argmax(commas.to_numpy()))
        said = words.iloc[at].strip()
        text = f"is '{said}', whose comma may part thousands or decimals; write numbers without it"
        raise RecordError([Problem(f"row {rows[at]}, column '{column}'", text)], source)
    return words.where(~commas, words.str.replace(",", "."))
