"""Speeds from a boom over snow, whose height above the surface changes row by row, brought to 10 m."""

import numpy as np
from numpy.typing import NDArray

from barchan.aeolian.wall import REFERENCE_HEIGHT
from barchan.errors import Problem, RecordError
from barchan.wind.records.format import RecordFormat
from barchan.words import counted

BOOMS = {
    "wspd_u": "z_boom_u",
    "wspd_l": "z_boom_l",
    "wspd_i": "z_boom_i",
    "VW1": "HW1",
    "VW2": "HW2",
}
"""Columns of speeds whose stations report the height of the sensor in another: PROMICE and GC-Net."""

BURIED = 0.2
"""Height (m) of a boom below which it stands in drift and rime, and its speeds are no wind."""

TALLEST = 20.0
"""Height (m) that no boom of these stations has."""

ROUGHNESS = 2.4e-4
"""Roughness length (m) of snow over which speeds are brought to 10 m: that of the model of snow."""


def boom_of(speed: str, columns: list[str], form: RecordFormat, source: str) -> str | None:
    """The column of the boom's height for a column of speeds; None where the height is stated or not known.

    Raises RecordError where the user states one that is not there, or a height as well.
    """
    if form.boom_height is None:
        known = BOOMS.get(speed)
        return known if form.height is None and known in columns else None
    if form.height is not None:
        message = f"is '{form.boom_height}', and height is {form.height:g} m; allowed: one of them"
        raise RecordError([Problem("boom_height", message)], source)
    if form.boom_height not in columns:
        message = f"no column '{form.boom_height}'; the columns are {', '.join(columns)}"
        raise RecordError([Problem("boom_height", message)], source)
    return form.boom_height


def brought_to_ten_metres(
    speed: NDArray[np.float64],
    heights: NDArray[np.float64],
    name: str,
    numbers: NDArray[np.int64],
    source: str,
) -> tuple[NDArray[np.float64], str]:
    """Speeds (m/s) at 10 m by the law of the wall, from those at the boom's ``heights`` (m), and a remark.

    A height that is missing is that between its neighbours. A buried boom has no wind (NaN). Raises
    RecordError for a height that no boom has, or where there is none at all.
    """
    wrong = (heights < 0.0) | (heights > TALLEST)
    if wrong.any():
        row = int(np.argmax(wrong))
        message = f"is {heights[row]:g} m; allowed: 0 to {TALLEST:g} m"
        raise RecordError([Problem(f"row {numbers[row]}, column '{name}'", message)], source)
    known = np.isfinite(heights)
    if not known.any():
        message = "holds no height of the wind; state it as height"
        raise RecordError([Problem(f"column '{name}'", message)], source)
    rows = np.arange(len(heights))
    tall = np.interp(rows, rows[known], heights[known])
    buried = tall < BURIED
    factor = np.log(REFERENCE_HEIGHT / ROUGHNESS) / np.log(np.maximum(tall, BURIED) / ROUGHNESS)
    told = (
        f"speeds are brought to {REFERENCE_HEIGHT:g} m from the height of the boom in each row ('{name}', "
        f"{tall.min():.3g} to {tall.max():.3g} m), over a roughness of {ROUGHNESS:g} m"
    )
    if not known.all():
        some = counted(int(np.count_nonzero(~known)), "row")
        told += f"; in {some} the height is missing and taken between its neighbours"
    if buried.any():
        some = counted(int(np.count_nonzero(buried)), "row")
        told += f"; in {some} with the boom below {BURIED:g} m there is no wind"
    return np.where(buried, np.nan, speed * factor), told
